// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "app/files/disk/pending_file.h"
#include "app/messages/build_info.h"
#include "app/messages/time_text.h"
#include "app/recording/hdf5.h"
#include "app/recording/hdf5_file.h"
#include "app/recording/obstacle_writer.h"
#include "app/recording/recording.h"
#include "app/recording/recording_table.h"
#include "core/elements/membrane.h"
#include "meshops/shared_values.h"

namespace sherd::recording_format {
namespace {

/// Returns the number of rows of each table of a recording.
std::vector<std::size_t> extent(hid_t file) {
    std::vector<std::size_t> rows;
    visit_tables([&]<class Row>(std::type_identity<Row>) { rows.push_back(table_rows<Row>(file)); });
    visit_lists([&]<class Row>(std::vector<Row> StepReport::*, const std::string& group) {
        for (const std::string& table : numbered_groups(file, group))
            rows.push_back(table_rows<Row>(file, table));
    });
    return rows;
}

/// Truncates the file to `frames` frames, and each table to the number of rows in `rows`. Throws Error (run)
/// if the file holds less.
void cut(hid_t file, std::size_t frames, std::span<const std::size_t> rows) {
    const std::vector<std::size_t> now = extent(file);
    const std::size_t frames_now = hdf5::member_count(file, "frames");
    if (frames_now < frames || now.size() != rows.size() ||
        !std::ranges::equal(rows, now, std::ranges::less_equal()))
        throw Error("it holds less than had been recorded at the checkpoint", Fault::run);
    for (std::size_t frame = frames_now; frame-- > frames;) hdf5::remove(file, frame_group(frame));
    auto left = rows.begin();
    visit_tables([&]<class Row>(std::type_identity<Row>) { shorten_table<Row>(file, *left++); });
    visit_lists([&]<class Row>(std::vector<Row> StepReport::*, const std::string& group) {
        for (const std::string& table : numbered_groups(file, group))
            shorten_table<Row>(file, *left++, table);
    });
}

}  // namespace
}  // namespace sherd::recording_format

namespace sherd {

namespace {

using namespace recording_format;

std::filesystem::path index_of(const std::filesystem::path& file) {
    std::filesystem::path index = file;
    index.replace_extension(".xdmf");
    if (index == file)
        throw Error(
            fmt::format("'{}' is the name of the index for ParaView; name the recording .h5", file.string()));
    return index;
}

/// Writes a row for each column of the matrix.
template <int N>
void write_array(hid_t where, const std::string& name, const hdf5::Meaning& meaning,
                 const Eigen::Matrix<double, N, Eigen::Dynamic>& values) {
    hdf5::create_array(where, name, H5T_NATIVE_DOUBLE, values.cols(), N, values.data(), meaning);
}

void write_array(hid_t where, const std::string& name, const hdf5::Meaning& meaning, const VectorXd& values) {
    hdf5::create_array(where, name, H5T_NATIVE_DOUBLE, values.size(), 1, values.data(), meaning);
}

template <class T>
void write_array(hid_t where, const std::string& name, const hdf5::Meaning& meaning,
                 const std::vector<T>& values) {
    hdf5::write<T>(where, name, values, meaning);
}

void write_rows(hid_t where, const std::string& name, const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::string> names;
    for (const std::vector<std::string>& row : rows) names.push_back(fmt::format("{}", fmt::join(row, "\n")));
    hdf5::write_texts(where, names_of(name), names);
}

void write_rows(hid_t where, const std::string& name, const std::vector<SurfaceMaterial>& rows) {
    std::vector<std::string> names, definitions;
    for (const SurfaceMaterial& material : rows) {
        names.push_back(material.name);
        definitions.push_back(material.definition);
    }
    hdf5::write_texts(where, names_of(name), names);
    hdf5::write_texts(where, definitions_of(name), definitions);
}

template <class T>
void write_array(hid_t where, const std::string& name, const hdf5::Meaning& meaning,
                 const std::vector<std::shared_ptr<const T>>& values) {
    const SharedValues<T> shared = shared_values(values);
    write_array(where, name, meaning, shared.number);
    write_rows(where, name, shared.rows);
}

void write_look(hid_t where, const std::string& group, const SurfaceLook& look) {
    visit_recorded_attributes([&](const auto& attribute) {
        if (const auto& values = look.*attribute.list; !values.empty())
            write_array(where, group + "/" + attribute.recorded, {attribute.unit, attribute.meaning}, values);
    });
}

/// Returns a function that writes an array of a snapshot into the group of its frame.
auto array_writer(hid_t frame) {
    return [frame](const SnapshotArray& array, const auto& values) {
        if (array.presence != Presence::if_any || values.size() > 0)
            write_array(frame, array.name, meaning_of(array), values);
    };
}

/// Writes a mesh at rest into the group `rest` below `where`.
void write_rest(hid_t where, const RestMesh& rest) {
    visit_rest_arrays(rest, array_writer(where));
    write_look(where, "rest", rest.look);
}

/// Creates the group `path` in `group` for the table of a support or a gauge, and gives it the next number in
/// `group`.
hdf5::Handle create_numbered(hid_t file, const std::string& group, const std::string& path) {
    const auto number =
        static_cast<std::int64_t>(hdf5::contains(file, group) ? hdf5::member_count(file, group) : 0);
    hdf5::Handle created = hdf5::create_group(file, path);
    hdf5::write_attribute(created, "number", number);
    return created;
}

void write_support(hid_t file, const RecordedSupport& support) {
    const std::string path = fmt::format("{}/{}", reaction_group, member_name(support.name));
    const hdf5::Handle group = create_numbered(file, reaction_group, path);
    hdf5::write_attribute(group, "name", support.name);
    hdf5::write_attribute(group, "kind", support.kind);
    create_table<Reaction>(file, path);
}

void write_gauge(hid_t file, const RecordedGauge& gauge) {
    const std::string path = fmt::format("{}/{}", gauge_group, gauge.name);
    const hdf5::Handle group = create_numbered(file, gauge_group, path);
    hdf5::write_attribute(group, "sheet", gauge.sheet);
    hdf5::write<Vector3d>(group, "place", std::array{gauge.place}, {"m", "on the sheet at rest"});
    if (gauge.fields.any())
        hdf5::write<Vector3d>(group, "axes", std::array<Vector3d, 2>{gauge.axes.col(0), gauge.axes.col(1)},
                              {"1", "axes of the gauge's face at rest; the first runs along its first side"});
    create_table<GaugeReading>(file, path, [&](const char* column) { return is_recorded(gauge, column); });
}

void write_head(hid_t file, const RecordingHeader& header) {
    hdf5::write_attribute(file, "format", std::string(format));
    hdf5::write_attribute(file, "format_version", version);
    hdf5::write_attribute(file, "sherd_version", std::string(SHERD_VERSION));
    hdf5::write_attribute(file, "sherd_build", build_info());
    hdf5::write_attribute(file, "scene_file", header.scene_file);
    hdf5::write_attribute(file, "seed", header.seed);
    hdf5::write_attribute(file, "time_unit", header.time_unit);
    hdf5::write_attribute(file, "end", std::string("running"));
    hdf5::write_attribute(file, "wall_seconds", 0.0);
    hdf5::write_text(file, "scene", header.scene_text);
    hdf5::write_texts(file, "rest/sheet_names", header.sheet_names);
    write_rest(file, unfractured_mesh(header));
    if (!header.rest_axis.empty())
        write_array(
            file, std::string("rest/") + material_axis,
            {"1", "first axis of the material of each face, a unit vector; 0 where it does not matter"},
            header.rest_axis);
    hdf5::create_group(file, "frames");
    visit_tables([&]<class Row>(std::type_identity<Row>) { create_table<Row>(file); });
    for (const RecordedSupport& support : header.supports) write_support(file, support);
    for (const RecordedGauge& gauge : header.gauges) write_gauge(file, gauge);
}

/// Returns the two axes (frame_axes()) of each face in its current position, [6, F].
Eigen::Matrix<double, 6, Eigen::Dynamic> axes_of_faces(const Snapshot& snapshot) {
    Eigen::Matrix<double, 6, Eigen::Dynamic> axes(6, static_cast<Eigen::Index>(snapshot.faces.size()));
    for (std::size_t f = 0; f < snapshot.faces.size(); ++f)
        axes.col(static_cast<Eigen::Index>(f)) =
            frame_axes(columns(snapshot.position, snapshot.faces[f])).reshaped();
    return axes;
}

void write_fields(hid_t group, const Snapshot& snapshot) {
    if (!choice_of(snapshot.fields).any()) return;
    visit_field_arrays(snapshot.fields, [&](const std::string& name, hdf5::Meaning meaning,
                                            const Eigen::Matrix3Xd& values, bool twice) {
        if (values.size() == 0) return;
        write_array(group, name, meaning, values);
        write_array(group, name + principal_suffix, {meaning.unit, "principal values, the larger one first"},
                    principal_values(values, twice));
    });
    write_array(
        group, "face/axes",
        {"1",
         "axes of the tensors of faces: two unit vectors, along the face's first side in its current "
         "position, and at right angles to it in the face's plane; their cross product is the normal"},
        axes_of_faces(snapshot));
}

/// Writes a frame. same_rest: path of a mesh at rest in the file that equals this frame's; empty if there is
/// none.
void write_frame(hid_t file, std::size_t number, const Snapshot& snapshot, const std::string& same_rest) {
    const hdf5::Handle group = hdf5::create_group(file, frame_group(number));
    hdf5::write_attribute(group, "time", snapshot.time);
    hdf5::write_attribute(group, "step", snapshot.step);
    visit_arrays(snapshot, array_writer(group));
    const VectorXd speed = snapshot.velocity.colwise().norm();
    write_array(group, "vertex/speed", {"m/s"}, speed);
    write_fields(group, snapshot);
    if (same_rest.empty())
        write_rest(group, snapshot.rest);
    else
        hdf5::create_link(group, "rest", same_rest);
}

void add(hid_t file, std::size_t frame, const Snapshot& snapshot, const std::string& same_rest,
         std::span<const StepReport> steps, const CrackEvents& events,
         std::span<const RecordedObstacle> obstacles, const ObstaclePlaces& places,
         const ObstacleShapes& shapes) {
    append_table<StepReport>(file, steps);
    visit_lists([&]<class Row>(std::vector<Row> StepReport::*list, const std::string& group) {
        const std::vector<std::string> tables = numbered_groups(file, group);
        for (std::size_t i = 0; i < tables.size(); ++i) {
            std::vector<Row> rows;
            for (const StepReport& step : steps) rows.push_back((step.*list)[i]);
            append_table<Row>(file, rows, tables[i]);
        }
    });
    visit_kinds(
        [&]<class Event>(std::vector<Event> CrackEvents::*kind) { append_table<Event>(file, events.*kind); });
    write_frame(file, frame, snapshot, same_rest);
    write_places(file, frame, obstacles, places, shapes);
}

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

bool same_bits(const Positions& a, const Positions& b) {
    return a.size() == b.size() &&
           std::memcmp(a.data(), b.data(), static_cast<std::size_t>(a.size()) * sizeof(double)) == 0;
}

bool same_bits(const RestMesh& a, const RestMesh& b) {
    return same_bits(a.position, b.position) && same_bits(a.faces, b.faces) && same_bits(a.area, b.area) &&
           same_bits(a.thickness, b.thickness) && same_bits(a.vertex_parents, b.vertex_parents) &&
           same_bits(a.vertex_weights, b.vertex_weights) && same_bits(a.face_parent, b.face_parent) &&
           same_bits(a.face_mixed, b.face_mixed) && a.look == b.look;
}

void write_modes(hid_t file, std::span<const RecordedMode> modes, const std::string& times) {
    const hdf5::Handle group = hdf5::create_group(file, mode_group);
    std::vector<double> frequency, growth, shape;
    for (const RecordedMode& mode : modes) {
        frequency.push_back(mode.frequency);
        growth.push_back(mode.growth);
        shape.insert(shape.end(), mode.shape.data(), mode.shape.data() + mode.shape.size());
    }
    hdf5::write<double>(group, "frequency", frequency, {"Hz", "0: the mode is unstable"});
    hdf5::write<double>(group, "growth", growth, {"1/s", "rate of an unstable mode; 0: it is stable"});
    const hsize_t vertices = modes.empty() ? 0 : modes.front().shape.cols();
    hdf5::create_array(group, "shape", H5T_NATIVE_DOUBLE, std::array<hsize_t, 3>{modes.size(), vertices, 3},
                       shape.data(),
                       {"kg^-1/2", "displacement of each vertex; the sum of mass times its square is 1"});
    hdf5::write_attribute(file, "times", times);
}

std::vector<XdmfObstacle> xdmf_obstacles(std::span<const RecordedObstacle> obstacles) {
    std::vector<XdmfObstacle> result;
    for (const RecordedObstacle& obstacle : obstacles)
        result.push_back({obstacle.name, obstacle.surface.points.size(), obstacle.surface.triangles.size()});
    return result;
}

XdmfFrame index_entry(const Snapshot& snapshot, const ObstaclePlaces& places) {
    XdmfFrame entry{snapshot.time, static_cast<std::size_t>(snapshot.position.cols()), snapshot.faces.size(),
                    snapshot.edges.size(), places.points};
    visit_fields(snapshot.fields, [&](const char* name, const Eigen::Matrix3Xd& values, const FieldMeaning&) {
        if (values.size() > 0) entry.fields.push_back(name);
    });
    return entry;
}

/// Whether an index with `indexed` frames is to be renewed when there are `frames` frames. Each renewal
/// writes the whole index, and would dominate long runs if it came with every frame.
bool index_is_due(std::size_t frames, std::size_t indexed) {
    return frames >= indexed + std::max<std::size_t>(1, indexed / 100);
}

/// Creates a recording without frames, and returns its path. rows: receives the number of rows of each table.
const std::filesystem::path& create(const RecordingOutput& output, const RecordingHeader& header,
                                    std::span<const RecordedObstacle> obstacles,
                                    std::vector<std::size_t>& rows) {
    PendingFile pending(output.recording, Fault::input);
    hdf5::write_new(pending, [&](hid_t created) {
        write_head(created, header);
        write_obstacles(created, obstacles);
        rows = extent(created);
    });
    remove_journal(output.recording.output());  // journal of the file that is replaced
    pending.publish(output.force);
    std::error_code ignored;
    std::filesystem::remove(output.index.output(), ignored);
    return output.recording.output();
}

}  // namespace

RecordingOutput::RecordingOutput(const std::filesystem::path& file, bool force, std::string_view permission)
    : recording(file), index(index_of(file)), force(force) {
    check_free(recording.output(), force, {}, permission);
    check_free(index.output(), force, {}, permission);
}

RecordingWriter::RecordingWriter(RecordingOutput output_, const RecordingHeader& header,
                                 std::span<const RecordedObstacle> obstacles_, bool resumes)
    : output(std::move(output_)),
      recording(resumes ? output.recording.output() : create(output, header, obstacles_, rows)),
      obstacles(obstacles_.begin(), obstacles_.end()),
      places(first_places(obstacles_)),
      supports(header.supports.size()),
      gauges(header.gauges.size()),
      rest(unfractured_mesh(header)),
      unfractured_vertices(static_cast<std::size_t>(header.rest_position.cols())),
      time_unit(header.time_unit) {}

RecordingWriter::RecordingWriter(const std::filesystem::path& file, const RecordingHeader& header, bool force,
                                 std::span<const RecordedObstacle> obstacles)
    : RecordingWriter(RecordingOutput(file, force), header, obstacles) {}

void RecordingWriter::append(const Snapshot& snapshot, std::span<const StepReport> steps,
                             const CrackEvents& events, std::span<const Eigen::Isometry3d> poses,
                             const ObstacleShapes& shapes) try {
    if (const std::string what = inconsistency(snapshot, unfractured_vertices); !what.empty())
        throw Error(what, Fault::run);
    if (!same_bits(snapshot.rest.unfractured_faces, rest.unfractured_faces))
        throw Error("its unbroken mesh is not that of /rest", Fault::run);
    for (const StepReport& step : steps)
        if (step.reactions.size() != supports || step.gauges.size() != gauges)
            throw Error(fmt::format("step {} has {} reactions and {} gauges, the header {} and {}", step.step,
                                    step.reactions.size(), step.gauges.size(), supports, gauges),
                        Fault::run);
    ObstaclePlaces next = next_places(places, frames.size(), obstacles, poses, shapes);
    frames.push_back(index_entry(snapshot, next));
    try {
        record(snapshot, steps, events, std::move(next), shapes);
    } catch (...) {
        frames.pop_back();
        throw;
    }
} catch (const Error& error) {
    throw Error(fmt::format("cannot record frame {} ({}): {}; the frames before it in '{}' stay readable",
                            frames.size(), time_text(fmt::format("{:g}", snapshot.time), time_unit),
                            error.what(), file().string()),
                Fault::run);
}

void RecordingWriter::record(const Snapshot& snapshot, std::span<const StepReport> steps,
                             const CrackEvents& events, ObstaclePlaces next, const ObstacleShapes& shapes) {
    const std::size_t number = frames.size() - 1;
    const bool new_rest = !same_bits(snapshot.rest, rest);
    std::vector<std::size_t> longer_rows;
    // The index is written before the recording changes, since that may fail on a full disk; publish() only
    // renames the index.
    std::optional<PendingFile> index;
    if (index_is_due(frames.size(), indexed)) write_index(index.emplace(output.index, Fault::run));
    hdf5::change(recording, [&](hid_t opened) {
        add(opened, number, snapshot, new_rest ? "" : rest_path, steps, events, obstacles, next, shapes);
        longer_rows = extent(opened);
    });
    rows = std::move(longer_rows);
    if (new_rest) {
        rest = snapshot.rest;
        rest_path = "/" + frame_group(number) + "/rest";
    }
    places = std::move(next);
    if (!index) return;
    index->publish(true);
    indexed = frames.size();
}

void RecordingWriter::write_index(PendingFile& index) const {
    index.write([this](std::ostream& out) {
        write_xdmf(out, file().filename().string(), frames, xdmf_obstacles(obstacles));
    });
}

void RecordingWriter::add_modes(std::span<const RecordedMode> modes, const std::string& times) try {
    for (const RecordedMode& mode : modes)
        if (mode.shape.cols() != rest.position.cols())
            throw Error("a mode's shape has another number of vertices than the sheets");
    hdf5::change(recording, [&](hid_t opened) { write_modes(opened, modes, times); });
} catch (const Error& error) {
    throw Error(fmt::format("cannot record the modes in '{}': {}", file().string(), error.what()),
                Fault::run);
}

void RecordingWriter::visit_state(StateVisitor& visit) {
    auto& [output, rows, recording, frames, indexed, obstacles, places, supports, gauges, rest, rest_path,
           unfractured_vertices, time_unit] = *this;
    visit(frames, places, rest, rest_path, rows);
}

void RecordingWriter::resume(const std::string& scene_text) try {
    PendingFile index(output.index, Fault::run);
    write_index(index);
    hdf5::change(recording, [&](hid_t opened) {
        cut(opened, frames.size(), rows);
        hdf5::write_attribute(opened, "end", std::string("running"));
        if (hdf5::read_text(opened, "scene") == scene_text) return;
        hdf5::remove(opened, "scene");
        hdf5::write_text(opened, "scene", scene_text);
    });
    index.publish(true);
    indexed = frames.size();
} catch (const Error& error) {
    throw Error(fmt::format("cannot continue '{}': {}", file().string(), error.what()), Fault::run);
}

void RecordingWriter::finish(double wall_seconds, const std::string& end) {
    PendingFile index(output.index, Fault::run);
    write_index(index);
    // The index is published before the recording is marked as complete: a complete run is not resumed, so
    // nothing would renew its index.
    index.publish(true);
    indexed = frames.size();
    hdf5::change(recording, [&](hid_t opened) {
        hdf5::write_attribute(opened, "wall_seconds", wall_seconds);
        hdf5::write_attribute(opened, "end", end);
    });
}

}  // namespace sherd
