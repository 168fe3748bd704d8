// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "core/vector.h"

namespace sherd {

/// A new element of a shell, and its parents: the elements before the change whose data it inherits.
struct IndexWithParents {
    struct Parent {
        Index element;
        double weight;
    };
    Index element;
    std::vector<Parent> parents;  ///< their weights sum to 1; if empty, data start from defaults
};

/// An edge that opens with a change of the shell.
struct Opening {
    Index edge;
    double energy;  ///< J, total energy that the opening dissipates
    double time;    ///< s, time in which a tip passes the edge at the speed limit
};

/// A change of the shell's mesh. New elements are appended in the order given here; hinges are removed, then
/// appended. Parents are elements before the change, with the data that they had then. Where a crack opens,
/// only the vertex numbers at corners of faces change; members from `moved` on describe changes of triangles
/// (remeshing).
struct ShellChange {
    std::vector<IndexWithParents> vertices = {}, edges = {}, faces = {};
    /// Removed hinges, in the order of removal, each with its number at that time: the last hinge then took
    /// the number of the removed one.
    std::vector<Index> removed_hinges = {};
    /// Opening of the edge whose hinge was removed, if its crack requires energy.
    std::optional<Opening> opening = {};

    /// Old vertices that have been moved to another place of the sheet; their parents lay around this place.
    std::vector<IndexWithParents> moved = {};
    /// An old face that covers another part of the sheet, or has other corners.
    struct ChangedFace {
        Index face;
        std::array<Index, 3> vertices;  ///< corners before the change
    };
    std::vector<ChangedFace> changed = {};  ///< ascending
    /// Changed and inserted faces, ascending. Parents are the changed faces from which a face inherits; a
    /// weight is the fraction of the parent's area and mass that the face inherits, the largest fraction
    /// first. The fractions of one parent sum to 1.
    std::vector<IndexWithParents> reshaped = {};
    /// An edge across old faces: flipped, or inserted inside a face.
    struct CrossingEdge {
        Index edge;
        std::vector<Index> around;  ///< old edges of the old faces, each once
    };
    std::vector<CrossingEdge> crossing = {};
    /// Hinges with other vertices or another rest shape, ascending; new hinges were appended.
    std::vector<Index> reshaped_hinges = {};
    struct Weight {
        Index vertex;
        double mass;  ///< kg, before the change
    };
    std::vector<Weight> weights = {};  ///< masses of the old corners of changed faces, ascending

    /// Whether triangles change (remeshing); if not, edges open.
    bool remeshes() const { return !reshaped.empty() || !moved.empty(); }
};

/// Removes the entry `hinge` of a list as hinges are removed: the last entry takes its place.
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

/// Removes the entries of removed hinges, and sets the entries of reshaped and appended hinges to
/// make(hinge).
template <class T, class Make>
void follow_hinges(const ShellChange& change, std::vector<T>& of_hinges, const Make& make) {
    follow_hinges(change, of_hinges);
    for (const Index hinge : change.reshaped_hinges)
        if (hinge < static_cast<Index>(of_hinges.size()))
            of_hinges[hinge] = make(hinge);
        else
            of_hinges.push_back(make(hinge));
}

/// The entry of a changed face; null if the face has not changed.
inline const ShellChange::ChangedFace* changed_face(const ShellChange& change, Index face) {
    const auto at = std::ranges::lower_bound(change.changed, face, {}, &ShellChange::ChangedFace::face);
    return at != change.changed.end() && at->face == face ? &*at : nullptr;
}

/// Appends to a list of faces the inserted faces whose first parent is in the list. If no change moves the
/// edges on the border of the listed faces, they cover the same part of the sheet as before.
inline void follow_faces(const ShellChange& change, std::vector<Index>& faces) {
    for (const auto& [face, parents] : change.faces)
        if (!parents.empty() && std::find(faces.begin(), faces.end(), parents.front().element) != faces.end())
            faces.push_back(face);
}

}  // namespace sherd
