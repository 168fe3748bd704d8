// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene.h"
#include "fracture/step/simulation.h"

namespace sherd {

/// Returns waves whose sum is a gust of the given size that moves with the wind. wind: m/s, mean velocity of
/// the air. Equal seeds give equal waves, bit for bit. Each component of the sum is nearly Gaussian at any
/// place and time. The sum is free of divergence, like the velocity of incompressible air.
std::vector<GustWave> gust_waves(const GustSpec& gust, const Vector3d& wind, std::int64_t seed);

/// Adds the scene's winds to the options. mechanics: of all inputs.
void add_winds(const Scene& scene, const Shell& mechanics, SimulationOptions& options);

}  // namespace sherd
