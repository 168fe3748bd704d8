// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/remesh.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "meshops/error.h"
#include "meshops/mesh_measures.h"
#include "meshops/self_intersections.h"

namespace sherd {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using IsFeature = Mesh::Property_map<Edge, bool>;
using IsCorner = Mesh::Property_map<Vertex, bool>;
using FaceTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_face_graph_triangle_primitive<Mesh>>>;

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

/// FaceMarks corners: vertices where feature lines begin, end, branch, or turn by more than
/// `feature_degrees`.
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

using FaceMarks = std::vector<char>;  ///< of each face

/// Remeshes all but the marked faces, whose vertices stay.
Mesh remeshed(const Mesh& mesh, double edge_length, double feature_degrees, const FaceMarks& kept) {
    Mesh work = bare_copy(mesh);
    auto is_feature = mark_features(work, feature_degrees);
    auto stays = mark_corners(work, is_feature, feature_degrees);
    std::vector<Face> faces;
    for (const Face face : work.faces()) {
        if (!kept[face]) faces.push_back(face);
        if (kept[face])
            for (const Vertex v : work.vertices_around_face(work.halfedge(face))) stays[v] = true;
    }
    constexpr unsigned iterations = 8;
    pmp::isotropic_remeshing(faces, edge_length, work,
                             CGAL::parameters::number_of_iterations(iterations)
                                 .number_of_relaxation_steps(3)
                                 .edge_is_constrained_map(is_feature)
                                 .vertex_is_constrained_map(stays));
    return bare_copy(work);
}

/// FaceMarks the faces that have a vertex in common with marked ones, too.
void add_ring(const Mesh& mesh, FaceMarks& marks) {
    const FaceMarks before = marks;
    for (const Face face : mesh.faces()) {
        if (!before[face]) continue;
        for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(face)))
            for (const Face next : mesh.faces_around_target(mesh.halfedge(v)))
                if (next != Mesh::null_face()) marks[next] = 1;
    }
}

/// The mesh that is remeshed, to be asked what of it is where.
class RemeshInput {
  public:
    explicit RemeshInput(const Mesh& mesh)
        : tree(faces(mesh).first, faces(mesh).second, mesh), crosses(mesh.number_of_faces(), 0) {
        for (const auto& pair : self_intersections(mesh))
            for (const Face face : pair) crosses[face] = 1;
        add_ring(mesh, crosses);
    }

    /// FaceMarks the faces nearest to pairs of faces of `result` that cross where no faces here do, or next
    /// to such; returns how many pairs there are.
    std::size_t mark_crossings(const Mesh& result, FaceMarks& marks) const {
        std::size_t count = 0;
        for (const auto& pair : self_intersections(result)) {
            std::vector<Face> nearest;
            for (const Face face : pair)
                for (const Vertex v : result.vertices_around_face(result.halfedge(face)))
                    nearest.push_back(tree.closest_point_and_primitive(result.point(v)).second);
            if (std::ranges::any_of(nearest, [&](Face face) { return crosses[face] != 0; })) continue;
            ++count;
            for (const Face face : nearest) marks[face] = 1;
        }
        return count;
    }

  private:
    FaceTree tree;
    FaceMarks crosses;
};

/// m, how far the vertices and middles of faces of a mesh are from another one at most.
double farthest(const Mesh& mesh, const Mesh& from) {
    const FaceTree tree(faces(from).first, faces(from).second, from);
    double squared = 0;
    const auto include = [&](const Point& at) { squared = std::max(squared, tree.squared_distance(at)); };
    for (const Vertex v : mesh.vertices()) include(mesh.point(v));
    for (const Face face : mesh.faces()) {
        const Eigen::Vector3d middle = centroid(mesh, face);
        include({middle.x(), middle.y(), middle.z()});
    }
    return std::sqrt(squared);
}

}  // namespace

Remeshed remesh(const Mesh& mesh, double edge_length, double feature_degrees) {
    if (!(edge_length > 0) || !std::isfinite(edge_length)) {
        throw Error("remeshing: edge_length must be positive, not " + std::to_string(edge_length));
    }
    constexpr int rounds = 8;
    const RemeshInput input(mesh);
    Remeshed result;
    FaceMarks kept(mesh.number_of_faces(), 0);
    for (int round = 0; round < rounds; ++round) {
        result.mesh = remeshed(mesh, edge_length, feature_degrees, kept);
        result.kept = static_cast<std::size_t>(std::ranges::count(kept, char(1)));
        FaceMarks crossing(kept.size(), 0);
        result.crossings = input.mark_crossings(result.mesh, crossing);
        if (result.crossings == 0) break;
        // What stays is larger from round to round, so that it covers what is there to be crossed.
        for (int ring = 0; ring <= round / 2; ++ring) add_ring(mesh, crossing);
        std::ranges::transform(kept, crossing, kept.begin(), [](char a, char b) { return char(a | b); });
    }
    result.distance = std::max(farthest(result.mesh, mesh), farthest(mesh, result.mesh));
    return result;
}

}  // namespace sherd
