// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <string>

#include "app/scene/scene.h"
#include "fracture/shell/breakable_shell.h"

namespace sherd {

/// Rounds a step (s) down to one significant digit, to be written into a scene.
inline double round_step(double longest) {
    const double digit = std::pow(10.0, std::floor(std::log10(longest)));
    return std::floor(longest / digit + 1e-9) * digit;
}

/// Message on how far cracks by toughness may propagate in a step of the scene, and on the step that resolves
/// them edge by edge (resolving_step()). Empty in statics, without a toughness, and where explicit steps are
/// short enough.
std::string crack_step_message(const Scene& scene, const BreakableShell& sheets);

}  // namespace sherd
