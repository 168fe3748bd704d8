// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/read_write/mesh_faults.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "meshops/soup/triangle_soup.h"

namespace sherd {
namespace {

using EdgeEnds = std::array<std::uint32_t, 2>;

std::array<EdgeEnds, 3> edges_of(const std::array<std::uint32_t, 3>& triangle) {
    const auto& [a, b, c] = triangle;
    return {EdgeEnds{std::min(a, b), std::max(a, b)}, EdgeEnds{std::min(b, c), std::max(b, c)},
            EdgeEnds{std::min(c, a), std::max(c, a)}};
}

/// Returns the triangles of zero area, and the triangles that share an edge with them.
std::vector<std::size_t> around_zero_area(const TriangleSoup& soup) {
    std::vector<std::size_t> around = zero_area_triangles(soup);
    std::set<EdgeEnds> flat;
    for (const std::size_t t : around)
        for (const EdgeEnds& edge : edges_of(soup.triangles[t])) flat.insert(edge);
    for (std::size_t t = 0; t < soup.triangles.size(); ++t)
        if (std::ranges::any_of(edges_of(soup.triangles[t]),
                                [&](const EdgeEnds& edge) { return flat.contains(edge); }))
            around.push_back(t);
    return around;
}

}  // namespace

FaultyMesh find_mesh_faults(const std::filesystem::path& file, bool join, double distance) {
    PolygonSoup polygons = read_polygon_soup(file);
    check_polygon_soup(polygons);
    if (join) join_duplicate_points(polygons);
    if (distance > 0) join_near_points(polygons, distance);
    const TriangleSoup soup = triangulate(polygons);
    FaultyMesh mesh;
    const std::vector<bool> is_used = used_points(polygons);
    for (std::size_t i = 0; i < soup.points.size(); ++i) {
        // An unused point may be NaN; a used point replaces it.
        const Point& p = soup.points[is_used[i] ? i : polygons.polygons[0][0]];
        mesh.sheet.points.emplace_back(p.x(), p.y(), p.z());
    }
    for (const auto& [a, b, c] : soup.triangles)
        mesh.sheet.triangles.push_back(
            {static_cast<std::int32_t>(a), static_cast<std::int32_t>(b), static_cast<std::int32_t>(c)});
    mesh.faults.assign(soup.triangles.size(), TriangleFault::none);
    for (const std::size_t t : around_zero_area(soup)) mesh.faults[t] = TriangleFault::zero_area;
    for (const std::size_t t : repeated_triangles(soup)) mesh.faults[t] = TriangleFault::repeated;
    // Triangles of zero area and repeated ones make their edges look non-manifold, so they are dropped first.
    TriangleSoup rest = soup;
    std::vector<std::size_t> kept(soup.triangles.size());
    std::iota(kept.begin(), kept.end(), std::size_t{0});
    const auto drop = [&](const std::vector<std::size_t>& found) {
        erase_triangles(rest, found);
        for (auto t = found.rbegin(); t != found.rend(); ++t)
            kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(*t));
    };
    drop(zero_area_triangles(rest));
    drop(repeated_triangles(rest));
    for (const NonManifoldEdge& edge : non_manifold_edges(rest))
        for (const std::size_t t : edge.triangles) mesh.faults[kept[t]] = TriangleFault::non_manifold;
    return mesh;
}

}  // namespace sherd
