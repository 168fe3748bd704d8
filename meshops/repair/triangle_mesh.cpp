// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/repair/triangle_mesh.h"

#include <string>

#include "meshops/error.h"
#include "meshops/repair/separate_sheets.h"

namespace sherd {
namespace {

[[noreturn]] void refuse_vertex(std::size_t vertex, const std::string& what) {
    throw Error("vertex " + std::to_string(vertex) + ": " + what);
}

[[noreturn]] void refuse_face(std::size_t face, const std::string& what) {
    throw Error("face " + std::to_string(face) + ": " + what);
}

/// Returns the corners of a face as text: "vertices 3, 4 and 5".
std::string corners(const TriangleSoup& soup, std::size_t face) {
    const auto& [a, b, c] = soup.triangles[face];
    return "vertices " + std::to_string(a) + ", " + std::to_string(b) + " and " + std::to_string(c);
}

TriangleSoup soup_of(std::span<const Eigen::Vector3d> positions,
                     std::span<const std::array<std::int32_t, 3>> triangles) {
    TriangleSoup soup;
    if (triangles.empty()) throw Error("a mesh needs at least one triangle");
    for (std::size_t v = 0; v < positions.size(); ++v) {
        if (!positions[v].allFinite()) refuse_vertex(v, "has a coordinate that is NaN or infinite");
        soup.points.emplace_back(positions[v].x(), positions[v].y(), positions[v].z());
        soup.file_vertex.push_back(static_cast<std::uint32_t>(v));
    }
    for (std::size_t f = 0; f < triangles.size(); ++f) {
        for (const std::int32_t v : triangles[f])
            if (v < 0 || static_cast<std::size_t>(v) >= positions.size())
                refuse_face(f, "vertex " + std::to_string(v) + " does not exist; there are " +
                                   std::to_string(positions.size()) + ", numbered from 0");
        soup.triangles.push_back({static_cast<std::uint32_t>(triangles[f][0]),
                                  static_cast<std::uint32_t>(triangles[f][1]),
                                  static_cast<std::uint32_t>(triangles[f][2])});
        soup.polygon.push_back(f);
    }
    return soup;
}

void require_used_vertices(const TriangleSoup& soup) {
    std::vector<char> used(soup.points.size(), 0);
    for (const auto& triangle : soup.triangles)
        for (const std::uint32_t v : triangle) used[v] = 1;
    for (std::size_t v = 0; v < used.size(); ++v)
        if (!used[v]) refuse_vertex(v, "no face uses it; leave it out");
}

void require_manifold(const TriangleSoup& soup) {
    if (const auto flat = zero_area_triangles(soup); !flat.empty())
        refuse_face(flat[0], "its " + corners(soup, flat[0]) + " enclose no area");
    if (const auto repeated = repeated_triangles(soup); !repeated.empty())
        refuse_face(repeated[0], "an earlier face has the same " + corners(soup, repeated[0]));
    if (const auto edges = non_manifold_edges(soup); !edges.empty()) {
        const auto& [a, b] = edges[0].points;
        refuse_face(edges[0].triangles[2],
                    "is the third face at the edge of vertices " + std::to_string(a) + " and " +
                        std::to_string(b) + ", beside faces " + std::to_string(edges[0].triangles[0]) +
                        " and " + std::to_string(edges[0].triangles[1]) + "; a sheet has two at most");
    }
    TriangleSoup separated = soup;
    if (const auto doubled = separate_sheets(separated); !doubled.empty())
        refuse_vertex(doubled[0], "faces meet there that no edge joins; give each side a vertex of its own");
}

void require_orientation(const TriangleSoup& soup) {
    TriangleSoup turned = soup;
    const Orientation orientation = orient(turned);
    if (orientation.one_sided)
        refuse_face(
            *orientation.one_sided,
            "belongs to a surface that has only one side (like a Moebius band); cut it open along a line");
    if (!orientation.turned.empty())
        refuse_face(orientation.turned[0],
                    "its normal is opposite to those of its neighbours; swap two of its " +
                        corners(soup, orientation.turned[0]));
}

}  // namespace

Mesh triangle_mesh(std::span<const Eigen::Vector3d> positions,
                   std::span<const std::array<std::int32_t, 3>> triangles) {
    const TriangleSoup soup = soup_of(positions, triangles);
    require_used_vertices(soup);
    require_manifold(soup);
    require_orientation(soup);
    Mesh mesh;
    for (const Point& point : soup.points) mesh.add_vertex(point);
    for (const auto& [a, b, c] : soup.triangles) mesh.add_face(Vertex(a), Vertex(b), Vertex(c));
    return mesh;
}

}  // namespace sherd
