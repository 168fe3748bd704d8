// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/colliders/obstacle.h"
#include "core/contact/penalty/vertex_contact.h"
#include "core/reaction.h"
#include "core/state_visitor.h"

namespace sherd {

/// Contact of the shell's vertices with an obstacle in one step (see VertexContact). Springs use the
/// obstacle's pose at the end of the step.
class ObstacleContact : public Energy {
  public:
    /// Shell and obstacle must outlive this object. number: the obstacle's number in Shell::start_depths.
    ObstacleContact(const Shell& shell, const Obstacle& obstacle, std::size_t number = 0)
        : shell(shell), obstacle(obstacle), contact(shell, obstacle, number) {}
    void begin(const StepContext& step) override;
    void finish(const Positions& x) { contact.store_slip(x, Eigen::Isometry3d::Identity(), elastic_slip); }
    double value(const Positions& x) const override;  ///< J, includes the friction potential
    void add_gradient(const Positions& x, Positions& gradient) const override;
    void add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const override;
    Task task() const override { return Task::contact; }

    /// Elastic energy stored in the contacts, J: with the shell at x at the end of the step, and at the
    /// beginning of the step.
    double stored_energy(const Positions& x) const { return stored_energy(x, pose); }
    double stored_at_start() const { return stored_energy(shell.position, before); }
    /// Energy dissipated by friction in the step that ends at x, J.
    double friction_loss(const Positions& x) const;
    /// Adds the obstacle's forces on the shell at x.
    void add_reaction(const Positions& x, Reaction& reaction) const;
    void add_touch(const Positions& x, Touch& touch) const { contact.add_touch(x, pose, touch); }

    void visit_state(StateVisitor& visit) override {
        auto& [shell, obstacle, contact, elastic_slip, before, pose] = *this;
        visit(contact, elastic_slip, before, pose);
    }

  private:
    double stored_energy(const Positions& x, const Eigen::Isometry3d& there) const;
    /// Calls add(vertex, force) for each force on a vertex; force: a PointForce.
    template <class Add>
    void each_force(const Positions& x, Curvature curvature, Add add) const;

    const Shell& shell;
    const Obstacle& obstacle;
    /// Anchors (SlidingPoint) in space, moved with the obstacle to the end of the step.
    VertexContact contact;
    StickMemory<Index> elastic_slip;  ///< elastic slip at the end of the last finished step
    Eigen::Isometry3d before, pose;   ///< poses of the obstacle at the beginning and at the end of the step
};

}  // namespace sherd
