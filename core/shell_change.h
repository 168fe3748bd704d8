// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/vector.h"

namespace sherd {

/// What a crack changed in a shell: vertices are appended, hinges are removed.
struct ShellChange {
    /// A vertex that was appended, with the one whose data it took over.
    struct BornVertex {
        Index parent, vertex;
    };
    std::vector<BornVertex> vertices;  ///< in the order in which they were appended
    /// In the order in which they were removed, each numbered as it was then: the last hinge then took the
    /// number of the one that was removed.
    std::vector<Index> removed_hinges;
};

/// Removes from a list with an entry for each hinge what belongs to hinges that a change has removed.
template <class T>
void follow_hinges(const ShellChange& change, std::vector<T>& of_hinges) {
    for (const Index hinge : change.removed_hinges) {
        of_hinges[hinge] = of_hinges.back();
        of_hinges.pop_back();
    }
}

}  // namespace sherd
