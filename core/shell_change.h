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
    std::vector<Parent> parents;  ///< weights sum to 1; without any, data start from defaults
};

/// An edge that opens with a change of the shell.
struct Opening {
    Index edge;
    double energy;  ///< J, total energy that the opening dissipates
    double time;    ///< s, in which the tip passes it at its speed limit
};

/// A change of the shell's mesh. New elements are appended in the order given here; hinges are removed, then
/// appended. Parents are elements before the change, with the data that they had then. A crack that opens
/// only changes the numbers of corners; members from `moved` on describe changes of triangles (remeshing).
struct ShellChange {
    std::vector<IndexWithParents> vertices = {}, edges = {}, faces = {};
    /// Removed hinges, in the order of removal, each with its number at that time: the last hinge then took
    /// the number of the removed one.
    std::vector<Index> removed_hinges = {};
    /// Opening of the edge whose hinge was removed, if its crack requires energy.
    std::optional<Opening> opening = {};

    /// Old vertices that have been moved to another place of the sheet, around which their parents lay.
    std::vector<IndexWithParents> moved = {};
    /// An old face that covers another part of the sheet, or has other corners.
    struct ChangedFace {
        Index face;
        std::array<Index, 3> vertices;  ///< corners before the change
    };
    std::vector<ChangedFace> changed = {};  ///< ascending
    /// Changed and inserted faces, ascending, each with the changed faces of which it inherits a part and the
    /// fraction of their area and mass, the largest fraction first. The fractions of a changed face sum to 1.
    std::vector<IndexWithParents> reshaped = {};
    /// An edge across old faces: flipped, or inserted inside a face.
    struct CrossingEdge {
        Index edge;
        std::vector<Index> around;  ///< the old edges of these faces, each once
    };
    std::vector<CrossingEdge> crossing = {};
    /// Hinges with other vertices or another rest shape, ascending; new hinges were appended.
    std::vector<Index> reshaped_hinges = {};
    struct Weight {
        Index vertex;
        double mass;  ///< kg, before the change
    };
    std::vector<Weight> weights = {};  ///< masses of the old corners of changed faces, ascending

    /// Whether triangles change (remeshing); otherwise edges open.
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

/// Removes the entries of removed hinges, and sets those of reshaped and appended hinges: make(hinge).
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

/// Appends the inserted faces whose first parent is in a list of faces to it. If the list's border consists
/// of edges that no change moves, the list covers the same part of the sheet as before.
inline void follow_faces(const ShellChange& change, std::vector<Index>& faces) {
    for (const auto& [face, parents] : change.faces)
        if (!parents.empty() && std::find(faces.begin(), faces.end(), parents.front().element) != faces.end())
            faces.push_back(face);
}

}  // namespace sherd
