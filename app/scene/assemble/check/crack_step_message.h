// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <string>

#include "app/scene/scene.h"
#include "fracture/shell/breakable_shell.h"

namespace sherd {

/// Returns a step (s) rounded down to one significant digit, to be written into a scene.
inline double round_step(double longest) {
    const double digit = std::pow(10.0, std::floor(std::log10(longest)));
    return std::floor(longest / digit + 1e-9) * digit;
}

/// Returns a message on the number of edges by which a crack may grow in a step of the scene if a toughness
/// governs its growth, and on the step at which it grows edge by edge (resolving_step()). Returns "" in
/// statics, without a toughness, and if explicit steps are short enough.
std::string crack_step_message(const Scene& scene, const BreakableShell& sheets);

}  // namespace sherd
