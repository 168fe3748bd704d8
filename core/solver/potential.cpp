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

template <class Action>
void Potential::each(const Positions& x, const Action& action) const {
    if (body_masses.empty()) return each([&](Energy& energy) { action(energy, x); });
    const Positions of_shell = x.leftCols(shell.mass.size());
    each([&](Energy& energy) { action(energy, energy.has_bodies() ? x : of_shell); });
}

void Potential::begin(const StepContext& step) {
    each([&](Energy& energy) { energy.begin(step); });
}

void Potential::topology_changed(const ShellChange& change, const StepContext& step) {
    each([&](Energy& energy) { energy.topology_changed(change, step); });
}

double Potential::value(const Positions& x) const {
    double sum = 0;
    each(x, [&](const Energy& energy, const Positions& own) { sum += energy.value(own); });
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
    return sum_of_gradients(x, false);
}

Positions Potential::contact_gradient(const Positions& x) const {
    return sum_of_gradients(x, true);
}

Positions Potential::sum_of_gradients(const Positions& x, bool of_contact) const {
    Positions sum = Positions::Zero(3, shell.mass.size()), with_bodies;
    if (!body_masses.empty()) with_bodies = Positions::Zero(3, x.cols());
    each(x, [&](const Energy& energy, const Positions& own) {
        if (!of_contact || energy.task() == Task::contact)
            energy.add_gradient(own, energy.has_bodies() ? with_bodies : sum);
    });
    if (body_masses.empty()) return sum;
    with_bodies.leftCols(sum.cols()) += sum;
    return with_bodies;
}

VectorXd Potential::masses() const {
    VectorXd all(shell.mass.size() + body_columns());
    all.head(shell.mass.size()) = shell.mass;
    for (std::size_t b = 0; b < body_masses.size(); ++b)
        all.segment<2>(shell.mass.size() + static_cast<Eigen::Index>(2 * b)) << body_masses[b], 0;
    return all;
}

std::vector<std::pair<Index, Index>> Potential::pattern() const {
    std::vector<std::pair<Index, Index>> pairs;
    each([&](const Energy& energy) { energy.add_pattern(pairs); });
    return pairs;
}

BlockMatrix Potential::hessian_pattern(const Positions& x) const {
    std::vector<std::pair<Index, Index>> pairs = pattern();
    each(x, [&](const Energy& energy, const Positions& own) { energy.add_contacts(own, true, pairs); });
    return BlockMatrix(static_cast<Index>(x.cols()), pairs, shell.fixed, shell.guide, shell.guides);
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
    each(x, [&](const Energy& energy, const Positions& own) { energy.add_contacts(own, false, pairs); });
    return pairs;
}

double Potential::safe_fraction(const Positions& x, const Positions& motion) const {
    double fraction = 1;
    const Positions of_shell = motion.leftCols(shell.mass.size());
    each(x, [&](const Energy& energy, const Positions& own) {
        fraction = std::min(fraction, energy.safe_fraction(own, energy.has_bodies() ? motion : of_shell));
    });
    return fraction;
}

void Potential::hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const {
    hessian.set_zero();
    hessian.share_among(threads);
    each(x, [&](const Energy& energy, const Positions& own) { energy.add_hessian(own, curvature, hessian); });
}

void Potential::contact_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const {
    hessian.set_zero();
    hessian.share_among(threads);
    each(x, [&](const Energy& energy, const Positions& own) {
        if (energy.task() == Task::contact) energy.add_hessian(own, curvature, hessian);
    });
}

}  // namespace sherd
