// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/assemble/obstacle/deforming_mesh.h"

#include <fmt/format.h>

#include "app/files/point_cache.h"
#include "app/scene/assemble/sheet/mesh.h"
#include "meshops/error.h"
#include "meshops/soup/triangle_soup.h"

namespace sherd {
namespace {

constexpr double farthest_point = 1e9;  // m, largest coordinate of a point
constexpr double least_share = 0.05;    // share of a cache's duration that a run should cover

/// The triangles of a mesh file, with only those points that they use.
struct UsedTriangles {
    std::vector<std::array<Index, 3>> triangles;
    std::vector<Index> points;  ///< number in the file of each used point
};

UsedTriangles used(const TriangleSoup& soup) {
    UsedTriangles result;
    std::vector<Index> number(soup.points.size(), -1);
    for (const auto& triangle : soup.triangles)
        for (const std::uint32_t corner : triangle) number[corner] = 0;
    for (std::size_t p = 0; p < number.size(); ++p) {
        if (number[p] < 0) continue;
        number[p] = static_cast<Index>(result.points.size());
        result.points.push_back(static_cast<Index>(p));
    }
    for (const auto& [a, b, c] : soup.triangles)
        result.triangles.push_back({number[a], number[b], number[c]});
    return result;
}

PolygonSoup read_polygons(const std::filesystem::path& file) {
    const std::string extension = file.extension().string();
    if (extension == ".stl" || extension == ".STL")
        throw Error(file.string() +
                    ": an .stl file has no numbered vertices for a cache to move; export the "
                    "mesh as .obj");
    PolygonSoup soup = read_polygon_soup(file);
    check_polygon_soup(soup);
    return soup;
}

/// Throws Error if an edge has no length in the first sample, since such an edge has no direction.
void require_edges(const UsedTriangles& mesh, const Positions& first, const std::filesystem::path& file) {
    for (const auto& triangle : mesh.triangles)
        for (int i = 0; i < 3; ++i) {
            const Index a = triangle[i], b = triangle[(i + 1) % 3];
            if (first.col(a) == first.col(b))
                throw Error(
                    fmt::format("{}: points {} and {}, which an edge joins, lie at one place in the "
                                "first sample: merge such vertices before the cache is made",
                                file.string(), mesh.points[a], mesh.points[b]));
        }
}

Deformation deformation_of(const PointCache& cache, const ObstacleCache& spec, const UsedTriangles& mesh,
                           double scale) {
    Deformation deformation{{}, {}, spec.smooth};
    for (const double time : cache.times) deformation.times.push_back(spec.start + time);
    for (const Eigen::Matrix3Xf& sample : cache.samples) {
        const Positions scaled = scale * sample(Eigen::all, mesh.points).cast<double>();
        if (!(scaled.cwiseAbs().maxCoeff() <= farthest_point))
            throw Error(
                fmt::format("{}: a point is {:.3g} m from the origin, more than the largest distance, {:g} "
                            "m: give the mesh a scale (m per unit of the files)",
                            spec.path.string(), scaled.cwiseAbs().maxCoeff(), farthest_point));
        deformation.samples.push_back(scaled.cast<float>());
    }
    return deformation;
}

}  // namespace

DeformingMesh make_deforming_mesh(const ObstacleMesh& spec, std::vector<std::string>& warnings) {
    const PolygonSoup polygons = read_polygons(spec.file.path);
    const UsedTriangles mesh = used(triangulate(polygons));
    const PointCache cache =
        read_point_cache(spec.cache->path, polygons.points.size(), spec.file.path, spec.cache->frame_rate);
    Deformation deformation = deformation_of(cache, *spec.cache, mesh, spec.file.scale);
    const Positions first = deformation.samples.front().cast<double>();
    require_edges(mesh, first, spec.cache->path);
    if (!spec.file.has_size)
        warn_of_size((first.rowwise().maxCoeff() - first.rowwise().minCoeff()).maxCoeff(), warnings);
    return {collider_surface(first, mesh.triangles, true), std::move(deformation)};
}

void warn_of_cache(const ObstacleSpec& spec, const Deformation& deformation, double duration,
                   std::vector<std::string>& warnings) {
    const ObstacleCache& cache = *cache_of(spec);
    const double first = deformation.times.front(), last = deformation.times.back();
    const std::string where = fmt::format("{}: {}", cache.where, cache.path.string());
    if (last < duration)
        warnings.push_back(
            fmt::format("{} ends at {:g} s, the run at {:g} s: from then on obstacle.{} rests "
                        "as in the last sample",
                        where, last, duration, spec.name));
    else if (duration - first < least_share * (last - first))
        warnings.push_back(fmt::format(
            "{} lasts until {:g} s, of which the run covers {:.2g} s: a larger fps plays it faster", where,
            last, std::max(0.0, duration - first)));
}

}  // namespace sherd
