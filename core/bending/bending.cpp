// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bending/bending.h"

#include "core/bending/coupled_bending.h"
#include "core/bending/cubic_bending.h"
#include "core/bending/nonlinear_bending.h"

namespace sherd {
namespace {

/// The force of one bending model with the Jacobian of another.
class PairedBending : public Energy {
  public:
    PairedBending(std::unique_ptr<Energy> force, std::unique_ptr<Energy> jacobian)
        : force(std::move(force)), jacobian(std::move(jacobian)) {}
    void topology_changed(const ShellChange& change, const StepContext& step) override {
        force->topology_changed(change, step);
        jacobian->topology_changed(change, step);
    }
    double value(const Positions& x) const override { return force->value(x); }
    double round_off() const override { return force->round_off(); }
    void add_gradient(const Positions& x, Positions& gradient) const override {
        force->add_gradient(x, gradient);
    }
    void add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const override {
        jacobian->add_hessian(x, curvature, hessian);
    }
    void add_pattern(std::vector<std::pair<Index, Index>>& pairs) const override {
        jacobian->add_pattern(pairs);
    }
    const Energy& of_force() const { return *force; }
    void visit_state(StateVisitor& visit) override {
        auto& [force, jacobian] = *this;
        visit(force, jacobian);
    }

  private:
    std::unique_ptr<Energy> force, jacobian;
};

/// The energy of a cubic model. Its Jacobian is the whole Jacobian (BendingJacobian::cubic), or only the
/// Jacobian's constant part.
std::unique_ptr<Energy> cubic_energy(const Shell& shell, BendingModel model, BendingJacobian jacobian) {
    const bool cubic_part = jacobian == BendingJacobian::cubic;
    if (model == BendingModel::cubic_2007)
        return std::make_unique<CubicBending2007>(CubicHinges2007(shell.hinges, shell.rest, cubic_part));
    return std::make_unique<CubicBending>(CubicHinges(shell.hinges, shell.rest, 1, cubic_part));
}

std::unique_ptr<Energy> nonlinear_energy(const Shell& shell) {
    return std::make_unique<NonlinearBending>(NonlinearHinges(shell.hinges, shell.rest));
}

}  // namespace

std::unique_ptr<Energy> bending_energy(const Shell& shell, const BendingOptions& options,
                                       const std::vector<MirrorHinge>& mirrors) {
    const auto& [model, jacobian] = options;
    if (model == BendingModel::coupled) return std::make_unique<CoupledBending>(shell, mirrors);
    const bool nonlinear_force = model == BendingModel::nonlinear,
               nonlinear_jacobian = jacobian == BendingJacobian::nonlinear;
    if (nonlinear_force && nonlinear_jacobian) return nonlinear_energy(shell);
    if (!nonlinear_force && !nonlinear_jacobian) return cubic_energy(shell, model, jacobian);
    if (nonlinear_force)
        return std::make_unique<PairedBending>(nonlinear_energy(shell),
                                               cubic_energy(shell, BendingModel::cubic, jacobian));
    return std::make_unique<PairedBending>(cubic_energy(shell, model, exact_jacobian(model)),
                                           nonlinear_energy(shell));
}

const std::vector<CubicHinge>* cubic_hinges(const Energy& bending) {
    const auto* pair = dynamic_cast<const PairedBending*>(&bending);
    const auto* cubic = dynamic_cast<const CubicBending*>(pair != nullptr ? &pair->of_force() : &bending);
    return cubic != nullptr ? &cubic->all().hinges : nullptr;
}

const CoupledBending* coupled_hinges(const Energy& bending) {
    return dynamic_cast<const CoupledBending*>(&bending);
}

}  // namespace sherd
