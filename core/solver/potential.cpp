// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solver/potential.h"

#include <algorithm>

#include "core/shell/supports.h"

namespace sherd {

template <class Action>
void Potential::each(const Action& action) const {
    for (Energy* energy : energies) {
        const Stopwatch watch(spent, energy->task());
        action(*energy);
    }
}

void Potential::begin(const StepContext& step) {
    each([&](Energy& energy) { energy.begin(step); });
}

void Potential::topology_changed(const ShellChange& change, const StepContext& step) {
    each([&](Energy& energy) { energy.topology_changed(change, step); });
}

void Potential::moved_to(const Positions& x) {
    each([&](Energy& energy) { energy.moved_to(x); });
}

double Potential::value(const Positions& x) const {
    double sum = 0;
    each([&](const Energy& energy) { sum += energy.value(x); });
    return sum;
}

double Potential::round_off() const {
    double sum = 0;
    each([&](const Energy& energy) { sum += energy.round_off(); });
    return sum;
}

double Potential::hessian_per_mass() const {
    double sum = 0;
    each([&](const Energy& energy) { sum += energy.hessian_per_mass(); });
    return sum;
}

Positions Potential::gradient(const Positions& x) const {
    Positions sum = gradient_with_blocked(x);
    constrain(shell, sum);
    return sum;
}

Positions Potential::gradient_with_blocked(const Positions& x) const {
    Positions sum = Positions::Zero(3, x.cols());
    each([&](const Energy& energy) { energy.add_gradient(x, sum); });
    return sum;
}

Positions Potential::contact_gradient(const Positions& x) const {
    Positions sum = Positions::Zero(3, x.cols());
    each([&](const Energy& energy) {
        if (energy.task() == Task::contact) energy.add_gradient(x, sum);
    });
    return sum;
}

std::vector<std::pair<Index, Index>> Potential::pattern() const {
    std::vector<std::pair<Index, Index>> pairs;
    each([&](const Energy& energy) { energy.add_pattern(pairs); });
    return pairs;
}

BlockMatrix Potential::hessian_pattern(const Positions& x) const {
    std::vector<std::pair<Index, Index>> pairs = pattern();
    each([&](const Energy& energy) { energy.add_contacts(x, true, pairs); });
    return BlockMatrix(static_cast<Index>(shell.mass.size()), pairs, shell.fixed, shell.guide, shell.guides);
}

std::vector<Matrix3d> Potential::contact_stiffness(const Positions& x) const {
    BlockMatrix stiffness = BlockMatrix::diagonal(static_cast<Index>(x.cols()));
    contact_hessian(x, Curvature::exact, stiffness);
    std::vector<Matrix3d> blocks;
    for (Index v = 0; v < static_cast<Index>(x.cols()); ++v) blocks.push_back(stiffness.diagonal_block(v));
    return blocks;
}

std::vector<std::pair<Index, Index>> Potential::contacts(const Positions& x) const {
    std::vector<std::pair<Index, Index>> pairs;
    each([&](const Energy& energy) { energy.add_contacts(x, false, pairs); });
    return pairs;
}

double Potential::safe_fraction(const Positions& x, const Positions& motion) const {
    double fraction = 1;
    each([&](const Energy& energy) { fraction = std::min(fraction, energy.safe_fraction(x, motion)); });
    return fraction;
}

void Potential::hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const {
    hessian.set_zero();
    hessian.share_among(threads);
    each([&](const Energy& energy) { energy.add_hessian(x, curvature, hessian); });
}

void Potential::contact_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const {
    hessian.set_zero();
    hessian.share_among(threads);
    each([&](const Energy& energy) {
        if (energy.task() == Task::contact) energy.add_hessian(x, curvature, hessian);
    });
}

}  // namespace sherd
