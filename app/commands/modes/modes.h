// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/json/json.h"
#include "app/recording/recording.h"
#include "app/scene/scene.h"
#include "core/vibration/vibration.h"
#include "fracture/step/simulation.h"

namespace sherd {

/// Vibration of the sheets of a scene about the state in which they start.
struct SceneModes {
    Vibration vibration;
    std::vector<double> out_of_plane;   ///< share_along_normals() of each mode, 0 to 1
    std::vector<std::string> left_out;  ///< parts of the scene that the modes neglect, in words
    std::size_t vertices = 0, faces = 0;
};

/// The `count` modes of lowest frequency, or as many as the mesh has. simulation: simulation of the scene
/// before its first step; energies: options of its energies. Throws Error (input), naming the scene, if its
/// supports leave no coordinate that can vibrate.
SceneModes scene_modes(const Scene& scene, const Simulation& simulation, const ShellEnergyOptions& energies,
                       Index count);

/// The modes as a table of text.
std::string modes_text(const Scene& scene, const SceneModes& modes);

/// JSON object with the keys of docs/commands.md.
Json modes_json(const Scene& scene, const SceneModes& modes);

/// Frames of modes in a recording.
struct ModeFrames {
    int a_mode = 24;          ///< number of frames per mode, for one period
    double amplitude = 0.05;  ///< largest displacement of a vertex, as a share of the sheets' size
};

/// Records each mode for one period in slow motion: mode i, counted from 1, between i - 1 and i s. Returns
/// false if it was interrupted. Throws Error (run) if the recording cannot be written.
bool record_modes(RecordingOutput output, const Scene& scene, const Simulation& simulation,
                  const SceneModes& modes, const ModeFrames& frames);

}  // namespace sherd
