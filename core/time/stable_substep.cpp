// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time/stable_substep.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace sherd {
namespace {

constexpr double most_substeps = 1e6;  // largest number in a step

}  // namespace

void require_stable(bool is_stable) {
    if (!is_stable)
        throw std::runtime_error(
            "explicit steps have become unstable: a shorter solver.step, softer contact or less load may "
            "help");
}

double stable_substep(double highest, const Damping& damping, double step, double share) {
    const double damped = 0.5 * damping.stiffness * highest;
    // Equals 2 / highest (sqrt(1 + d^2) - d), without its cancellation.
    const double of_forces = 2 / highest / (std::sqrt(1 + damped * damped) + damped);
    // Damping by the medium takes the velocity before the substep; if it changed this velocity by more than
    // twice its size, the velocity would grow.
    const double stable = share * std::min(of_forces, 2 / damping.mass);
    require_stable(!std::isnan(stable));
    if (step < most_substeps * stable) return stable;
    std::ostringstream text;
    text << "explicit steps would need substeps of " << stable
         << " s, more than a million a step: the sheet is too stiff, too light or too damped, or a triangle "
            "is a needle (sherd check warns of such values); correct that, or use implicit steps";
    throw std::runtime_error(text.str());
}

int substeps_of(double duration, double longest) {
    return std::max(1, static_cast<int>(std::ceil(duration / longest - 1e-9)));
}

}  // namespace sherd
