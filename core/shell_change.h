// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/vector.h"

namespace sherd {

/// An element of a shell that a change made, and those of its kind from before whose data it takes over.
struct Heir {
    struct Parent {
        Index element;
        double weight;
    };
    Index element;
    std::vector<Parent> parents;  ///< weights sum to 1; without any it starts from nothing
};

/// What a change of its mesh made of a shell. What was born is appended in this order; hinges are removed.
struct ShellChange {
    std::vector<Heir> vertices = {}, edges = {}, faces = {};
    /// In the order in which they were removed, each numbered as it was then: the last hinge then took the
    /// number of the one that was removed.
    std::vector<Index> removed_hinges = {};
};

/// Removes the entry `hinge` of a list as hinges are removed.
template <class T>
void remove_hinge(std::vector<T>& of_hinges, Index hinge) {
    of_hinges[hinge] = of_hinges.back();
    of_hinges.pop_back();
}

/// Removes from a list with an entry for each hinge what belongs to hinges that a change has removed.
template <class T>
void follow_hinges(const ShellChange& change, std::vector<T>& of_hinges) {
    for (const Index hinge : change.removed_hinges) remove_hinge(of_hinges, hinge);
}

}  // namespace sherd
