// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/remesh/size_field.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>

#include "meshops/mesh_measures.h"

namespace sherd {
namespace {

using Eigen::Vector3d;

/// Largest increase of the target length per distance.
constexpr double slope = 0.4;

/// Returns for each vertex, 1/m, the largest curvature across an edge at it: the angle between the normals of
/// the two faces of the edge, divided by the distance of their middles across the edge.
std::vector<double> curvatures(const InputSurface& surface) {
    const Mesh& mesh = surface.mesh;
    std::vector<double> curvature(mesh.number_of_vertices(), 0);
    for (const Edge edge : mesh.edges()) {
        const Halfedge h = mesh.halfedge(edge);
        if (surface.is_line(h)) continue;
        const Face left = mesh.face(h), right = mesh.face(mesh.opposite(h));
        const Vector3d &a = surface.normal(left), &b = surface.normal(right);
        const double length = (position(mesh, mesh.source(h)) - position(mesh, mesh.target(h))).norm();
        const double across = 2 * (face_area(mesh, left) + face_area(mesh, right)) / (3 * length);
        const double found = std::atan2(a.cross(b).norm(), a.dot(b)) / across;
        for (const Vertex v : {mesh.source(h), mesh.target(h)}) curvature[v] = std::max(curvature[v], found);
    }
    return curvature;
}

/// Returns the curvature of a line at the distance `way` (m) along it, between its ends, 1/m, measured over
/// `reach` (m) on both sides.
double curvature_of(const FeatureLine& line, double way, double reach) {
    const double aside = std::min({reach, way, line.length() - way});
    if (!(aside > 0)) return 0;
    const Vector3d here = line.at(way), back = line.at(way - aside) - here, on = line.at(way + aside) - here;
    return 2 * std::atan2(back.cross(on).norm(), -back.dot(on)) / (back.norm() + on.norm());
}

/// Increases the curvature at vertices between corners of lines to the curvature of their lines, if that is
/// larger.
void add_line_curvature(const InputSurface& surface, double reach, std::vector<double>& curvature) {
    for (const LineStretch& edge : surface.lines.of_edge) {
        if (edge.line == LineStretch::none) continue;
        const FeatureLine& line = surface.lines.lines[edge.line];
        const double seen_from = std::max(reach, std::abs(edge.at_end - edge.at_begin));
        for (const auto& [v, way] : {std::pair(edge.begin, edge.at_begin), std::pair(edge.end, edge.at_end)})
            if (!surface.lines.is_corner[v])
                curvature[v] = std::max(curvature[v], curvature_of(line, way, seen_from));
    }
}

/// Reduces target lengths where they increase too fast along the edges of a mesh, and makes them equal at
/// coincident vertices of shared lines.
void grade(const Mesh& mesh, const std::vector<std::vector<Vertex>>& coincident, std::vector<double>& sizes) {
    std::vector<const std::vector<Vertex>*> others(sizes.size(), nullptr);
    for (const std::vector<Vertex>& some : coincident)
        for (const Vertex v : some) others[v] = &some;
    using Reached = std::pair<double, Vertex>;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> waiting;
    for (const Vertex v : mesh.vertices()) waiting.push({sizes[v], v});
    while (!waiting.empty()) {
        const auto [size, v] = waiting.top();
        waiting.pop();
        if (size > sizes[v]) continue;
        const auto reach = [&, size = size, v = v](Vertex next) {
            const double most = size + slope * (position(mesh, next) - position(mesh, v)).norm();
            if (sizes[next] <= most) return;
            sizes[next] = most;
            waiting.push({most, next});
        };
        for (const Vertex next : mesh.vertices_around_target(mesh.halfedge(v))) reach(next);
        if (others[v] != nullptr) std::ranges::for_each(*others[v], reach);
    }
}

/// Returns the target lengths at the vertices of the surface: [V] m.
std::vector<double> sizes_by_curvature(const InputSurface& surface, double edge_length) {
    constexpr double rise = 0.06;         // edge lengths, largest height of the surface over chords
    constexpr double smallest = 1.0 / 6;  // edge lengths, smallest target length, however curved
    std::vector<double> sizes = curvatures(surface);
    add_line_curvature(surface, edge_length / 3, sizes);
    for (double& size : sizes) {
        const double chord = size > 0 ? std::sqrt(8 * rise * edge_length / size) : edge_length;
        size = std::clamp(chord, smallest * edge_length, edge_length);
    }
    grade(surface.mesh, surface.lines.coincident, sizes);
    return sizes;
}

}  // namespace

SizeField::SizeField(const InputSurface& surface, double edge_length, bool adaptive)
    : surface(surface),
      sizes(adaptive ? sizes_by_curvature(surface, edge_length)
                     : std::vector<double>(surface.mesh.number_of_vertices(), edge_length)) {}

double SizeField::at(const InputSurface::Site& site) const {
    const std::array<Vertex, 3> corners = face_corners(surface.mesh, site.face);
    double size = 0;
    for (int i = 0; i < 3; ++i) size += site.weights[i] * sizes[corners[i]];
    for (const Source& source : sources)
        size = std::min(size, source.size + slope * (source.place - site.place).norm());
    return size;
}

bool SizeField::refine(const InputSurface::Site& site, double size) {
    if (at(site) <= size) return false;
    sources.push_back({site.place, size});
    return true;
}

}  // namespace sherd
