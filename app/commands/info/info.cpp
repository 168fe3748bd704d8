// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/info/info.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>

#include "app/commands/commands.h"
#include "app/commands/number_check.h"
#include "app/measures/fragments/fragment_distance.h"
#include "app/measures/measures.h"
#include "app/messages/counted.h"
#include "app/messages/number_list.h"
#include "app/messages/print.h"
#include "app/messages/time_text.h"
#include "core/elements/membrane.h"
#include "core/elements/principal_values.h"
#include "meshops/error.h"

namespace sherd {

namespace {

constexpr const char* still_running = "running, or killed: then `sherd run --resume` continues it";

std::vector<SheetInfo> sheets_of(const RecordingHeader& header, const Snapshot& frame) {
    std::vector<SheetInfo> sheets;
    for (const std::string& name : header.sheet_names) sheets.push_back({name, 0, 0});
    for (std::size_t f = 0; f < frame.faces.size(); ++f) {
        SheetInfo& sheet = sheets.at(frame.face_sheet[f]);
        ++sheet.faces;
        sheet.area += frame.rest.area[f];
    }
    return sheets;
}

/// The largest membrane strain, and its face; none without faces. A NaN counts as the largest strain, since
/// it makes the frame invalid.
std::optional<MembraneStrainInfo> largest_membrane_strain(const Snapshot& frame) {
    std::optional<MembraneStrainInfo> largest;
    for (std::size_t f = 0; f < frame.faces.size(); ++f) {
        // The strain does not depend on the elasticity, which is zero here.
        const MembraneTriangle triangle =
            membrane_triangle(columns(frame.rest.position, frame.rest.faces[f]), Matrix3d::Zero());
        const double strain =
            principal_strain(green_strain(triangle, columns(frame.position, frame.faces[f])));
        if (!largest || std::isnan(strain) || std::abs(strain) > std::abs(largest->strain))
            largest = {strain, f};
        if (std::isnan(strain)) break;
    }
    return largest;
}

void add_last_frame(RunInfo& info, const RecordingHeader& header, const Snapshot& frame) {
    info.vertices = frame.position.cols();
    info.faces = frame.faces.size();
    info.sheets = sheets_of(header, frame);
    info.fragments = fragments_of(frame);
    info.membrane_strain = largest_membrane_strain(frame);
}

void add_steps(RunInfo& info, const std::vector<StepReport>& steps) {
    if (!steps.empty()) info.last = steps.back();
    for (const StepReport& step : steps) {
        info.newton_iterations += step.newton_iterations;
        info.halvings += step.halvings;
        info.load.add(step.load);
        info.capped_steps += step.stage_cap_reached;
        info.most_stages = std::max(info.most_stages, step.stages);
        raise_peaks(info.peaks, step);
    }
}

/// Replaces `largest` by the principal value of a strain if `largest` is none, or smaller in magnitude.
void raise_magnitude(std::optional<double>& largest, const Vector3d& strain) {
    const double value = principal_strain(strain);
    if (!largest || std::abs(value) > std::abs(*largest)) largest = value;
}

void add_reading(GaugeInfo& info, const GaugeReading& reading) {
    const FaceFieldChoice& fields = info.gauge.fields;
    info.last = reading;
    info.displacement = std::max(info.displacement, reading.displacement.norm());
    if (fields.curvature) raise_magnitude(info.curvature, reading.curvature);
    if (fields.membrane_strain) raise_magnitude(info.membrane_strain, reading.membrane_strain);
    if (fields.stress)
        info.stress = std::max(info.stress.value_or(largest_stress(reading)), largest_stress(reading));
}

void add_gauges(RunInfo& info, const RecordingHeader& header, const std::vector<StepReport>& steps) {
    for (std::size_t i = 0; i < header.gauges.size(); ++i) {
        info.gauges.push_back({.gauge = header.gauges[i]});
        for (const StepReport& step : steps) add_reading(info.gauges[i], step.gauges[i]);
    }
}

/// Adds the largest stress and the largest curvature in all frames, if they have these fields.
void add_fields(RunInfo& info, const Recording& recording) {
    const auto raise = [](std::optional<FieldPeakInfo>& largest, const FieldPeak& peak, double time) {
        if (!largest || std::abs(peak.value) > std::abs(largest->peak.value)) largest = {peak, time};
    };
    for (std::size_t i = 0; i < info.frames; ++i) {
        const FaceFields fields = recording.fields(i);
        if (!choice_of(fields).any()) return;
        const double time = recording.time(i);
        if (choice_of(fields).curvature) raise(info.curvature, curvature_peak(fields), time);
        if (!choice_of(fields).stress) continue;
        const FieldPeak peak = stress_peak(fields);
        if (!info.stress || peak.value > info.stress->peak.value) info.stress = {peak, time};
    }
}

void add_events(RunInfo& info, const CrackEvents& events) {
    info.failures = events.failures.size();
    info.openings = events.openings.size();
    info.splits = events.splits.size();
    info.vertex_insertions = events.vertex_insertions.size();
    info.face_insertions = events.face_insertions.size();
    info.tips = tips_of(events.tips);
    for (const FragmentSplit& split : events.fragment_splits)
        if (split.fragment >= 0 && static_cast<std::size_t>(split.fragment) < info.fragments.size())
            info.fragments[split.fragment].parent = split.parent;
}

void add_fragment_table(std::string& text, std::vector<FragmentInfo> fragments) {
    constexpr std::size_t most = 20;
    auto out = std::back_inserter(text);
    std::ranges::stable_sort(fragments, std::greater(), &FragmentInfo::area);
    fmt::format_to(out, "fragments    {}\n", fragments.size());
    if (!fragments.empty())
        fmt::format_to(out, "  {:>6} {:>6} {:>8} {:>12} {:>12}\n", "id", "from", "faces", "area m^2",
                       "mass kg");
    for (std::size_t i = 0; i < std::min(most, fragments.size()); ++i)
        fmt::format_to(out, "  {:>6} {:>6} {:>8} {:>12.5g} {:>12.5g}\n", fragments[i].id,
                       fragments[i].parent < 0 ? "" : std::to_string(fragments[i].parent), fragments[i].faces,
                       fragments[i].area, fragments[i].mass);
    if (fragments.size() > most)
        fmt::format_to(out, "  and {} (--json lists all)\n", counted(fragments.size() - most, "smaller one"));
}

void add_balance(std::string& text, const EnergyBalance& balance) {
    auto out = std::back_inserter(text);
    fmt::format_to(
        out, "work         loads {:.5g}, wind {:.5g}, supports {:.5g}, obstacles {:.5g} J since the start\n",
        balance.work_of_loads, balance.work_of_wind, balance.work_of_supports, balance.work_of_obstacles);
    fmt::format_to(out,
                   "lost to      friction {:.5g}, damping {:.5g}, cracks {:.5g}, remeshing {:.5g}, "
                   "yield {:.5g}, time scheme {:.5g} J; unexplained {:.2g} J\n",
                   balance.lost_to_friction, balance.lost_to_damping, balance.lost_to_cracks,
                   balance.lost_to_remeshing, balance.lost_to_yield, balance.lost_to_scheme,
                   balance.unexplained);
}

void add_last_step(std::string& text, const RunInfo& info) {
    auto out = std::back_inserter(text);
    const StepReport& last = *info.last;
    fmt::format_to(
        out,
        "energy       kinetic {:.5g}, bending {:.5g}, membrane {:.5g}, gravity {:.5g}, contact {:.5g} J\n",
        last.kinetic, last.bending, last.membrane, last.gravity, last.contact);
    if (last.residual > 0)
        fmt::format_to(out, "residual     {:.5g} J of residual stress in tempered sheets\n", last.residual);
    if (info.has_balance) add_balance(text, last);
    fmt::format_to(out,
                   "momentum     linear {:.4g} {:.4g} {:.4g} kg m/s, angular {:.4g} {:.4g} {:.4g} kg m^2/s\n",
                   last.linear_momentum.x(), last.linear_momentum.y(), last.linear_momentum.z(),
                   last.angular_momentum.x(), last.angular_momentum.y(), last.angular_momentum.z());
    fmt::format_to(out,
                   "solver       {} Newton iterations, at most {} stages in a step, {} halvings of the step, "
                   "{} steps at the limit of stages\n",
                   info.newton_iterations, info.most_stages, info.halvings, info.capped_steps);
    fmt::format_to(out, "peaks        strain {:.5g} 1/m, bending strain {:.5g} 1/m, stress {:.5g} Pa",
                   info.peaks.peak_strain, info.peaks.peak_bending_strain, info.peaks.peak_stress);
    if (info.peaks.peak_overload > 0)
        fmt::format_to(out, ", {:.4g} times the strength", info.peaks.peak_overload);
    if (info.peaks.peak_yield > 0)
        fmt::format_to(out, ", {:.4g} times the yield stress", info.peaks.peak_yield);
    text += "\n";
}

void add_gauge(std::string& text, const GaugeInfo& g) {
    auto out = std::back_inserter(text);
    fmt::format_to(out, "gauge        {} on {}:", g.gauge.name, g.gauge.sheet);
    const auto add_tensor = [&](const char* name, const Vector3d& tensor, const char* end) {
        fmt::format_to(out, " {} {:.5g} {:.5g} {:.5g}{}", name, tensor[0], tensor[1], tensor[2], end);
    };
    if (g.gauge.displacement) {
        add_tensor("moved by", g.last.displacement, " m");
        fmt::format_to(out, ", by {:.5g} m at most", g.displacement);
    }
    text += "\n";
    if (g.stress) {
        add_tensor("              stress: top", g.last.stress_top, ",");
        add_tensor("bottom", g.last.stress_bottom, " Pa");
        fmt::format_to(out, "; principal {:.5g} Pa at most\n", *g.stress);
    }
    if (g.curvature) {
        add_tensor("              curvature:", g.last.curvature, " 1/m");
        fmt::format_to(out, "; principal {:.5g} 1/m at most\n", *g.curvature);
    }
    if (g.membrane_strain) {
        add_tensor("              membrane strain:", g.last.membrane_strain, "");
        fmt::format_to(out, "; principal {:.5g} at most\n", *g.membrane_strain);
    }
}

void add_reactions(std::string& text, const RunInfo& info) {
    auto out = std::back_inserter(text);
    for (std::size_t i = 0; i < info.last->reactions.size(); ++i) {
        const auto& [force, moment] = info.last->reactions[i];
        fmt::format_to(
            out, "reaction     {}: force {:.5g} {:.5g} {:.5g} N, moment {:.4g} {:.4g} {:.4g} N m\n",
            info.supports[i].name, force.x(), force.y(), force.z(), moment.x(), moment.y(), moment.z());
    }
    for (const GaugeInfo& g : info.gauges) add_gauge(text, g);
}

void add_field_peaks(std::string& text, const RunInfo& info) {
    auto out = std::back_inserter(text);
    if (const auto& stress = info.stress)
        fmt::format_to(out, "stress       {:.5g} Pa at most, at the {} of face {} at {}\n",
                       stress->peak.value, stress->peak.top ? "top" : "bottom", stress->peak.face,
                       time_text(fmt::format("{:.5g}", stress->time), info.time_unit));
    if (const auto& curvature = info.curvature)
        fmt::format_to(out, "curvature    changed by {:.5g} 1/m at most, of face {} at {}\n",
                       curvature->peak.value, curvature->peak.face,
                       time_text(fmt::format("{:.5g}", curvature->time), info.time_unit));
}

/// Adds the list of modes, for a recording of modes instead of a run.
void add_mode_list(std::string& text, const RunInfo& info) {
    auto out = std::back_inserter(text);
    fmt::format_to(out, "modes        {} of vibration; the times of the frames are not physical\n",
                   info.modes.size());
    for (std::size_t i = 0; i < info.modes.size(); ++i)
        fmt::format_to(out, "  {:>4}  {}\n", i + 1, info.modes[i].words());
}

struct InfoOptions {
    std::filesystem::path recording;
    bool json = false, measures = false;
    double over = 0;                 ///< kg; only heavier fragments are counted
    std::string about;               ///< centre of cracks: X,Y,Z or an obstacle; empty: the first crack
    std::vector<double> radii;       ///< m, of circles on which radial cracks are counted
    std::filesystem::path distance;  ///< another recording for fragment_distance(); empty: none
};

CrackCentre centre_of(const InfoOptions& options) {
    CrackCentre centre{.radii = options.radii};
    if (options.about.find(',') == std::string::npos) {
        centre.obstacle = options.about;
        return centre;
    }
    const std::vector<double> place = number_list("--about", options.about);
    if (place.size() != 3) throw Error(fmt::format("--about {}: a point is X,Y,Z in m", options.about));
    centre.point = Vector3d(place[0], place[1], place[2]);
    return centre;
}

int print_measures(const InfoOptions& options) {
    const Recording recording(options.recording);
    const Measures measures = measures_of(recording, options.over, centre_of(options));
    if (!recording.recovery().empty()) print_message("sherd: warning: {}\n", recording.recovery());
    print_result(
        "{}", options.json ? measures_json(measures) : measures_text(measures, recording.header().time_unit));
    return 0;
}

int print_distance(const InfoOptions& options) {
    const FragmentDistance distance =
        fragment_distance(Recording(options.recording), Recording(options.distance));
    print_result("{}", options.json ? distance_json(distance) : distance_text(distance));
    return 0;
}

int print_info(const InfoOptions& options) {
    if (!options.distance.empty()) return print_distance(options);
    if (options.measures) return print_measures(options);
    const RunInfo info = read_run_info(options.recording);
    if (!info.recovery.empty()) print_message("sherd: warning: {}\n", info.recovery);
    print_result("{}", options.json ? run_info_json(info) : run_info_text(info));
    return 0;
}

}  // namespace

RunInfo read_run_info(const std::filesystem::path& file) try {
    const Recording recording(file);
    const RecordingHeader header = recording.header();
    RunInfo info;
    info.recovery = recording.recovery();
    info.scene_file = header.scene_file;
    info.seed = header.seed;
    info.time_unit = header.time_unit;
    info.end = recording.end();
    info.wall_seconds = recording.wall_seconds();
    info.frames = recording.frame_count();
    info.vertices = header.rest_position.cols();
    info.faces = header.rest_faces.size();
    if (info.frames > 0) add_last_frame(info, header, recording.frame(info.frames - 1));
    const std::vector<StepReport> steps = recording.steps();
    add_steps(info, steps);
    info.has_balance = recording.has_balance();
    info.supports = header.supports;
    add_gauges(info, header, steps);
    add_fields(info, recording);
    add_events(info, recording.events());
    info.modes = recording.modes();
    return info;
} catch (const std::out_of_range&) {
    throw Error(fmt::format("the recording '{}' is damaged: a face belongs to a sheet that has no name",
                            file.string()));
}

std::string run_info_text(const RunInfo& info) {
    const StepReport last = info.last.value_or(StepReport{});
    std::string text;
    auto out = std::back_inserter(text);
    fmt::format_to(out, "scene        {}, seed {}\n", info.scene_file, info.seed);
    fmt::format_to(out, "end          {}", info.end == "running" ? still_running : info.end);
    if (info.wall_seconds > 0) fmt::format_to(out, ", after {:.1f} s of wall time", info.wall_seconds);
    if (info.modes.empty())
        fmt::format_to(out, "\nrun          {}, {}, {}\n", counted(last.step, "step"),
                       time_text(fmt::format("{:.6g}", last.time), info.time_unit),
                       counted(info.frames, "frame"));
    else
        fmt::format_to(out, "\nframes       {}\n", info.frames);
    if (info.time_unit != "s" && info.last)
        fmt::format_to(
            out, "load         {:.6g} times the loads at the end, {:.6g} at most{}\n", info.load.last,
            info.load.largest,
            info.load.limit ? fmt::format("; it fell for the first time at {:.6g}", *info.load.limit) : "");
    fmt::format_to(out, "mesh         {}, {}\n", counted(info.vertices, "vertex", "vertices"),
                   counted(info.faces, "face"));
    for (const SheetInfo& s : info.sheets)
        fmt::format_to(out, "sheet        {}: {}, {:.5g} m^2\n", s.name, counted(s.faces, "face"), s.area);
    if (!info.modes.empty()) {
        add_mode_list(text, info);
        return text;
    }
    fmt::format_to(out, "cracks       {} failed, {} opened; {} split", counted(info.failures, "edge"),
                   info.openings, counted(info.splits, "vertex", "vertices"));
    if (info.vertex_insertions + info.face_insertions > 0)
        fmt::format_to(out, "; {} and {} inserted", counted(info.vertex_insertions, "vertex", "vertices"),
                       counted(info.face_insertions, "face"));
    text += "\n";
    if (info.last) {
        add_last_step(text, info);
        add_reactions(text, info);
    }
    if (info.membrane_strain)
        fmt::format_to(out, "membrane     strain {:.4g} at most in the last frame, of face {}\n",
                       info.membrane_strain->strain, info.membrane_strain->face);
    add_field_peaks(text, info);
    add_fragment_table(text, info.fragments);
    add_tip_table(text, info.tips, info.time_unit);
    return text;
}

void add_info(CLI::App& program, Command& chosen) {
    CLI::App* command = program.add_subcommand("info", "Summarise a run");
    auto options = std::make_shared<InfoOptions>();
    command->add_option("recording", options->recording, "Recording of a run (.h5)")
        ->required()
        ->option_text("RUN.h5");
    command->add_flag("--json", options->json, "For scripts: one JSON object");
    CLI::Option* measures =
        command->add_flag("--measures", options->measures,
                          "Measures for comparing runs: sizes of fragments, cracks, peak forces");
    command->add_option("--over", options->over, "Count only fragments heavier than this, kg (default: all)")
        ->needs(measures)
        ->check(not_negative_number())
        ->option_text("MASS");
    command
        ->add_option("--about", options->about,
                     "Centre for counting radial and ring cracks: a point at rest, m, or the first contact "
                     "of an obstacle (default: the first crack)")
        ->needs(measures)
        ->option_text("X,Y,Z|OBSTACLE");
    command->add_option("--radii", options->radii, "Radii of circles on which radial cracks are counted, m")
        ->needs(measures)
        ->delimiter(',')
        ->check(positive_number())
        ->option_text("R,R,...");
    command
        ->add_option("--distance", options->distance,
                     "Compare with the fragments of another recording, at rest: Rand index")
        ->excludes(measures)
        ->option_text("RUN.h5");
    command->footer(
        "Examples:\n  sherd info plate_drop.h5\n  sherd info plate_drop.h5 --measures --over 1e-4 --json");
    command->callback([&chosen, options] { chosen = [options] { return print_info(*options); }; });
}

}  // namespace sherd
