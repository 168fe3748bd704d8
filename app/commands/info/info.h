// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/commands/info/tip_info.h"
#include "app/measures/fragments/fragment_info.h"
#include "app/recording/recording.h"
#include "app/run/run_totals.h"

namespace sherd {

/// The face with the largest membrane strain.
struct MembraneStrainInfo {
    double strain = 0;  ///< principal Green strain of largest magnitude, signed
    std::size_t face = 0;
};

/// Largest value of a field of faces in all frames, with its place and time.
struct FieldPeakInfo {
    FieldPeak peak;
    double time = 0;  ///< s
};

/// Readings of a gauge in the last step, and its largest readings in all steps.
struct GaugeInfo {
    RecordedGauge gauge;
    GaugeReading last = {};
    double displacement = 0;  ///< m, largest magnitude
    /// Largest principal stress at the two surfaces, Pa; principal curvature (1/m) and principal membrane
    /// strain of largest magnitude, signed. None if the gauge does not record them.
    std::optional<double> stress = {}, curvature = {}, membrane_strain = {};
};

struct SheetInfo {
    std::string name;
    std::size_t faces = 0;
    double area = 0;  ///< m^2, at rest
};

/// Summary of a run for `sherd info`; while the run continues, up to its last frame.
struct RunInfo {
    std::string scene_file, end;
    std::string recovery;  ///< Recording::recovery()
    std::int64_t seed = 0;
    std::string time_unit = "s";  ///< RecordingHeader::time_unit
    LoadHistory load;             ///< factor of all loads
    double wall_seconds = 0;      ///< s
    /// Numbers of frames, and of vertices and faces in the last frame or, if there is no frame, at rest.
    std::size_t frames = 0, vertices = 0, faces = 0;
    std::size_t failures = 0, openings = 0, splits = 0, vertex_insertions = 0, face_insertions = 0;
    std::vector<SheetInfo> sheets;                      ///< none before the first frame
    std::vector<FragmentInfo> fragments;                ///< by id; none before the first frame
    std::optional<MembraneStrainInfo> membrane_strain;  ///< in the last frame, if there is one
    std::optional<FieldPeakInfo> stress, curvature;  ///< largest_stress(), largest_curvature(), if recorded
    std::vector<RecordedSupport> supports;           ///< in the order of last->reactions
    std::vector<GaugeInfo> gauges;
    std::vector<TipInfo> tips;           ///< tips of cracks that grow by toughness
    std::vector<RecordedMode> modes;     ///< modes of vibration, if the frames show them
    std::optional<StepReport> last;      ///< the last step, if there was one
    bool has_balance = true;             ///< Recording::has_balance()
    std::int64_t newton_iterations = 0;  ///< sum over all steps
    std::size_t capped_steps = 0;        ///< number of steps that reached the limit of stages
    Index halvings = 0;
    Index most_stages = 0;  ///< largest number of stages of breaking in a step
    StepReport peaks;       ///< only the peaks are set: the largest of all steps
};

/// Reads the summary of a recording. Throws Error (input) if `file` is missing, not a recording or damaged.
RunInfo read_run_info(const std::filesystem::path& file);

/// JSON object with the keys of docs/commands.md. A number that is not finite becomes null.
std::string run_info_json(const RunInfo& info);

/// The summary as text.
std::string run_info_text(const RunInfo& info);

}  // namespace sherd
