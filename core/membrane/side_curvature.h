// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/bending/patches.h"
#include "core/state_visitor.h"

namespace sherd {

/// The curvature of a shell along the sides of its triangles, from the angles of the folds around: the
/// curvature of the quadratic surface that fits the angles of the folds in the side's patch best (least
/// squares). Both triangles at an edge have the same curvature. Folds that are turned by more than 45 degrees
/// at rest are creases between smooth parts: each part is measured by itself.
class SideCurvature {
  public:
    /// Shell and folds must outlive this object.
    SideCurvature(const Shell& shell, const Folds& folds);

    /// Must be called when the shell has changed. Only sides whose patch contains a part of the change are
    /// computed again.
    void follow(const ShellChange& change);

    /// Folds with their weights, 1/m: the curvature along a side is the sum of these weights times the folds'
    /// angles.
    std::span<const Patches::Share> shares(std::size_t face, int side) const { return sides[face][side]; }
    /// The curvature along the sides of a face, [3] 1/m. angles: angles of all folds, rad.
    Vector3d of(std::size_t face, const VectorXd& angles) const;

    void visit_state(StateVisitor& visit) {
        auto& [shell, folds, patches, sides] = *this;
        visit(patches, sides);
    }

  private:
    void update(Index face, int side);

    const Shell& shell;
    const Folds& folds;
    Patches patches;
    std::vector<std::array<std::vector<Patches::Share>, 3>> sides;  ///< [F] terms of each side
};

}  // namespace sherd
