// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "app/commands/modes/modes.h"
#include "app/progress/interruption.h"
#include "app/progress/progress.h"
#include "app/run/recording_header.h"

namespace sherd {
namespace {

constexpr const char* times_of_modes =
    "not physical: mode i, from 1, is shown from i - 1 to i s, for one period of slow motion with a made-up "
    "amplitude; velocities are those of this motion; the frequencies are in /modes";

RecordingHeader modes_header(const Scene& scene, const Simulation& simulation) {
    RecordingHeader header = recording_header(scene, simulation);
    header.supports.clear();  // there are no steps, and so no values for each step
    header.gauges.clear();
    return header;
}

std::vector<RecordedMode> recorded(const Vibration& vibration) {
    std::vector<RecordedMode> modes;
    for (const VibrationMode& mode : vibration.modes)
        modes.push_back({mode.frequency(), mode.growth_rate(), mode.shape});
    return modes;
}

/// Largest displacement of a vertex in the recording, m: this share of the size of the sheets.
double shown_amplitude(const Positions& start, double share) {
    return share * (start.rowwise().maxCoeff() - start.rowwise().minCoeff()).norm();
}

/// A shell that is displaced by a mode.
class ModePlayer {
  public:
    ModePlayer(const Simulation& simulation, const ModeFrames& frames)
        : shell(simulation.shell()),
          start(shell.mechanics().position),
          fragments(simulation.snapshot().face_fragment),
          frames(frames),
          amplitude(shown_amplitude(start, frames.amplitude)) {}

    /// The shell in mode `number`, from 1, at frame `frame`, from 0, of its period.
    Snapshot snapshot(std::size_t number, const Positions& shape, int frame) {
        const double turns = static_cast<double>(frame) / frames.a_mode, angle = 2 * std::numbers::pi * turns;
        const Positions scaled = amplitude / shape.colwise().norm().maxCoeff() * shape;
        shell.mechanics().position = start + std::sin(angle) * scaled;
        shell.mechanics().velocity = 2 * std::numbers::pi * std::cos(angle) * scaled;
        Snapshot snapshot = take_snapshot(shell, fragments);
        snapshot.step = static_cast<std::int64_t>(number);
        snapshot.time = static_cast<double>(number - 1) + turns;
        return snapshot;
    }

  private:
    BreakableShell shell;
    Positions start;
    std::vector<Index> fragments;
    ModeFrames frames;
    double amplitude;
};

}  // namespace

bool record_modes(RecordingOutput output, const Scene& scene, const Simulation& simulation,
                  const SceneModes& modes, const ModeFrames& frames) {
    watch_for_interruption();
    RecordingWriter writer(std::move(output), modes_header(scene, simulation));
    writer.add_modes(recorded(modes.vibration), times_of_modes);
    ModePlayer player(simulation, frames);
    const std::vector<VibrationMode>& all = modes.vibration.modes;
    Progress progress(static_cast<double>(all.size()));
    for (std::size_t i = 0; i < all.size(); ++i) {
        progress.show(static_cast<double>(i), fmt::format("mode {} of {}", i + 1, all.size()));
        // The last mode has a frame at the end of its period; the period of each other mode ends with the
        // first frame of the next mode.
        const int last = frames.a_mode - (i + 1 < all.size() ? 1 : 0);
        for (int frame = 0; frame <= last; ++frame) {
            if (interrupted()) {
                writer.finish(progress.wall_seconds(), "interrupted");
                return false;
            }
            writer.append(player.snapshot(i + 1, all[i].shape, frame), {}, {});
        }
    }
    writer.finish(progress.wall_seconds(), "complete");
    return true;
}

}  // namespace sherd
