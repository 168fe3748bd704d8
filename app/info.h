// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/measures/fragment_info.h"
#include "app/recording/recording.h"
#include "app/run/load_history.h"
#include "app/tip_info.h"

namespace sherd {

/// The face that is stretched or squeezed most.
struct MembraneStrainInfo {
    double strain = 0;  ///< principal Green strain of largest magnitude, signed
    std::size_t face = 0;
};

/// Where and when a field of faces was largest, of all frames.
struct FieldPeakInfo {
    FieldPeak peak;
    double time = 0;  ///< s
};

/// What a gauge showed: at the last step, and the largest of all steps. Of stress that is the largest
/// principal one of both surfaces, of curvature and strain the principal one of largest magnitude, signed.
struct GaugeInfo {
    RecordedGauge gauge;
    GaugeReading last = {};
    double displacement = 0;                                                  ///< m, magnitude
    std::optional<double> stress = {}, curvature = {}, membrane_strain = {};  ///< Pa, 1/m, 1
};

struct SheetInfo {
    std::string name;
    std::size_t faces = 0;
    double area = 0;  ///< m^2, at rest
};

/// What happened in a run, as `sherd info` tells it; of a run that goes on, what happened so far.
struct RunInfo {
    std::string scene_file, end;
    std::string mended;  ///< Recording::mended()
    std::int64_t seed = 0;
    std::string time_unit = "s";  ///< RecordingHeader::time_unit
    LoadHistory load;             ///< factor of all loads
    double wall_seconds = 0;
    std::size_t frames = 0, vertices = 0, faces = 0;  ///< of the last frame, or at rest when there is none
    std::size_t failures = 0, openings = 0, splits = 0, vertex_births = 0, face_births = 0;
    std::vector<SheetInfo> sheets;                      ///< none before the first frame
    std::vector<FragmentInfo> fragments;                ///< by id; none before the first frame
    std::optional<MembraneStrainInfo> membrane_strain;  ///< in the last frame, if there is one
    std::optional<FieldPeakInfo> stress, curvature;  ///< largest_stress(), largest_curvature(), if recorded
    std::vector<RecordedSupport> supports;           ///< whose reactions `last` has
    std::vector<GaugeInfo> gauges;
    std::vector<TipInfo> tips;           ///< of cracks by toughness
    std::vector<RecordedMode> modes;     ///< of vibration, if it is these that the frames show
    std::optional<StepReport> last;      ///< the last step, if there was one
    bool has_balance = true;             ///< whether it has a balance of energy: Recording::has_balance()
    std::int64_t newton_iterations = 0;  ///< of all steps
    std::size_t capped_steps = 0;
    Index halvings = 0;
    Index most_stages = 0;  ///< of breaking in one step
    StepReport peaks;       ///< only its peaks: the largest of the whole run
};

/// Throws Error (input) when `file` is missing, not a recording or damaged.
RunInfo read_run_info(const std::filesystem::path& file);

/// One JSON object; its keys are described in app/README.md. A number that is not finite becomes null.
std::string run_info_json(const RunInfo& info);

/// The same for people to read.
std::string run_info_text(const RunInfo& info);

}  // namespace sherd
