// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/contact/colliders/obstacle.h"
#include "core/contact/detection/box_tree.h"
#include "core/state_visitor.h"

namespace sherd {

/// The surface of a collider that a body meets, in the collider's frame. That of one that deforms has two
/// shapes, where a step or a substep begins and where it ends.
class MetSurface {
  public:
    explicit MetSurface(const Collider& collider);
    /// Of an obstacle, which may deform.
    explicit MetSurface(const Obstacle& obstacle);

    const ColliderSurface& surface() const { return *of; }
    bool deforms() const { return deformation != nullptr; }
    /// m, [3, P]; at_start: where the step begins.
    const Positions& points(bool at_start) const { return !deforms() ? of->points : at_start ? before : now; }
    /// Where all points of both shapes are.
    const Box& bounds() const { return around; }
    /// The step goes on from where it was to `time` (s).
    void move_to(double time);
    /// m, [3, P], from its shape at the end of the step to that of `time` (s); without columns if it is
    /// rigid.
    Positions way_to(double time) const;
    /// m, that no point moves farther than in the step.
    double longest_way() const;

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
