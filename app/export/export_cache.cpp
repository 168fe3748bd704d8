// SPDX-License-Identifier: GPL-3.0-or-later
// Point caches at an even rate, pc2 and mdd: of the sheets, whose topology is that of the last frame, and of
// each obstacle that moves.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <functional>
#include <memory>

#include "app/export/export_clip.h"
#include "app/export/export_formats.h"
#include "meshops/material_library.h"

namespace sherd {

namespace {

template <class T>
void append(std::string& bytes, T value, std::endian order) {
    char part[sizeof value];
    std::memcpy(part, &value, sizeof value);
    if (order != std::endian::native) std::reverse(part, part + sizeof value);
    bytes.append(part, sizeof value);
}

/// What a cache holds: the places of the same points at several moments.
struct PointTrack {
    TriangleSheet mesh;         ///< that the cache goes with, without its points
    std::vector<double> times;  ///< s, of the samples, as they are shown
    std::function<std::vector<Vector3d>(std::size_t)> points;  ///< [P] m, of a sample
};

void append_points(std::string& bytes, const std::vector<Vector3d>& points, std::endian order) {
    for (const Vector3d& point : points)
        for (const double coordinate : point) append(bytes, static_cast<float>(coordinate), order);
}

/// A head of name, version, points, start, frames a sample and samples; little endian.
std::string pc2_bytes(const PointTrack& track) {
    std::string bytes("POINTCACHE2\0", 12);
    append(bytes, std::int32_t{1}, std::endian::little);
    append(bytes, static_cast<std::int32_t>(track.points(0).size()), std::endian::little);
    append(bytes, 0.0F, std::endian::little);
    append(bytes, 1.0F, std::endian::little);
    append(bytes, static_cast<std::int32_t>(track.times.size()), std::endian::little);
    for (std::size_t i = 0; i < track.times.size(); ++i)
        append_points(bytes, track.points(i), std::endian::little);
    return bytes;
}

/// A head of samples, points and the samples' times in s, as they are shown; big endian.
std::string mdd_bytes(const PointTrack& track) {
    std::string bytes;
    append(bytes, static_cast<std::int32_t>(track.times.size()), std::endian::big);
    append(bytes, static_cast<std::int32_t>(track.points(0).size()), std::endian::big);
    for (const double time : track.times) append(bytes, static_cast<float>(time), std::endian::big);
    for (std::size_t i = 0; i < track.times.size(); ++i)
        append_points(bytes, track.points(i), std::endian::big);
    return bytes;
}

/// The mesh that the cache goes with, in the shape of the first sample.
std::string mesh_of(const PointTrack& track, const std::filesystem::path& file) {
    TriangleSheet sheet = track.mesh;
    sheet.points = track.points(0);
    return mesh_bytes(sheet, file);
}

/// Plans caches of one format.
struct CachePlan {
    ExportSource& source;
    const char* extension;
    std::string (*content)(const PointTrack& track);
    std::vector<ExportJob> jobs = {};

    /// A mesh, and its cache unless it rests.
    void add(const PointTrack& track, const std::string& suffix, bool moves) {
        const std::filesystem::path mesh = source.clip_file(suffix + ".obj");
        if (has_material_file(track.mesh, mesh))
            jobs.push_back(
                {material_file(mesh), [track, mesh] { return material_text(track.mesh.material, mesh); }});
        jobs.push_back({mesh, [track, mesh] { return mesh_of(track, mesh); }});
        if (!moves) return;
        jobs.push_back(
            {source.clip_file(suffix + extension), [track, content = content] { return content(track); }});
    }
};

/// The last frame's topology.
PointTrack sheet_track(const std::shared_ptr<Clip>& clip, const std::vector<double>& times) {
    TriangleSheet mesh;
    mesh.triangles = clip->topology().triangles;
    mesh.texture = clip->topology().texture;
    mesh.material = clip->topology().material;
    mesh.named_groups = clip->topology().named_groups;
    return {mesh, times, [clip](std::size_t i) { return clip->points(i); }};
}

PointTrack obstacle_track(const ExportSource& source, std::size_t number, const std::vector<Moment>& moments,
                          const std::vector<double>& times) {
    const GridSurface& surface = source.obstacles()[number].surface;
    TriangleSheet mesh;
    mesh.triangles = surface.triangles;
    return {mesh, times, [&source, &surface, number, moments](std::size_t i) {
                return placed(surface, source.poses(moments[i])[number]).points;
            }};
}

std::vector<ExportJob> plan_cache(ExportSource& source, const char* extension,
                                  std::string (*content)(const PointTrack& track)) {
    const Pace pace = source.pace();
    const std::vector<Moment> moments = even_moments(source.frames(), source.times(), pace.step());
    if (source.frames().size() > 1)
        source.pace_words =
            fmt::format("{}, {} samples at {:g} a second", pace.words(), moments.size(), pace.rate);
    std::vector<double> times;
    for (const Moment& moment : moments)
        times.push_back(pace.slowdown * (moment.time - moments.front().time));
    CachePlan plan{source, extension, content};
    plan.add(sheet_track(std::make_shared<Clip>(source, moments), times), "", true);
    for (std::size_t i = 0; i < source.obstacles().size(); ++i)
        plan.add(obstacle_track(source, i, moments, times), source.obstacle_suffix(i, ""),
                 source.obstacles()[i].moves);
    return plan.jobs;
}

}  // namespace

std::vector<ExportJob> plan_pc2(ExportSource& source) {
    return plan_cache(source, ".pc2", pc2_bytes);
}

std::vector<ExportJob> plan_mdd(ExportSource& source) {
    return plan_cache(source, ".mdd", mdd_bytes);
}

}  // namespace sherd
