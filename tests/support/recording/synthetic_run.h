// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>
#include <map>

#include "app/recording/recording.h"
#include "app/recording/recording_format.h"
#include "tests/support/program/edited_file.h"

namespace sherd::test {

/// Synthetic run: a strip of two sheets that is torn off column by column, so that its topology changes from
/// frame to frame. Frame k has k + 1 fragments of `columns_per_fragment` or more columns.
struct SyntheticRun {
    RecordingHeader header;
    std::vector<Snapshot> frames;
    std::vector<std::vector<StepReport>> steps;  ///< steps[k]: reports of the steps before frame k
    std::vector<CrackEvents> events;             ///< events[k]: events before frame k
};

namespace synthetic {

inline constexpr Index columns = 12, rows = 4, columns_per_fragment = 3;

/// Numbers with all bits in use, and some that a text would not preserve.
inline double number(Index i, Index k) {
    if (i % 17 == 3) return -0.0;
    if (i % 19 == 5) return std::numeric_limits<double>::denorm_min() * (k + 1);
    return std::sin(1.0 + i) * std::pow(10.0, (i + k) % 9 - 4);
}

inline std::vector<std::array<Index, 3>> whole_faces() {
    std::vector<std::array<Index, 3>> faces;
    for (Index x = 0; x < columns; ++x)
        for (Index y = 0; y < rows; ++y) {
            const Index corner = x * (rows + 1) + y, next = corner + rows + 1;
            faces.push_back({corner, next, next + 1});
            faces.push_back({corner, next + 1, corner + 1});
        }
    return faces;
}

inline Positions whole_positions() {
    Positions position(3, (columns + 1) * (rows + 1));
    for (Index i = 0; i < position.cols(); ++i) {
        const Index column = i / (rows + 1), row = i % (rows + 1);
        position.col(i) = Vector3d(0.01 * column, 0.01 * row, 0.001 * std::sin(i));
    }
    return position;
}

/// Tears off the columns left of the k-th tear: the right-hand faces keep their vertices.
inline void tear(Snapshot& snapshot, Index k, CrackEvents& events) {
    const Index column = k * columns_per_fragment;
    const auto old_count = static_cast<Index>(snapshot.original.size());
    for (Index y = 0; y <= rows; ++y) {
        snapshot.original.push_back(column * (rows + 1) + y);
        events.splits.push_back({0.25 * k, k, column * (rows + 1) + y, old_count + y});
    }
    const Index first_face = (column - columns_per_fragment) * rows * 2, last_face = column * rows * 2;
    for (Index f = first_face; f < last_face; ++f) {
        for (Index& vertex : snapshot.faces[f])
            if (vertex / (rows + 1) == column && vertex < (columns + 1) * (rows + 1))
                vertex = old_count + vertex % (rows + 1);
    }
    for (Index f = last_face; f < static_cast<Index>(snapshot.faces.size()); ++f)
        snapshot.face_fragment[f] = k;
    for (Index y = 0; y < rows; ++y) {
        const Index edge = static_cast<Index>(7 * y), created = 1000 + y;
        events.failures.push_back({0.25 * k,
                                   k,
                                   y,
                                   edge,
                                   {y, y + 1},
                                   y % 3,
                                   number(y + 1, k),
                                   number(y + 2, k),
                                   1 + number(y + 3, k)});
        events.openings.push_back({0.25 * k, k, edge, created});
    }
    events.fragment_splits.push_back({0.25 * k, k, k, k - 1});
}

inline void add_edges(Snapshot& snapshot) {
    std::map<std::array<Index, 2>, int> faces_of;
    for (const auto& f : snapshot.faces)
        for (int c = 0; c < 3; ++c)
            ++faces_of[{std::min(f[c], f[(c + 1) % 3]), std::max(f[c], f[(c + 1) % 3])}];
    snapshot.edges.clear();
    snapshot.edge_state.clear();
    snapshot.edge_strain.clear();
    for (const auto& [edge, count] : faces_of) {
        const auto i = static_cast<Index>(snapshot.edges.size());
        snapshot.edges.push_back(edge);
        snapshot.edge_state.push_back(count == 1    ? EdgeState::boundary
                                      : i % 13 == 0 ? EdgeState::fractured_interior
                                                    : EdgeState::interior);
        snapshot.edge_strain.push_back(count == 1 ? 0 : number(i, 1));
    }
}

inline void fill_numbers(Snapshot& snapshot, Index k) {
    const auto vertices = static_cast<Index>(snapshot.original.size());
    const Positions rest = whole_positions();
    snapshot.step = 10 * k;
    snapshot.time = 0.1 * k;
    snapshot.position.resize(3, vertices);
    snapshot.velocity.resize(3, vertices);
    snapshot.mass.resize(vertices);
    for (Index v = 0; v < vertices; ++v) {
        snapshot.position.col(v) = rest.col(snapshot.original[v]) + Vector3d(0, 0, -0.02 * k);
        snapshot.velocity.col(v) = Vector3d(number(v, k), number(v + 1, k), number(v + 2, k));
        snapshot.mass[v] = 1e-3 / (3 + v);
    }
}

inline std::vector<RecordedSupport> supports() {
    return {
        {"sheet.left \"half\".pin", "pin"}, {"sheet.a/b.clamp[1]", "clamp"}, {"obstacle.floor", "obstacle"}};
}

inline std::vector<RecordedGauge> gauges() {
    return {{"tip", "right", {1, 2, 3}}, {"middle", "left \"half\"", {0, 0, 1e-3}}};
}

/// Report with as many reactions as there are supports(), and readings of gauges().
inline StepReport step(Index i) {
    StepReport report;
    report.step = i;
    report.time = 0.01 * i;
    report.step_size = 0.01;
    report.kinetic = number(i, 1);
    report.bending = number(i, 2);
    report.membrane = number(i, 3);
    report.gravity = -number(i, 4);
    report.contact = number(i, 5);
    for (Index k = 0; k < static_cast<Index>(balance_parts.size()); ++k)
        report.*balance_parts[k] = number(i, 20 + k);
    report.linear_momentum = Vector3d(number(i, 6), number(i + 1, 6), number(i + 2, 6));
    report.angular_momentum = Vector3d(number(i, 7), number(i + 1, 7), number(i + 2, 7));
    report.newton_iterations = i % 5;
    report.halvings = i % 7 == 0;
    report.stages = i % 4;
    report.stage_cap_reached = i % 11 == 0;
    report.contacts = 3 * i;
    report.obstacle_overlap = 2e-6 * i;
    report.crack_face_overlap = 1e-6 * i;
    report.fragments = 1 + i / 10;
    report.peak_strain = 2.0 + std::sin(i);
    report.peak_stress = 3e7 + std::sin(i);
    report.peak_bending_strain = 1.0 + std::cos(i);
    report.peak_overload = 0.5 + std::cos(3.0 * i);
    for (Index k = 0; k < 3; ++k)
        report.reactions.push_back({Vector3d(number(i, k), 2, 3), Vector3d(k, number(i, 8 + k), 1)});
    for (Index k = 0; k < 2; ++k)
        report.gauges.push_back({.displacement = Vector3d(number(i, 11 + k), 0, 1e-3 * i)});
    return report;
}

}  // namespace synthetic

/// Adds face fields to all frames, and their columns to the first gauge.
inline void add_fields(SyntheticRun& run) {
    for (Snapshot& frame : run.frames)
        visit_fields(frame.fields, [&](const char* name, Eigen::Matrix3Xd& values, const FieldMeaning&) {
            values.resize(3, static_cast<Eigen::Index>(frame.faces.size()));
            for (Eigen::Index i = 0; i < values.size(); ++i)
                values.data()[i] = synthetic::number(static_cast<Index>(i), static_cast<Index>(name[7]));
        });
    RecordedGauge& gauge = run.header.gauges[0];
    gauge.displacement = false;
    gauge.fields = {.stress = true, .membrane_strain = true};
    gauge.axes << 0.6, 0.8, 0.8, -0.6, 0, 0;
    for (std::vector<StepReport>& steps : run.steps)
        for (StepReport& step : steps) {
            const auto i = static_cast<Index>(step.step);
            step.gauges[0] = {.membrane_strain = Vector3d(synthetic::number(i, 2), 1, -i),
                              .stress_top = Vector3d(1e6 * i, synthetic::number(i, 3), 2),
                              .stress_bottom = Vector3d(-3, i, synthetic::number(i, 4))};
        }
}

/// Adds two crack tips, in steps 1 to 12 and 5 to 20, that propagate along x; frames are at the steps 0, 10,
/// 20.
inline void add_tips(SyntheticRun& run) {
    for (Index i = 1; i <= 20; ++i)
        for (const Index tip : {0, 1}) {
            if (tip == 0 ? i > 12 : i < 5) continue;
            TipRecord record{.time = 0.01 * i, .step = i, .tip = tip, .vertex = tip};
            record.position = Vector3d(0.005 * i, 0.01 + 0.02 * tip, -0.002 * i);
            record.direction = Vector3d::UnitX();
            record.speed = 100.0 * i;
            record.released = (1 + tip) * 50.0;
            record.toughness = 100;
            record.opening = 1e6 * i;
            run.events[i <= 10 ? 1 : 2].tips.push_back(record);
        }
}

/// Gives all frames the unfractured mesh of the header.
inline void set_rest(SyntheticRun& run) {
    for (Snapshot& frame : run.frames) frame.rest = recording_format::unfractured_mesh(run.header);
}

inline SyntheticRun synthetic_run() {
    using namespace synthetic;
    SyntheticRun run;
    run.header = {.scene_file = "strip & \"strip\".toml",
                  .scene_text = "duration = 0.3\n# \xc3\xa4\n",
                  .seed = -7,
                  .sheet_names = {"left \"half\"", "right"},
                  .rest_position = whole_positions(),
                  .rest_faces = whole_faces(),
                  .rest_area = {},
                  .rest_thickness = {},
                  .supports = supports(),
                  .gauges = gauges()};
    Snapshot snapshot;
    snapshot.faces = whole_faces();
    for (Index v = 0; v < (columns + 1) * (rows + 1); ++v) snapshot.original.push_back(v);
    for (Index f = 0; f < static_cast<Index>(snapshot.faces.size()); ++f) {
        run.header.rest_area.push_back(5e-5 + 1e-7 * f);
        run.header.rest_thickness.push_back(f * 2 < static_cast<Index>(snapshot.faces.size()) ? 1e-3 : 2e-3);
        snapshot.face_sheet.push_back(f * 2 < static_cast<Index>(snapshot.faces.size()) ? 0 : 1);
    }
    snapshot.face_fragment.assign(snapshot.faces.size(), 0);
    for (Index k = 0; k < 3; ++k) {
        CrackEvents events;
        if (k > 0) tear(snapshot, k, events);
        add_edges(snapshot);
        fill_numbers(snapshot, k);
        std::vector<StepReport> steps;
        for (Index i = 10 * (k - 1) + 1; k > 0 && i <= 10 * k; ++i) steps.push_back(step(i));
        run.frames.push_back(snapshot);
        run.steps.push_back(steps);
        run.events.push_back(events);
    }
    set_rest(run);
    return run;
}

/// Records `run` into `file`, as a complete recording.
inline void record(const SyntheticRun& run, const std::filesystem::path& file) {
    RecordingWriter writer(file, run.header, false);
    for (std::size_t k = 0; k < run.frames.size(); ++k)
        writer.append(run.frames[k], run.steps[k], run.events[k]);
    writer.finish(12.5, "complete");
}

/// Removes the energy balance from a recording, as in recordings of old versions.
inline void remove_balance(const std::filesystem::path& file) {
    const hdf5::Handle opened = open_to_edit(file);
    for (const std::string& name : hdf5::member_names(opened, "steps"))
        if (name == "unexplained" || name.starts_with("work_of_") || name.starts_with("lost_to_"))
            hdf5::remove(opened, "steps/" + name);
}

}  // namespace sherd::test
