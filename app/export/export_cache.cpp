// SPDX-License-Identifier: GPL-3.0-or-later
// Point caches at an even rate, in the formats pc2 and mdd: a cache of the sheets, with the vertices and
// faces of the last frame, and a cache of each obstacle that moves.
#include <fmt/format.h>

#include <functional>
#include <memory>

#include "app/export/export_clip.h"
#include "app/export/export_formats.h"
#include "app/files/point_cache.h"
#include "app/messages/counted.h"
#include "meshops/raw_bytes.h"
#include "meshops/read_write/material_library.h"

namespace sherd {

namespace {

/// Content of a cache: positions of the same points at several moments.
struct PointTrack {
    TriangleSheet mesh;                                        ///< mesh of the cache, without its points
    std::vector<double> times;                                 ///< s, times of the samples in slow motion
    std::function<std::vector<Vector3d>(std::size_t)> points;  ///< returns the points of a sample, [P] m
};

std::string with_points(std::string head, const PointTrack& track, std::endian order) {
    for (std::size_t i = 0; i < track.times.size(); ++i)
        for (const Vector3d& point : track.points(i))
            for (const double coordinate : point) append_number(head, static_cast<float>(coordinate), order);
    return head;
}

std::string pc2_bytes(const PointTrack& track) {
    return with_points(pc2_head(track.points(0).size(), track.times.size()), track, pc2_order);
}

std::string mdd_bytes(const PointTrack& track) {
    return with_points(mdd_head(track.points(0).size(), track.times), track, mdd_order);
}

/// Returns the mesh of the cache, in the shape of the first sample.
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

    /// Adds the files of a mesh and, if `moves`, of its cache. suffix: end of their names.
    void add(const PointTrack& track, const std::string& suffix, bool moves) {
        const std::filesystem::path mesh = source.clip_file(suffix + ".obj");
        if (has_material_file(track.mesh, mesh))
            jobs.push_back({material_file(mesh),
                            [track, mesh] { return material_text(track.mesh.look.material, mesh); }});
        jobs.push_back({mesh, [track, mesh] { return mesh_of(track, mesh); }});
        if (!moves) return;
        jobs.push_back(
            {source.clip_file(suffix + extension), [track, content = content] { return content(track); }});
    }
};

/// Track of the sheets, with the last frame's topology.
PointTrack sheet_track(const std::shared_ptr<Clip>& clip, const std::vector<double>& times) {
    TriangleSheet mesh;
    mesh.triangles = clip->topology().triangles;
    mesh.look.texture = clip->topology().look.texture;
    mesh.look.material = clip->topology().look.material;
    mesh.look.groups = clip->topology().look.groups;
    return {mesh, times, [clip](std::size_t i) { return clip->points(i); }};
}

PointTrack obstacle_track(const ExportSource& source, std::size_t number,
                          const std::vector<PlaybackTime>& moments, const std::vector<double>& times) {
    TriangleSheet mesh;
    mesh.triangles = source.obstacles()[number].surface.triangles;
    return {mesh, times,
            [&source, number, moments](std::size_t i) { return source.obstacle(number, moments[i]).points; }};
}

std::vector<ExportJob> plan_cache(ExportSource& source, const char* extension,
                                  std::string (*content)(const PointTrack& track)) {
    const Pace pace = source.pace();
    const std::vector<PlaybackTime> moments = even_times(source.frames(), source.times(), pace.step());
    if (source.frames().size() > 1)
        source.pace_text = fmt::format("{}, {} at {:g} per second", pace.words(),
                                       counted(moments.size(), "sample"), pace.rate);
    std::vector<double> times;
    for (const PlaybackTime& moment : moments)
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
