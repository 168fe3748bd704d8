// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incremental_potential.h"

#include <algorithm>

namespace sherd {

IncrementalPotential::IncrementalPotential(const Sheet& sheet, std::vector<const Energy*> energies,
                                           double step, const Vector3d& gravity, TimeSpent& spent, double end)
    : sheet(sheet), energies(std::move(energies)), step(step), spent(spent) {
    Positions displacement = step * sheet.velocity;
    displacement.colwise() += step * step * gravity;
    constrain(displacement);
    inertial = sheet.position + displacement;
    carry(end);
}

void IncrementalPotential::carry(double end) {
    std::vector<Eigen::Isometry3d> poses;
    for (const Motion& motion : sheet.motions) poses.push_back(motion.at(end));
    for (std::size_t v = 0; v < sheet.carrier.size(); ++v)
        if (sheet.carrier[v] != 0)
            inertial.col(v) = poses[sheet.carrier[v] - 1] * Vector3d(sheet.rest.col(v));
}

void IncrementalPotential::constrain(Positions& displacement) const {
    for (std::size_t v = 0; v < sheet.fixed.size(); ++v) {
        if (sheet.fixed[v])
            displacement.col(v).setZero();
        else if (sheet.guide[v] != 0)
            displacement.col(v) = sheet.guides[sheet.guide[v] - 1] * displacement.col(v).eval();
    }
}

template <class Action>
void IncrementalPotential::each(const Action& action) const {
    for (const Energy* energy : energies) {
        const Stopwatch watch(spent, energy->task());
        action(*energy);
    }
}

double IncrementalPotential::value(const Positions& x) const {
    double sum = 0.5 / (step * step) * sheet.mass.dot((x - inertial).colwise().squaredNorm().transpose());
    each([&](const Energy& energy) { sum += energy.value(x); });
    return sum;
}

double IncrementalPotential::round_off() const {
    double sum = 0;
    each([&](const Energy& energy) { sum += energy.round_off(); });
    return sum;
}

Positions IncrementalPotential::gradient(const Positions& x) const {
    Positions sum = (x - inertial) * (sheet.mass / (step * step)).asDiagonal();
    each([&](const Energy& energy) { energy.add_gradient(x, sum); });
    constrain(sum);
    return sum;
}

BlockMatrix IncrementalPotential::hessian_pattern(const Positions& x) const {
    std::vector<std::pair<Index, Index>> pairs;
    each([&](const Energy& energy) {
        energy.add_pattern(pairs);
        energy.add_contacts(x, true, pairs);
    });
    return BlockMatrix(static_cast<Index>(sheet.mass.size()), std::move(pairs), sheet.fixed, sheet.guide,
                       sheet.guides);
}

bool IncrementalPotential::fits(const Positions& x, const BlockMatrix& hessian) const {
    std::vector<std::pair<Index, Index>> pairs;
    each([&](const Energy& energy) { energy.add_contacts(x, false, pairs); });
    if (pairs.empty()) return true;
    const Stopwatch watch(spent, Task::contact);
    return std::all_of(pairs.begin(), pairs.end(),
                       [&](const auto& pair) { return hessian.has(pair.first, pair.second); });
}

double IncrementalPotential::safe_fraction(const Positions& x, const Positions& motion) const {
    double fraction = 1;
    each([&](const Energy& energy) { fraction = std::min(fraction, energy.safe_fraction(x, motion)); });
    return fraction;
}

void IncrementalPotential::hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const {
    hessian.set_zero();
    for (Index v = 0; v < static_cast<Index>(sheet.mass.size()); ++v)
        hessian.add(v, v, sheet.mass[v] / (step * step) * Matrix3d::Identity());
    each([&](const Energy& energy) { energy.add_hessian(x, curvature, hessian); });
}

}  // namespace sherd
