// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/recording/recording.h"
#include "app/scene/scene.h"
#include "fracture/step/simulation.h"

namespace sherd {

/// Returns the header for the recording of a run. The simulation must be that of the scene, and must not have
/// made a step yet.
RecordingHeader recording_header(const Scene& scene, const Simulation& simulation);

}  // namespace sherd
