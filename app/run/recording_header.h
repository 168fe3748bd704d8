// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/recording/recording.h"
#include "app/scene/scene.h"
#include "fracture/simulation.h"

namespace sherd {

/// Makes the head of the recording of a simulation that has not made a step yet.
RecordingHeader recording_header(const Scene& scene, const Simulation& simulation);

}  // namespace sherd
