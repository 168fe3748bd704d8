// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/contact/colliders/obstacle.h"
#include "core/contact/detection/box_tree.h"
#include "core/state_visitor.h"

namespace sherd {

/// The surface of a collider with which a body collides, in the collider's frame. A deforming surface has two
/// shapes, at the beginning and at the end of a step or a substep.
class OtherSurface {
  public:
    explicit OtherSurface(const Collider& collider);
    /// Surface of an obstacle, which may deform.
    explicit OtherSurface(const Obstacle& obstacle);

    const ColliderSurface& surface() const { return *of; }
    bool deforms() const { return deformation != nullptr; }
    /// Positions of the points, [3, P] m, at the beginning or at the end of the step.
    const Positions& points(bool at_start) const { return !deforms() ? of->points : at_start ? before : now; }
    /// Bounding box of both shapes.
    const Box& bounds() const { return around; }
    /// Makes the end of the last step the beginning of the next one, which ends at `time` (s).
    void move_to(double time);
    /// Displacements of the points, [3, P] m, from the end of the step to `time` (s); no columns if the
    /// surface is rigid.
    Positions displacement_to(double time) const;
    /// Largest displacement of a point in the step, m.
    double largest_displacement() const;

    void visit_state(StateVisitor& visit) {
        auto& [of, deformation, before, now, around] = *this;
        visit(before, now, around);
    }

  private:
    std::shared_ptr<const ColliderSurface> of;
    std::shared_ptr<const Deformation> deformation;  ///< null: it is rigid
    Positions before, now;                           ///< m, [3, P]; empty if it is rigid
    Box around;
};

}  // namespace sherd
