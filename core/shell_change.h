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
    double energy;  ///< J, that it takes in all
    double time;    ///< s, in which the tip passes it at its speed limit
};

/// A change of the shell's mesh. New elements are appended in the order given here; hinges are removed, then
/// appended. Parents are elements before the change, with the data that they had then. A crack that opens
/// changes nothing but the numbers of corners; what is below `moved` says what changes where the sheet gets
/// other triangles.
struct ShellChange {
    std::vector<Heir> vertices = {}, edges = {}, faces = {};
    /// Removed hinges, in the order of removal, each with its number at that time: the last hinge then took
    /// the number of the removed one.
    std::vector<Index> removed_hinges = {};
    /// Of the hinge that was removed, where its crack needs energy.
    std::optional<Opening> opening = {};

    /// Old vertices that are at another place of the sheet: their parents lay around it.
    std::vector<Heir> moved = {};
    /// An old face that covers another part of the sheet, or has other corners.
    struct ChangedFace {
        Index face;
        std::array<Index, 3> vertices;  ///< as they were
    };
    std::vector<ChangedFace> changed = {};  ///< ascending
    /// Those and the born ones, ascending, each with the changed faces that have passed a part on to it and
    /// the fraction of their area and mass: the largest part first. The fractions of a face sum to 1.
    std::vector<Heir> reshaped = {};
    /// Hinges with other vertices or another rest shape, ascending; those that are new were appended.
    std::vector<Index> reshaped_hinges = {};
    struct Weight {
        Index vertex;
        double mass;  ///< kg, as it was
    };
    std::vector<Weight> weights = {};  ///< of the old corners of changed faces, ascending

    /// Whether the sheet gets other triangles; else edges open.
    bool remeshes() const { return !reshaped.empty() || !moved.empty(); }
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

/// The same, and makes the entries of reshaped and appended hinges anew: make(hinge).
template <class T, class Make>
void follow_hinges(const ShellChange& change, std::vector<T>& of_hinges, const Make& make) {
    follow_hinges(change, of_hinges);
    for (const Index hinge : change.reshaped_hinges)
        if (hinge < static_cast<Index>(of_hinges.size()))
            of_hinges[hinge] = make(hinge);
        else
            of_hinges.push_back(make(hinge));
}

/// The entry of a face that has changed; null: it has not.
inline const ShellChange::ChangedFace* changed_face(const ShellChange& change, Index face) {
    const auto at = std::ranges::lower_bound(change.changed, face, {}, &ShellChange::ChangedFace::face);
    return at != change.changed.end() && at->face == face ? &*at : nullptr;
}

/// Appends the born faces whose first parent is in a list of faces to it. Where the list's border is made of
/// edges that no change moves, it covers the same part of the sheet as before.
inline void follow_faces(const ShellChange& change, std::vector<Index>& faces) {
    for (const auto& [face, parents] : change.faces)
        if (!parents.empty() && std::find(faces.begin(), faces.end(), parents.front().element) != faces.end())
            faces.push_back(face);
}

}  // namespace sherd
