// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <span>

#include "core/bending/folds.h"
#include "core/elements/mid_edge.h"
#include "core/state_visitor.h"

namespace sherd {

/// Upper bound on the curvature, 1/m, that SideCurvature finds along a side of this length (m) if no fold is
/// turned by more than `angle` (rad). Most sheets are so flat that a check of this bound suffices.
double most_side_curvature(double length, double angle);

/// Patches of triangles around sides, each unfolded into a plane, and the weights with which the angles of a
/// patch's folds give the sheet's curvature at its side. A patch has the triangles on both sides of its side,
/// and their neighbours if these triangles alone hardly distinguish curvatures. The weights depend only on
/// the rest shape and on which hinges have not failed.
class Patches {
  public:
    /// Weight of a fold's angle in a sum over a patch.
    struct Share {
        Index fold;
        double weight;
    };
    /// Effect of a change of the shell on sums over patches.
    struct Change {
        Index first_edge;          ///< number of edge 0 among folds, before the change
        Index more_mirrors;        ///< number of new mirrors, by which the numbers of edges grow
        std::vector<Index> faces;  ///< faces with another shape, or other folds at their sides, ascending
        /// [folds] 1: every sum in which the fold has a share must be computed again.
        std::vector<char> folds;

        /// Number after the change of the fold that had the number `fold` before.
        Index now(Index fold) const { return fold < first_edge ? fold : fold + more_mirrors; }
        bool concerns(std::span<const Share> sum) const {
            return std::ranges::any_of(sum, [this](const Share& share) { return folds[share.fold] != 0; });
        }
    };

    /// Shell and folds must outlive this object. At folds that are turned by more than `sharpest` (rad) at
    /// rest, patches end as they do at free sides.
    Patches(const Shell& shell, const Folds& folds, double sharpest = std::numeric_limits<double>::infinity())
        : shell(shell), folds(folds), sharpest(sharpest) {
        build();
    }

    /// Must be called when the shell has changed, and its folds have followed.
    Change follow(const ShellChange& change);

    const PlaneTriangle& triangle(Index face) const { return triangles[face]; }     ///< at rest
    Index fold_at(Index face, int side) const { return fold_of_side[face][side]; }  ///< -1: free side
    /// The sides that an edge's hinge joins, of T0, then of T1; nothing without a hinge.
    std::optional<std::array<TriangleEdge, 2>> sides_of(Index edge) const;
    double side_length(const TriangleEdge& side) const;  ///< m

    /// Returns the weights with which the angles of the folds in a side's patch sum to target . k on every
    /// surface of constant curvature k with small angles, as far as the patch distinguishes curvatures. Of
    /// all such weights they differ least from `start`: the weight of one fold, with zero for the other
    /// folds; nothing: zero for all folds. target: components 00, 11, 01 in the frame of the side's triangle.
    std::vector<Share> shares(const TriangleEdge& side, const Vector3d& target,
                              std::optional<Share> start = {}) const;

    void visit_state(StateVisitor& visit) {
        auto& [shell, folds, sharpest, first_edge, triangles, fold_of_side, sides_of_edge] = *this;
        visit(first_edge, triangles, fold_of_side, sides_of_edge);
    }

  private:
    /// A triangle of a patch, and the angle (rad) of its rest frame in the frame of the patch's first
    /// triangle, once it is unfolded into that triangle's plane.
    struct Unfolded {
        Index triangle;
        double angle;
    };
    /// Angle of a fold as a linear function of curvature: a tensor, m, in the frame of the patch's first
    /// triangle.
    struct FoldAngle {
        Index fold;
        Vector3d angle;
        int views;  ///< number of the patch's triangles over which `angle` is the mean
    };

    void build();
    void drop_removed(Change& result);
    void reshape(const ShellChange& change, Change& result);
    void enter_mirrors(Change& result);
    void enter_hinges(std::span<const Index> hinges, std::span<const Index> among, Change& result);
    /// Whether patches continue across a fold.
    bool is_smooth(Index fold) const { return std::abs(folds.rest_angle(fold)) <= sharpest; }
    void enter(Index fold, const TriangleEdge& side, Change& result);
    void touch(Index face, Change& result) const;

    Unfolded across(const Unfolded& from, int side) const;
    std::vector<Unfolded> grown(const std::vector<Unfolded>& patch) const;
    /// Angle of the fold at a side, which must have a fold, as a linear function of curvature, m.
    Vector3d angle_of(const Unfolded& at, int side) const;
    std::vector<FoldAngle> folds_of(const std::vector<Unfolded>& patch) const;

    const Shell& shell;
    const Folds& folds;
    double sharpest;
    Index first_edge = 0;                                    ///< number of edge 0 among folds
    std::vector<PlaneTriangle> triangles;                    ///< [F] triangles at rest
    std::vector<std::array<Index, 3>> fold_of_side;          ///< [F] fold at each side; -1: free side
    std::vector<std::array<TriangleEdge, 2>> sides_of_edge;  ///< [E] sides that the edge's hinge joins
};

}  // namespace sherd
