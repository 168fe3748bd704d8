// SPDX-License-Identifier: GPL-3.0-or-later
// Point caches, for a mesh whose topology is that of the last frame, at an even rate: pc2 and mdd.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <memory>

#include "app/export/export_clip.h"
#include "app/export/export_formats.h"

namespace sherd {

namespace {

template <class T>
void append(std::string& bytes, T value, std::endian order) {
    char part[sizeof value];
    std::memcpy(part, &value, sizeof value);
    if (order != std::endian::native) std::reverse(part, part + sizeof value);
    bytes.append(part, sizeof value);
}

void append_points(std::string& bytes, Clip& clip, std::endian order) {
    for (std::size_t i = 0; i < clip.size(); ++i)
        for (const Vector3d& point : clip.points(i))
            for (const double coordinate : point) append(bytes, static_cast<float>(coordinate), order);
}

std::int32_t point_count(const Clip& clip) {
    return static_cast<std::int32_t>(clip.topology().points.size());
}

/// A head of name, version, points, start, frames a sample and samples; little endian.
std::string pc2_bytes(Clip& clip, double) {
    std::string bytes("POINTCACHE2\0", 12);
    append(bytes, std::int32_t{1}, std::endian::little);
    append(bytes, point_count(clip), std::endian::little);
    append(bytes, 0.0F, std::endian::little);
    append(bytes, 1.0F, std::endian::little);
    append(bytes, static_cast<std::int32_t>(clip.size()), std::endian::little);
    append_points(bytes, clip, std::endian::little);
    return bytes;
}

/// A head of samples, points and the samples' times in s, as they are shown; big endian.
std::string mdd_bytes(Clip& clip, double slowdown) {
    std::string bytes;
    append(bytes, static_cast<std::int32_t>(clip.size()), std::endian::big);
    append(bytes, point_count(clip), std::endian::big);
    for (std::size_t i = 0; i < clip.size(); ++i)
        append(bytes, static_cast<float>(slowdown * (clip.time(i) - clip.time(0))), std::endian::big);
    append_points(bytes, clip, std::endian::big);
    return bytes;
}

/// The mesh that the cache goes with: the topology of the last frame in the shape of the first.
std::string mesh_of_clip(Clip& clip, const std::filesystem::path& file) {
    TriangleSheet sheet;
    sheet.points = clip.points(0);
    sheet.triangles = clip.topology().triangles;
    return mesh_bytes(sheet, file);
}

std::vector<ExportJob> plan_cache(ExportSource& source, const char* extension,
                                  std::string (*content)(Clip& clip, double slowdown)) {
    const Pace pace = source.pace();
    const auto clip =
        std::make_shared<Clip>(source, even_moments(source.frames(), source.times(), pace.step()));
    if (source.frames().size() > 1)
        source.pace_words =
            fmt::format("{}, {} samples at {:g} a second", pace.words(), clip->size(), pace.rate);
    const std::filesystem::path mesh = source.clip_file(".obj");
    return {{mesh, [clip, mesh] { return mesh_of_clip(*clip, mesh); }},
            {source.clip_file(extension), [=] { return content(*clip, pace.slowdown); }}};
}

}  // namespace

std::vector<ExportJob> plan_pc2(ExportSource& source) {
    return plan_cache(source, ".pc2", pc2_bytes);
}

std::vector<ExportJob> plan_mdd(ExportSource& source) {
    return plan_cache(source, ".mdd", mdd_bytes);
}

}  // namespace sherd
