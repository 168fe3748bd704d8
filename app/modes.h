// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/json/json.h"
#include "app/recording/recording.h"
#include "app/scene/scene.h"
#include "core/vibration/vibration.h"
#include "fracture/simulation.h"

namespace sherd {

/// How the sheets of a scene vibrate about the state in which they start.
struct SceneModes {
    Vibration vibration;
    std::vector<double> out_of_plane;   ///< share of each mode's energy along the sheets' normals, 0 to 1
    std::vector<std::string> left_out;  ///< what the scene has and the modes know nothing of, in words
    std::size_t vertices = 0, faces = 0;
};

/// The `count` slowest modes, or as many as the mesh has. simulation: of the scene, before its first step,
/// and its energies. Throws Error (input), naming the scene, when its supports leave nothing that could
/// vibrate.
SceneModes scene_modes(const Scene& scene, const Simulation& simulation, const ShellEnergyOptions& energies,
                       Index count);

/// A table for people to read.
std::string modes_text(const Scene& scene, const SceneModes& modes);

/// One JSON object; its keys are described in app/README.md.
Json modes_json(const Scene& scene, const SceneModes& modes);

/// How modes are shown in a recording.
struct ModeFrames {
    int a_mode = 24;          ///< frames of one slowed period
    double amplitude = 0.05;  ///< largest displacement of a vertex, as a share of the sheets' size
};

/// Records each mode for one period of slow motion: mode i, from 1, from i - 1 to i s. Returns whether it was
/// not interrupted. Throws Error (run) when the recording cannot be written.
bool record_modes(RecordingOutput output, const Scene& scene, const Simulation& simulation,
                  const SceneModes& modes, const ModeFrames& frames);

}  // namespace sherd
