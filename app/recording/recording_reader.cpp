// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <new>
#include <sstream>
#include <stdexcept>

#include "app/recording/hdf5_file.h"
#include "app/recording/recording.h"
#include "app/recording/recording_table.h"
#include "meshops/shared_values.h"

namespace sherd {

namespace {

using namespace recording_format;

template <int N>
void read_array(hid_t where, const std::string& name, Eigen::Matrix<double, N, Eigen::Dynamic>& values) {
    values.resize(N, static_cast<Eigen::Index>(hdf5::row_count(where, name, N)));
    hdf5::read_array(where, name, H5T_NATIVE_DOUBLE, N, values.data());
}

void read_array(hid_t where, const std::string& name, VectorXd& values) {
    values.resize(static_cast<Eigen::Index>(hdf5::row_count(where, name, 1)));
    hdf5::read_array(where, name, H5T_NATIVE_DOUBLE, 1, values.data());
}

template <class T>
void read_array(hid_t where, const std::string& name, std::vector<T>& values) {
    values = hdf5::read<T>(where, name);
}

/// Returns a flag for each obstacle from the dataset `name`; zeros if an older recording lacks the dataset.
/// obstacles: number of obstacles.
std::vector<std::uint8_t> flags(hid_t file, const char* name, std::size_t obstacles) {
    if (!hdf5::contains(file, name)) return std::vector<std::uint8_t>(obstacles, 0);
    std::vector<std::uint8_t> flags = hdf5::read<std::uint8_t>(file, name);
    if (flags.size() != obstacles)
        throw Error(fmt::format("{} has {} rows of {} obstacles", name, flags.size(), obstacles));
    return flags;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

void read_rows(hid_t where, const std::string& name, std::vector<std::vector<std::string>>& rows) {
    for (const std::string& names : hdf5::read_texts(where, names_of(name))) rows.push_back(lines_of(names));
}

void read_rows(hid_t where, const std::string& name, std::vector<SurfaceMaterial>& rows) {
    const std::string name_list = names_of(name), definition_list = definitions_of(name);
    const std::vector<std::string> names = hdf5::read_texts(where, name_list),
                                   definitions = hdf5::read_texts(where, definition_list);
    if (names.size() != definitions.size())
        throw Error(fmt::format("{} and {} differ in length", name_list, definition_list));
    for (std::size_t i = 0; i < names.size(); ++i) rows.push_back({names[i], definitions[i]});
}

/// Reads pointers to shared values; throws Error if they refer to a row that does not exist.
template <class T>
void read_array(hid_t where, const std::string& name, std::vector<std::shared_ptr<const T>>& values) {
    SharedValues<T> shared{.rows = {}, .number = hdf5::read<Index>(where, name)};
    if (!shared.number.empty()) read_rows(where, name, shared.rows);
    if (std::ranges::any_of(shared.number, [&](Index row) {
            return row < -1 || row >= static_cast<Index>(shared.rows.size());
        }))
        throw Error(fmt::format("{} names a row that does not exist", name));
    values = listed(shared);
}

/// Reads the look in the group `rest` below `where`.
void read_look(hid_t where, SurfaceLook& look) {
    visit_recorded_attributes([&](const auto& attribute) {
        const std::string name = std::string("rest/") + attribute.recorded;
        if (hdf5::contains(where, name)) read_array(where, name, look.*attribute.list);
    });
}

void read_unbroken_mesh(hid_t file, RecordingHeader& header) {
    read_array(file, "rest/position", header.rest_position);
    read_array(file, "rest/faces", header.rest_faces);
    read_array(file, "rest/area", header.rest_area);
    if (hdf5::contains(file, "rest/thickness")) read_array(file, "rest/thickness", header.rest_thickness);
    const std::string axis = std::string("rest/") + material_axis;
    if (hdf5::contains(file, axis)) read_array(file, axis, header.rest_axis);
    read_look(file, header.rest_look);
    if (const std::string what = inconsistency(header); !what.empty()) throw Error(what);
}

RestMesh read_unbroken_mesh(hid_t file) {
    RecordingHeader header;
    read_unbroken_mesh(file, header);
    return unfractured_mesh(header);
}

/// Returns a function that reads an array of a snapshot from the group of its frame.
auto array_reader(hid_t frame) {
    return [frame](const SnapshotArray& array, auto& values) {
        if (array.presence != Presence::if_any || hdf5::contains(frame, array.name))
            read_array(frame, array.name, values);
    };
}

/// Reads the mesh at rest of a frame.
RestMesh read_rest(hid_t file, hid_t frame) {
    RestMesh rest;
    visit_rest_arrays(rest, array_reader(frame));
    read_look(frame, rest.look);
    read_array(file, "rest/faces", rest.unfractured_faces);
    read_array(file, "rest/position", rest.unfractured_position);
    if (rest.thickness.empty() && hdf5::row_count(file, "rest/thickness", 1) > 0)
        throw Error("rest/thickness is empty");
    return rest;
}

/// Reads which readings of a gauge are recorded, and the axes of its fields.
void read_choice(hid_t group, RecordedGauge& gauge) {
    gauge.displacement = hdf5::contains(group, "displacement");
    gauge.fields = {.stress = hdf5::contains(group, "stress_top"),
                    .curvature = hdf5::contains(group, "curvature"),
                    .membrane_strain = hdf5::contains(group, "membrane_strain")};
    if (!gauge.fields.any()) return;
    const std::vector<Vector3d> axes = hdf5::read<Vector3d>(group, "axes");
    if (axes.size() != 2) throw Error("the axes of the gauge '" + gauge.name + "' are not two");
    gauge.axes << axes[0], axes[1];
}

/// Reads the fields of faces that a frame has.
FaceFields read_fields(hid_t frame) {
    FaceFields fields;
    visit_field_arrays(fields, [&](const std::string& name, hdf5::Meaning, Eigen::Matrix3Xd& values, bool) {
        if (hdf5::contains(frame, name)) read_array(frame, name, values);
    });
    if (fields.stress_top.cols() != fields.stress_bottom.cols())
        throw Error("face/stress_top and face/stress_bottom differ in length");
    return fields;
}

std::pair<dev_t, ino_t> identity_of(const std::filesystem::path& file) {
    struct stat status {};
    stat(file.c_str(), &status);
    return {status.st_dev, status.st_ino};
}

bool is_recording(hid_t file) {
    try {
        return hdf5::read_text_attribute(file, "format") == format;
    } catch (const Error&) {
        return false;
    }
}

}  // namespace

template <class Read>
auto Recording::read_with(Read read) const {
    const hdf5::ReadableFile opened(file);
    if (identity_of(file) != identity)
        throw Error(
            fmt::format("the recording '{}' has been replaced by another run while it was read; start again",
                        file.string()));
    const auto damaged = [&](const char* how) {
        return Error(fmt::format("the recording '{}' is damaged: {}", file.string(), how));
    };
    try {
        return read(static_cast<hid_t>(opened));
    } catch (const Error& error) {
        throw damaged(error.what());
    } catch (const std::bad_alloc&) {
        throw damaged("a length in it needs more memory than there is");
    } catch (const std::length_error&) {
        throw damaged("a length in it is too large for any memory");
    }
}

Recording::Recording(const std::filesystem::path& file)
    : file(file), recovery_message(recover(file)), identity(identity_of(file)) {
    const hdf5::ReadableFile opened(file);
    if (!is_recording(opened))
        throw Error(
            fmt::format("'{}' is an HDF5 file, but not a recording written by 'sherd run'", file.string()));
    version = hdf5::read_integer_attribute(opened, "format_version");
    if (version < oldest_version || version > recording_format::version)
        throw Error(fmt::format(
            "'{}' has format version {}, this program reads versions {} to {}; use the sherd that "
            "wrote it",
            file.string(), version, oldest_version, recording_format::version));
}

std::string RecordedMode::words() const {
    return growth > 0 ? fmt::format("unstable, grows e-fold in {:.5g} s", 1 / growth)
                      : fmt::format("{:.5g} Hz", frequency);
}

RecordingHeader Recording::header() const {
    return read_with([](hid_t opened) {
        RecordingHeader header;
        header.scene_file = hdf5::read_text_attribute(opened, "scene_file");
        header.scene_text = hdf5::read_text(opened, "scene");
        header.seed = hdf5::read_integer_attribute(opened, "seed");
        if (hdf5::has_attribute(opened, "time_unit"))
            header.time_unit = hdf5::read_text_attribute(opened, "time_unit");
        header.sheet_names = hdf5::read_texts(opened, "rest/sheet_names");
        read_unbroken_mesh(opened, header);
        for (const std::string& path : numbered_groups(opened, reaction_group)) {
            const hdf5::Handle group = hdf5::open_group(opened, path);
            header.supports.push_back(
                {hdf5::read_text_attribute(group, "name"), hdf5::read_text_attribute(group, "kind")});
        }
        for (const std::string& path : numbered_groups(opened, gauge_group)) {
            const hdf5::Handle group = hdf5::open_group(opened, path);
            const std::vector<Vector3d> place = hdf5::read<Vector3d>(group, "place");
            if (place.size() != 1) throw Error(path + "/place is not one point");
            header.gauges.push_back(
                {path.substr(path.rfind('/') + 1), hdf5::read_text_attribute(group, "sheet"), place.front()});
            read_choice(group, header.gauges.back());
        }
        return header;
    });
}

std::size_t Recording::frame_count() const {
    return read_with([](hid_t opened) { return hdf5::member_count(opened, "frames"); });
}

Snapshot Recording::frame(std::size_t number) const {
    return read_with([this, number](hid_t opened) {
        Snapshot snapshot;
        const hdf5::Handle group = hdf5::open_group(opened, frame_group(number));
        snapshot.time = hdf5::read_real_attribute(group, "time");
        snapshot.step = hdf5::read_integer_attribute(group, "step");
        visit_arrays(snapshot, array_reader(group));
        snapshot.fields = read_fields(group);
        snapshot.rest = version < 3 ? read_unbroken_mesh(opened) : read_rest(opened, group);
        const std::size_t unfractured_vertices = hdf5::row_count(opened, "rest/position", 3);
        if (const std::string what = inconsistency(snapshot, unfractured_vertices); !what.empty())
            throw Error(fmt::format("frame {}: {}", number, what));
        return snapshot;
    });
}

FaceFields Recording::fields(std::size_t number) const {
    return read_with(
        [number](hid_t opened) { return read_fields(hdf5::open_group(opened, frame_group(number))); });
}

double Recording::time(std::size_t number) const {
    return read_with([number](hid_t opened) {
        return hdf5::read_real_attribute(hdf5::open_group(opened, frame_group(number)), "time");
    });
}

std::vector<RecordedObstacle> Recording::obstacles() const {
    return read_with([](hid_t opened) {
        std::vector<RecordedObstacle> obstacles;
        if (!hdf5::contains(opened, "obstacles")) return obstacles;
        for (const std::string& name : hdf5::read_texts(opened, "obstacles/names")) {
            const hdf5::Handle group = hdf5::open_group(opened, obstacle_group(obstacles.size()));
            obstacles.push_back({name, {}});
            read_array(group, "position", obstacles.back().surface.points);
            read_array(group, "face", obstacles.back().surface.triangles);
            if (const std::string what = inconsistency(obstacles.back()); !what.empty()) throw Error(what);
        }
        const auto planes = flags(opened, obstacle_planes, obstacles.size());
        const auto deforms = flags(opened, obstacle_deforms, obstacles.size());
        for (std::size_t i = 0; i < obstacles.size(); ++i) {
            obstacles[i].plane = planes[i] != 0;
            obstacles[i].deforms = deforms[i] != 0;
            if (obstacles[i].plane && obstacles[i].surface.triangles.empty())
                throw Error(fmt::format("the plane '{}' has no face", obstacles[i].name));
        }
        return obstacles;
    });
}

ObstacleShapes Recording::shapes(std::size_t number) const {
    return read_with([number](hid_t opened) {
        if (!hdf5::contains(opened, "obstacles")) return ObstacleShapes();
        ObstacleShapes shapes(hdf5::read_texts(opened, "obstacles/names").size());
        const std::vector<std::uint8_t> deforms = flags(opened, obstacle_deforms, shapes.size());
        for (std::size_t i = 0; i < shapes.size(); ++i) {
            if (deforms[i] == 0) continue;
            read_array(opened, obstacle_points(number, i), shapes[i]);
            const hsize_t points = hdf5::row_count(opened, obstacle_points(i), 3);
            if (shapes[i].size() != points)
                throw Error(fmt::format("frame {} has {} points of the obstacle {}, which has {}", number,
                                        shapes[i].size(), i, points));
        }
        return shapes;
    });
}

std::vector<Eigen::Isometry3d> Recording::poses(std::size_t number) const {
    return read_with([number](hid_t opened) {
        std::vector<Eigen::Isometry3d> poses;
        if (!hdf5::contains(opened, "obstacles")) return poses;
        const auto stored = hdf5::read<StoredPose>(opened, frame_group(number) + "/obstacle/pose");
        const std::size_t obstacles = hdf5::read_texts(opened, "obstacles/names").size();
        if (stored.size() != obstacles)
            throw Error(
                fmt::format("frame {} has {} poses of {} obstacles", number, stored.size(), obstacles));
        for (const StoredPose& rows : stored) {
            poses.push_back(Eigen::Isometry3d::Identity());
            poses.back().affine() =
                Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(rows.data());
        }
        return poses;
    });
}

std::vector<StepReport> Recording::steps() const {
    return read_with([](hid_t opened) {
        std::vector<StepReport> steps = read_table<StepReport>(opened);
        visit_lists([&]<class Row>(std::vector<Row> StepReport::*list, const std::string& group) {
            for (const std::string& path : numbered_groups(opened, group)) {
                const std::vector<Row> rows = read_table<Row>(opened, path);
                // Steps that are not in all tables yet are left out.
                steps.resize(std::min(steps.size(), rows.size()));
                for (std::size_t i = 0; i < steps.size(); ++i) (steps[i].*list).push_back(rows[i]);
            }
        });
        return steps;
    });
}

CrackEvents Recording::events() const {
    return read_with([this](hid_t opened) {
        CrackEvents events;
        visit_kinds([&]<class Event>(std::vector<Event> CrackEvents::*kind) {
            if (version >= Table<Event>::since) events.*kind = read_table<Event>(opened);
        });
        return events;
    });
}

bool Recording::has_balance() const {
    return read_with(
        [](hid_t opened) { return hdf5::contains(opened, column(Table<StepReport>::group, "unexplained")); });
}

std::vector<RecordedMode> Recording::modes() const {
    return read_with([](hid_t opened) {
        std::vector<RecordedMode> modes;
        if (!hdf5::contains(opened, mode_group)) return modes;
        const hdf5::Handle group = hdf5::open_group(opened, mode_group);
        const auto frequency = hdf5::read<double>(group, "frequency"),
                   growth = hdf5::read<double>(group, "growth");
        const std::vector<hsize_t> shape = hdf5::shape_of(group, "shape");
        const hsize_t vertices = hdf5::row_count(opened, "rest/position", 3);
        if (shape != std::vector<hsize_t>{frequency.size(), vertices, 3} || growth.size() != frequency.size())
            throw Error("frequency, growth and shape of modes differ in length");
        std::vector<double> values(3 * vertices * frequency.size());
        if (!values.empty()) hdf5::read_array(group, "shape", H5T_NATIVE_DOUBLE, values.data());
        for (std::size_t i = 0; i < frequency.size(); ++i)
            modes.push_back({frequency[i], growth[i],
                             Eigen::Map<const Positions>(values.data() + 3 * vertices * i, 3,
                                                         static_cast<Eigen::Index>(vertices))});
        return modes;
    });
}

double Recording::wall_seconds() const {
    return read_with([](hid_t opened) { return hdf5::read_real_attribute(opened, "wall_seconds"); });
}

std::string Recording::end() const {
    return read_with([](hid_t opened) { return hdf5::read_text_attribute(opened, "end"); });
}

}  // namespace sherd
