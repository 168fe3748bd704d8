// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/remesh.h"

#include <CGAL/Polygon_mesh_processing/remesh.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "meshops/error.h"

namespace sherd {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using IsFeature = Mesh::Property_map<Edge, bool>;
using IsCorner = Mesh::Property_map<Vertex, bool>;

/// A copy of vertices, edges and faces, without properties and gaps in the numbers.
Mesh bare_copy(const Mesh& mesh) {
    Mesh copy;
    std::vector<Vertex> vertex(mesh.num_vertices());
    for (const Vertex v : mesh.vertices()) vertex[v.idx()] = copy.add_vertex(mesh.point(v));
    for (const Face face : mesh.faces()) {
        std::vector<Vertex> corners;
        for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(face)))
            corners.push_back(vertex[v.idx()]);
        if (copy.add_face(corners) == Mesh::null_face()) {
            throw Error("remeshing: a face of the mesh does not fit to the others", Fault::run);
        }
    }
    return copy;
}

/// Angle between the normals of the two faces of an inner edge, degrees.
double bend_degrees(const Mesh& mesh, Edge edge) {
    const Halfedge h = mesh.halfedge(edge), g = mesh.opposite(h);
    const auto point = [&](Halfedge i) { return mesh.point(mesh.target(i)); };
    const auto along = point(h) - point(g);
    const auto left = CGAL::cross_product(along, point(mesh.next(h)) - point(g));
    const auto right = CGAL::cross_product(point(mesh.next(g)) - point(g), along);
    const double sine = std::sqrt(CGAL::cross_product(left, right).squared_length());
    return std::atan2(sine, left * right) * 180 / std::numbers::pi;
}

IsFeature mark_features(Mesh& mesh, double feature_degrees) {
    auto is_feature = mesh.add_property_map<Edge, bool>("e:is_feature", false).first;
    for (const Edge edge : mesh.edges()) {
        is_feature[edge] = mesh.is_border(edge) || bend_degrees(mesh, edge) > feature_degrees;
    }
    return is_feature;
}

/// Marks corners: vertices where feature lines begin, end, branch, or turn by more than `feature_degrees`.
IsCorner mark_corners(Mesh& mesh, const IsFeature& is_feature, double feature_degrees) {
    auto is_corner = mesh.add_property_map<Vertex, bool>("v:is_corner", false).first;
    const double limit = std::cos(feature_degrees * std::numbers::pi / 180);
    for (const Vertex v : mesh.vertices()) {
        std::vector<Kernel::Vector_3> ways;
        for (const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v))) {
            if (!is_feature[mesh.edge(h)]) continue;
            const auto way = mesh.point(mesh.source(h)) - mesh.point(v);
            ways.push_back(way / std::sqrt(way.squared_length()));
        }
        is_corner[v] = ways.size() == 2 ? -(ways[0] * ways[1]) < limit : !ways.empty();
    }
    return is_corner;
}

}  // namespace

Mesh remesh(const Mesh& mesh, double edge_length, double feature_degrees) {
    if (!(edge_length > 0) || !std::isfinite(edge_length)) {
        throw Error("remeshing: edge_length must be positive, not " + std::to_string(edge_length));
    }
    Mesh work = bare_copy(mesh);
    auto is_feature = mark_features(work, feature_degrees);
    const auto is_corner = mark_corners(work, is_feature, feature_degrees);
    constexpr unsigned iterations = 8;
    pmp::isotropic_remeshing(work.faces(), edge_length, work,
                             CGAL::parameters::number_of_iterations(iterations)
                                 .number_of_relaxation_steps(3)
                                 .edge_is_constrained_map(is_feature)
                                 .vertex_is_constrained_map(is_corner));
    return bare_copy(work);
}

}  // namespace sherd
