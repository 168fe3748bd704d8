// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/remesh/input_surface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "meshops/mesh_measures.h"
#include "meshops/topology/surface_point.h"

namespace sherd {

using Eigen::Vector3d;

InputSurface::InputSurface(const Mesh& mesh, FeatureLines lines, double smoothing)
    : mesh(mesh), lines(std::move(lines)) {
    average_normals(smoothing);
}

void InputSurface::average_normals(double smoothing) {
    std::vector<Vector3d> area(mesh.number_of_faces());  // m^2, normals times twice the area
    double edge = 0;
    for (const Edge e : mesh.edges())
        edge += (position(mesh, mesh.vertex(e, 0)) - position(mesh, mesh.vertex(e, 1))).norm();
    edge /= static_cast<double>(mesh.number_of_edges());
    for (const Face face : mesh.faces()) area[face] = triangle_normal(face_points(mesh, face));
    // Each average over a face and its three neighbours, whose middles are edge / sqrt(3) away, increases the
    // variance in every direction by edge^2 / 8.
    constexpr double most = 60;
    const int rounds = static_cast<int>(std::min(most, 8 * std::pow(smoothing / edge, 2)));
    for (int round = 0; round < rounds; ++round) {
        const std::vector<Vector3d> before = area;
        for (const Face face : mesh.faces())
            for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(face)))
                if (!is_line(h)) area[face] += before[mesh.face(mesh.opposite(h))];
        for (Vector3d& a : area) a /= 2;
    }
    normals.reserve(area.size());
    for (const Vector3d& a : area) normals.push_back(a.norm() > 0 ? Vector3d(a.normalized()) : a);
}

InputSurface::Site InputSurface::nearest(Face begin, const Vector3d& point, bool across_lines) const {
    struct Visited {
        Face face;
        double squared;  ///< squared distance from `point`, m^2
        bool is_left = false;
    };
    constexpr int patience = 12;  // successive faces without a nearer point that end the search
    std::vector<Visited> visited;
    visited.reserve(48);
    Site best;
    double least = std::numeric_limits<double>::infinity();
    const auto visit = [&](Face face) {
        const std::array<Vector3d, 3> corners = face_points(mesh, face);
        const Vector3d weights = nearest_weights(corners, point);
        const Vector3d place = weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
        const double squared = (place - point).squaredNorm();
        visited.push_back({face, squared});
        if (!(squared < least)) return false;
        best = {face, weights, place};
        least = squared;
        return true;
    };
    best.face = begin;
    best.weights = Vector3d::Constant(1.0 / 3);
    best.place = centroid(mesh, begin);
    visit(begin);
    for (int left = patience; left > 0 && least > 0; --left) {
        Visited* nearest = nullptr;
        for (Visited& v : visited)
            if (!v.is_left && (nearest == nullptr || v.squared < nearest->squared)) nearest = &v;
        if (nearest == nullptr) break;
        nearest->is_left = true;
        const Face face = nearest->face;
        for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(face))) {
            const Face other = mesh.face(mesh.opposite(h));
            if (other == Mesh::null_face() || (!across_lines && is_line(h))) continue;
            if (std::ranges::any_of(visited, [&](const Visited& v) { return v.face == other; })) continue;
            if (visit(other)) left = patience;
        }
    }
    return best;
}

}  // namespace sherd
