// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/recording/recording.h"
#include "app/scene/scene.h"
#include "fracture/step/simulation.h"

namespace sherd {

/// Returns the header of the recording of a simulation before its first step.
RecordingHeader recording_header(const Scene& scene, const Simulation& simulation);

}  // namespace sherd
