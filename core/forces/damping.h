// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/bending/bending.h"
#include "core/forces/vertex_springs.h"
#include "core/membrane/membrane.h"
#include "core/state_visitor.h"

namespace sherd {

class ArcMembrane;
class CoupledBending;

/// Rayleigh damping, proportional to stiffness and to mass. A mode of angular frequency w has the damping
/// ratio (stiffness w + mass / w) / 2.
struct Damping {
    double stiffness = 0;  ///< s; resists changes of shape
    double mass = 0;       ///< 1/s; resists all motion, rigid motion included, as a viscous medium does
};

/// Stiffness-proportional damping in one implicit step: (coefficient / lag) times the elastic energy of the
/// membrane and of coupled hinges (cubic hinges if the bending model is one of the paper's) of a shell whose
/// rest shape is the step's origin (StepContext). To second order this is Rayleigh's
///     coefficient / (2 lag) (x - origin)^T K (x - origin),
/// where K is the stiffness matrix at that shape without its stresses. An elastic energy exerts neither net
/// force nor net torque in any shape, so that linear and angular momentum are conserved; x^T K x alone
/// conserves linear momentum only.
class StiffnessDamping : public Energy {
  public:
    /// The shell must outlive this object. coefficient: s.
    StiffnessDamping(const Shell& shell, double coefficient, BendingModel model = BendingModel::cubic,
                     MembraneModel membrane = MembraneModel::constant_strain);
    StiffnessDamping(const StiffnessDamping&) = delete;  // the energies refer to `triangles`
    ~StiffnessDamping() override;
    void begin(const StepContext& step) override;
    void topology_changed(const ShellChange& change, const StepContext& step) override;
    double value(const Positions& x) const override;
    double round_off() const override;
    void add_gradient(const Positions& x, Positions& gradient) const override;
    void add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const override;
    Task task() const override { return Task::loads; }
    void add_pattern(std::vector<std::pair<Index, Index>>& pairs) const override;
    void visit_state(StateVisitor& visit) override;

  private:
    void begin_membrane(const Positions& origin, double scale);

    const Shell& shell;
    double coefficient;
    std::vector<TriangleStencil> triangles;
    std::unique_ptr<CoupledBending> coupled;  ///< energy of coupled hinges; null: hinges are not coupled
    std::unique_ptr<ArcMembrane> arcs;        ///< membrane with arcs; null: membrane of constant strain
    std::unique_ptr<Energy> uncoupled, flat;
    const Energy *bending = nullptr, *membrane = nullptr;  ///< the energies in use
};

/// Mass-proportional damping in one implicit step: coefficient / (2 lag) (x - origin)^T M (x - origin).
/// Linear and angular momentum decay at the rate `coefficient`.
class MassDamping : public ElementEnergy<VertexSprings> {
  public:
    /// The shell must outlive this object. coefficient: 1/s.
    MassDamping(const Shell& shell, double coefficient)
        : ElementEnergy({}), shell(shell), coefficient(coefficient) {}
    void begin(const StepContext& step) override {
        per_mass = coefficient / step.lag;
        elements = {per_mass * shell.mass, step.origin};
    }
    double hessian_per_mass() const override { return per_mass; }
    Task task() const override { return Task::loads; }
    void visit_state(StateVisitor& visit) override {
        static_assert(has_only<MassDamping, ElementEnergy<VertexSprings>, decltype(shell),
                               decltype(coefficient), decltype(per_mass)>());
        ElementEnergy::visit_state(visit);
    }

  private:
    const Shell& shell;
    double coefficient;
    double per_mass = 0;  ///< 1/s^2, stiffness of the springs per mass
};

}  // namespace sherd
