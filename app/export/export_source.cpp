// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/export_source.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/export/broken_sides.h"
#include "app/export/corner_normals.h"
#include "app/export/export_sheet.h"
#include "app/files/pending_file.h"
#include "app/progress/interruption.h"
#include "meshops/body_check.h"
#include "meshops/error.h"
#include "meshops/thicken.h"

namespace sherd {

namespace {

namespace fs = std::filesystem;

}  // namespace

ExportSource::ExportSource(const ExportOptions& options_, const std::string& extension, bool all_frames)
    : options(options_), recording(options.recording), playback(recording) {
    if (!recording.recovery().empty()) warnings.push_back(recording.recovery());
    const std::string wanted = !options.frames.empty() ? options.frames : all_frames ? "all" : "last";
    chosen = selected_frames(wanted, recording.frame_count());
    const RecordingHeader header = recording.header();
    with_materials =
        !header.rest_look.material.empty() || (options.solid && !header.rest_look.texture.empty());
    if (!options.sheets_only) solids = export_obstacles(recording, chosen);
    fs::path output = options.output;
    if (output.empty()) output = fs::path(options.recording).replace_extension(extension);
    const std::string given = output.extension().string();
    single = given == extension && chosen.size() == 1;
    stem = given == extension ? output.replace_extension() : output / options.recording.stem();
    require_kind(options.output, extension,
                 fmt::format("the extension does not fit --to {}; name a {} file or a folder", options.format,
                             extension));
}

const Snapshot& ExportSource::frame(std::size_t number) {
    if (interrupted()) throw Error("interrupted", Fault::run);
    if (loaded == number) return current;
    loaded.reset();
    current = recording.frame(number);
    loaded = number;
    return current;
}

std::vector<double> ExportSource::times() const {
    std::vector<double> times;
    for (const std::size_t number : chosen) times.push_back(recording.time(number));
    return times;
}

Pace ExportSource::pace() const {
    return pace_of(options.slow, recording.time(chosen.back()) - recording.time(chosen.front()));
}

std::vector<double> ExportSource::thickness(const Snapshot& frame) const {
    if (options.thickness) return std::vector<double>(frame.faces.size(), *options.thickness);
    if (frame.rest.thickness.empty())
        throw Error(
            fmt::format("'{}' does not say how thick its sheets are, it was made by an earlier version; give "
                        "--thickness, in m",
                        options.recording.string()));
    return frame.rest.thickness;
}

const TriangleSheet& ExportSource::sheet(std::size_t number) {
    if (made == number) return current_sheet;
    made.reset();
    const Snapshot& shown = frame(number);
    current_sheet = frame_sheet(shown);
    current_sheet.quality = face_quality(shown, options.quality);
    if (options.solid) {
        current_sheet = thickened(current_sheet, thickness(shown), shown.original);
        finish_broken_sides(shown, thickness(shown), has_materials(), current_sheet);
        current_sheet.normal = corner_normals(current_sheet.points, current_sheet);
        check_bodies(number);
    }
    made = number;
    return current_sheet;
}

void ExportSource::check_bodies(std::size_t number) {
    for (std::size_t i = 0; i < current_sheet.group_names.size(); ++i) {
        const BodyCheck check = check_body(group_part(current_sheet, static_cast<std::int32_t>(i)));
        if (check.closed && check.intersections.empty()) continue;
        warnings.push_back(fmt::format("frame {}: the body of {} {}", number, fragment_name(i),
                                       check.closed ? fmt::format("intersects itself ({} pairs of triangles)",
                                                                  check.intersections.size())
                                                    : "is not closed"));
    }
}

std::vector<Eigen::Isometry3d> ExportSource::poses(const PlaybackTime& moment) const {
    if (interrupted()) throw Error("interrupted", Fault::run);
    return playback.at(moment);
}

std::vector<Eigen::Isometry3d> ExportSource::poses(std::size_t frame) const {
    return poses(PlaybackTime{frame, frame, 0, recording.time(frame)});
}

ObstacleShapes ExportSource::shapes(std::size_t frame) const {
    return recording.shapes(frame);
}

TriangleSheet ExportSource::obstacle(std::size_t i, std::size_t frame) const {
    return obstacle(i, PlaybackTime{frame, frame, 0, recording.time(frame)});
}

TriangleSheet ExportSource::obstacle(std::size_t i, const PlaybackTime& moment) const {
    const ExportObstacle& solid = obstacles()[i];
    if (!solid.deforms) return placed(solid.surface, poses(moment)[i]);
    return placed(reshaped(solid.surface, playback.shapes(moment)[i]), poses(moment)[i]);
}

std::string ExportSource::obstacle_suffix(std::size_t i, const std::string& extension) const {
    return "_" + solids[i].name + extension;
}

fs::path ExportSource::clip_file(const std::string& extension) const {
    return stem.string() + extension;
}

fs::path ExportSource::numbered_file(std::size_t frame, const std::string& extension) const {
    return fmt::format("{}_{:06}{}", stem.string(), frame, extension);
}

fs::path ExportSource::frame_file(std::size_t frame, const std::string& extension) const {
    return single ? clip_file(extension) : numbered_file(frame, extension);
}

}  // namespace sherd
