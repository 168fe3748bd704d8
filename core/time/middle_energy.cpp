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
    const StepContext half = first_half(step);
    for (Energy* part : parts) part->begin(half);
}

void MiddleEnergy::topology_changed(const ShellChange& change, const StepContext& step) {
    const StepContext half = first_half(step);
    for (Energy* part : parts) part->topology_changed(change, half);
}

void MiddleEnergy::moved_to(const Positions& x) {
    const Positions at = middle(x);
    for (Energy* part : parts) part->moved_to(at);
}

double MiddleEnergy::value(const Positions& x) const {
    const Positions at = middle(x);
    double sum = 0;
    for (const Energy* part : parts) sum += 2 * part->value(at);
    return sum;
}

double MiddleEnergy::round_off() const {
    double sum = 0;
    for (const Energy* part : parts) sum += 2 * part->round_off();
    return sum;
}

void MiddleEnergy::add_gradient(const Positions& x, Positions& gradient) const {
    const Positions at = middle(x);
    for (const Energy* part : parts) part->add_gradient(at, gradient);
}

void MiddleEnergy::add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const {
    const Positions at = middle(x);
    const std::vector<double> before(hessian.values().begin(), hessian.values().end());
    for (const Energy* part : parts) part->add_hessian(at, curvature, hessian);
    const std::vector<double> after(hessian.values().begin(), hessian.values().end());
    hessian.blend(before, after, 0.5);
}

void MiddleEnergy::add_pattern(std::vector<std::pair<Index, Index>>& pairs) const {
    for (const Energy* part : parts) part->add_pattern(pairs);
}

}  // namespace sherd
