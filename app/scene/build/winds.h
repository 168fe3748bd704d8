// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene.h"
#include "fracture/simulation.h"

namespace sherd {

/// Returns waves that add up to gusts of the size that is given, which the wind carries along. The same seed
/// gives the same bits. Each component of the sum is nearly Gaussian at any place and time. The sum has no
/// divergence, as the velocity of incompressible air has none.
std::vector<GustWave> gust_waves(const GustSpec& gust, const Vector3d& wind, std::int64_t seed);

/// Adds the scene's winds to the options. `mechanics` is that of all inputs.
void add_winds(const Scene& scene, const Shell& mechanics, SimulationOptions& options);

}  // namespace sherd
