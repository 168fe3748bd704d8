// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time/middle_energy.h"

namespace sherd {
namespace {

/// The step up to its middle, where what moves as it is told then is.
StepContext first_half(StepContext step) {
    step.length /= 2;
    return step;
}

}  // namespace

void MiddleEnergy::begin(const StepContext& step) {
    energy.begin(first_half(step));
}

void MiddleEnergy::topology_changed(const ShellChange& change, const StepContext& step) {
    energy.topology_changed(change, first_half(step));
}

void MiddleEnergy::moved_to(const Positions& x) {
    energy.moved_to(middle(x));
}

double MiddleEnergy::value(const Positions& x) const {
    return 2 * energy.value(middle(x));
}

double MiddleEnergy::round_off() const {
    return 2 * energy.round_off();
}

void MiddleEnergy::add_gradient(const Positions& x, Positions& gradient) const {
    energy.add_gradient(middle(x), gradient);
}

void MiddleEnergy::add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const {
    const std::vector<double> before(hessian.values().begin(), hessian.values().end());
    energy.add_hessian(middle(x), curvature, hessian);
    const std::vector<double> after(hessian.values().begin(), hessian.values().end());
    hessian.blend(before, after, 0.5);
}

void MiddleEnergy::add_pattern(std::vector<std::pair<Index, Index>>& pairs) const {
    energy.add_pattern(pairs);
}

}  // namespace sherd
