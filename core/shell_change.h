// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "core/vector.h"

namespace sherd {

/// A new element of a shell, and its parents: the elements before the change whose data it inherits.
struct Heir {
    struct Parent {
        Index element;
        double weight;
    };
    Index element;
    std::vector<Parent> parents;  ///< their weights sum to 1; without any, data start from defaults
};

/// An edge that opens with a change of the shell.
struct Opening {
    Index edge;
    double energy;   ///< J, that it takes in all
    double longest;  ///< s, after which nothing holds it any more
};

/// A change of the shell's mesh. New elements are appended in the order given here; hinges are removed.
struct ShellChange {
    std::vector<Heir> vertices = {}, edges = {}, faces = {};
    /// Removed hinges, in the order of removal, each with its number at that time: the last hinge then took
    /// the number of the removed one.
    std::vector<Index> removed_hinges = {};
    /// Of the hinge that was removed, where it opens gradually: explicit steps only.
    std::optional<Opening> opening = {};
};

/// Removes the entry `hinge` of a list in the way hinges are removed: the last entry takes its place.
template <class T>
void remove_hinge(std::vector<T>& of_hinges, Index hinge) {
    of_hinges[hinge] = of_hinges.back();
    of_hinges.pop_back();
}

/// Removes the entries of removed hinges from a list with an entry for each hinge.
template <class T>
void follow_hinges(const ShellChange& change, std::vector<T>& of_hinges) {
    for (const Index hinge : change.removed_hinges) remove_hinge(of_hinges, hinge);
}

/// Appends the born faces whose first parent is in a list of faces to it.
inline void follow_faces(const ShellChange& change, std::vector<Index>& faces) {
    for (const auto& [face, parents] : change.faces)
        if (!parents.empty() && std::find(faces.begin(), faces.end(), parents.front().element) != faces.end())
            faces.push_back(face);
}

}  // namespace sherd
