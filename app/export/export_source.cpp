// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/export_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <span>

#include "app/export/corner_normals.h"
#include "app/export/export_sheet.h"
#include "app/files/disk/pending_file.h"
#include "app/progress/interruption.h"
#include "app/render/render_solid.h"
#include "fracture/record/snapshot.h"
#include "meshops/error.h"
#include "meshops/read_write/write_mesh.h"
#include "meshops/solid/body_check.h"
#include "meshops/solid/thicken.h"

namespace sherd {
namespace {

/// A side of a face that a crack has opened. In the body it is a quadrilateral of two triangles.
struct BrokenSide {
    Index from, to;            ///< vertices of the frame
    double length, thickness;  ///< m
    std::size_t triangle;      ///< index of the first of the two triangles in the body
    double start = -1;         ///< m, texture coordinate u at the end `from`; below 0: not known yet
};

std::vector<BrokenSide> broken_sides(const Snapshot& frame, std::span<const double> thickness) {
    const auto open = open_edges(frame.faces), rim = rim_edges(frame.rest);
    std::vector<BrokenSide> sides;
    std::size_t triangle = 2 * frame.faces.size();
    for (std::size_t f = 0; f < frame.faces.size(); ++f)
        for (int k = 0; k < 3; ++k) {
            if (!open[f][k]) continue;
            triangle += 2;
            if (rim[f][k]) continue;
            const Index from = frame.faces[f][k], to = frame.faces[f][(k + 1) % 3];
            const Vector3d side =
                frame.rest.position.col(frame.original[to]) - frame.rest.position.col(frame.original[from]);
            sides.push_back({from, to, side.norm(), thickness[f], triangle - 2});
        }
    return sides;
}

/// Sets `start` of all sides, such that the texture coordinate u is continuous along each row of sides. It is
/// 0 where a row begins; a row that is a closed loop begins at any of its sides.
void set_starts(std::vector<BrokenSide>& sides) {
    std::map<Index, std::size_t> at;
    std::map<Index, int> ends;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        at[sides[i].from] = i;
        ++ends[sides[i].to];
    }
    const auto follow = [&](std::size_t i) {
        double u = 0;
        for (auto next = at.find(sides[i].from); next != at.end() && sides[next->second].start < 0;) {
            BrokenSide& side = sides[next->second];
            side.start = u;
            u += side.length;
            next = at.find(side.to);
        }
    };
    for (std::size_t i = 0; i < sides.size(); ++i)
        if (!ends.contains(sides[i].from)) follow(i);
    for (std::size_t i = 0; i < sides.size(); ++i)
        if (sides[i].start < 0) follow(i);
}

void give_material(std::vector<BrokenSide>& sides, std::size_t points, TriangleSheet& body) {
    const FaceMaterial inside =
        std::make_shared<const SurfaceMaterial>(SurfaceMaterial{"inside", "Kd 0.8 0.8 0.8\n"});
    const Eigen::Vector2d zero = Eigen::Vector2d::Zero();
    body.look.material.resize(body.triangles.size());
    if (body.look.texture.empty()) body.look.texture.assign(body.triangles.size(), {zero, zero, zero});
    set_starts(sides);
    const auto count = static_cast<std::int32_t>(points);
    for (const BrokenSide& side : sides)
        for (const std::size_t t : {side.triangle, side.triangle + 1}) {
            body.look.material[t] = inside;
            for (int k = 0; k < 3; ++k) {
                const std::int32_t point = body.triangles[t][k];
                const bool is_end = point % count == side.to;
                body.look.texture[t][k] = {side.start + (is_end ? side.length : 0),
                                           point < count ? side.thickness : 0};
            }
        }
}

/// Shades the sides of a solid along cracks flat. If `with_materials`, gives these sides a material of their
/// own, `inside`, and texture coordinates in m: u along the side at rest, continuous from face to face, and v
/// through the thickness, from 0 at the lower surface of the sheet. Other triangles keep their material and
/// texture coordinates, if any. body: result of thickened() for the frame's faces; thickness: [F] m.
void finish_broken_sides(const Snapshot& frame, std::span<const double> thickness, bool with_materials,
                         TriangleSheet& body) {
    std::vector<BrokenSide> sides = broken_sides(frame, thickness);
    for (const BrokenSide& side : sides)
        for (const std::size_t t : {side.triangle, side.triangle + 1}) body.shading[t] = Shading::broken;
    if (with_materials) give_material(sides, static_cast<std::size_t>(frame.position.cols()), body);
}

}  // namespace

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
