// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/remesh/remesh.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "meshops/aabb_tree.h"
#include "meshops/error.h"
#include "meshops/mesh_measures.h"
#include "meshops/property_border.h"
#include "meshops/remesh/bare_copy.h"
#include "meshops/remesh/carried_properties.h"
#include "meshops/remesh/remeshing.h"
#include "meshops/self_intersections.h"

namespace sherd {
namespace {

using FaceMarks = std::vector<char>;  ///< of each face of the input

/// Marks the faces that have a vertex in common with marked ones, too.
void add_ring(const Mesh& mesh, FaceMarks& marks) {
    const FaceMarks before = marks;
    for (const Face face : mesh.faces()) {
        if (!before[face]) continue;
        for (const Vertex v : face_corners(mesh, face))
            for (const Face next : mesh.faces_around_target(mesh.halfedge(v)))
                if (next != Mesh::null_face()) marks[next] = 1;
    }
}

/// Marks the faces that are connected to marked ones within a distance (m) of these, and their neighbours.
void add_near(const Mesh& mesh, double distance, FaceMarks& marks) {
    const FaceMarks before = marks;
    for (const Face face : mesh.faces())
        if (before[face])
            for (const Face near : faces_near(mesh, {face}, centroid(mesh, face), distance)) marks[near] = 1;
    add_ring(mesh, marks);
}

/// Where most edges are seams, as of a texture whose every triangle is an island, none can be kept.
bool drop_torn_texture(Mesh& mesh) {
    auto [texture, exists] = find_property<Face, FaceTexture>(mesh, property::texture);
    if (!exists) return false;
    std::size_t seams = 0;
    for (const Edge edge : mesh.edges()) seams += is_property_border(mesh, mesh.halfedge(edge)) ? 1 : 0;
    if (2 * seams < mesh.number_of_edges()) return false;
    mesh.remove_property_map(texture);
    return true;
}

/// m, how far the vertices and middles of faces of a mesh are from another one at most.
double farthest(const Mesh& mesh, const Mesh& from) {
    const AabbTree<CGAL::AABB_face_graph_triangle_primitive<Mesh>> tree(faces(from).first, faces(from).second,
                                                                        from);
    double squared = 0;
    const auto include = [&](const Point& at) { squared = std::max(squared, tree.squared_distance(at)); };
    for (const Vertex v : mesh.vertices()) include(mesh.point(v));
    for (const Face face : mesh.faces()) include(point_at(centroid(mesh, face)));
    return std::sqrt(squared);
}

/// One way to remesh an input: with faces whose shape is kept, and shorter edges where it turns out badly.
class RemeshTrial {
  public:
    RemeshTrial(const Mesh& input, const RemeshOptions& options, const FaceMarks& crosses,
                const FaceMarks& kept)
        : surface(input, feature_lines(input, options.features, options.edge_length, kept),
                  smoothing * options.edge_length),
          sizes(surface, options.edge_length, options.adaptive),
          remeshing(surface, sizes),
          options(options),
          crosses(crosses) {
        constexpr int rounds = 8, more_rounds = 3, refinements = 3;
        remeshing.improve(rounds);
        find_crossings();
        for (int i = 0; options.adaptive && i < refinements; ++i) {
            const bool are_narrow = i == 0 && refine_slivers();
            if (!refine_crossings() && !are_narrow) break;
            remeshing.update_sizes();
            remeshing.improve(more_rounds);
            find_crossings();
        }
    }

    /// How many pairs of faces cross where no faces of the input do.
    std::size_t crossings() const { return crossing.size(); }
    /// Marks the faces of the input below these.
    void mark_crossings(FaceMarks& marks) const {
        for (const auto& pair : crossing)
            for (const Face face : pair)
                for (const Vertex v : face_corners(remeshing.mesh(), face))
                    marks[remeshing.face_below(v)] = 1;
    }

    /// The mesh, with the properties of the input.
    Mesh result() const {
        std::vector<Face> below;
        for (const Vertex v : remeshing.mesh().vertices()) below.push_back(remeshing.face_below(v));
        Mesh mesh = bare_copy(remeshing.mesh());
        carry_properties(surface, below, mesh);
        return mesh;
    }

  private:
    using Triangle = std::array<Eigen::Vector3d, 3>;
    static constexpr double smoothing = 1.0 / 4;  // of the edge length

    void find_crossings() {
        crossing.clear();
        for (const auto& pair : self_intersections(remeshing.mesh()))
            if (std::ranges::none_of(pair, [&](Face face) { return crosses_below(face); }))
                crossing.push_back(pair);
    }

    bool crosses_below(Face face) const {
        const Eigen::Vector3d middle = centroid(remeshing.mesh(), face);
        const std::array<Vertex, 3> corners = face_corners(remeshing.mesh(), face);
        return std::ranges::any_of(corners, [&](Vertex v) {
            const Face below = remeshing.face_below(v);
            return crosses[below] != 0 || crosses[surface.nearest(below, middle).face] != 0;
        });
    }

    /// Wants shorter edges where faces cross; returns whether there are longer ones.
    bool refine_crossings() {
        constexpr double ratio = 0.4, smallest = 1.0 / 32;  // of the edge length
        bool are_longer = false;
        for (const auto& pair : crossing)
            for (const Face face : pair)
                for (const Vertex v : face_corners(remeshing.mesh(), face))
                    are_longer |=
                        refine(v, std::max(ratio * remeshing.size_at(v), smallest * options.edge_length));
        return are_longer;
    }

    /// Wants shorter edges where lines are so near to each other that angles are small; returns whether there
    /// are longer ones.
    bool refine_slivers() {
        constexpr double small = 20 * std::numbers::pi / 180, ratio = 1.6, smallest = 1.0 / 6;
        bool are_longer = false;
        for (const Face face : remeshing.mesh().faces()) {
            const Triangle points = face_points(remeshing.mesh(), face);
            if (sherd::smallest_angle(points) > small) continue;
            double shortest = std::numeric_limits<double>::infinity();
            for (int i = 0; i < 3; ++i)
                shortest = std::min(shortest, (points[i] - points[(i + 1) % 3]).norm());
            for (const Vertex v : face_corners(remeshing.mesh(), face))
                are_longer |= refine(v, std::max(ratio * shortest, smallest * options.edge_length));
        }
        return are_longer;
    }

    bool refine(Vertex v, double size) {
        return sizes.refine(surface.nearest(remeshing.face_below(v), position(remeshing.mesh(), v)), size);
    }

    const InputSurface surface;
    SizeField sizes;
    Remeshing remeshing;
    const RemeshOptions& options;
    const FaceMarks& crosses;
    std::vector<std::array<Face, 2>> crossing;
};

/// Faces of the input that cross each other, or are near to such.
FaceMarks crossing_faces(const Mesh& input, double edge_length) {
    FaceMarks crosses(input.number_of_faces(), 0);
    for (const auto& pair : self_intersections(input))
        for (const Face face : pair) crosses[face] = 1;
    add_near(input, edge_length / 2, crosses);
    return crosses;
}

}  // namespace

Remeshed remesh(const Mesh& mesh, const RemeshOptions& options) {
    if (!(options.edge_length > 0) || !std::isfinite(options.edge_length))
        throw Error("remeshing: edge_length must be positive, not " + std::to_string(options.edge_length));
    Mesh input = mesh;
    input.collect_garbage();
    const bool texture_lost = drop_torn_texture(input);
    const FaceMarks crosses = crossing_faces(input, options.edge_length);
    FaceMarks kept(input.number_of_faces(), 0);
    auto trial = std::make_unique<RemeshTrial>(input, options, crosses, kept);
    constexpr int keepings = 8;
    for (int i = 0; i < keepings && trial->crossings() > 0; ++i) {
        // What is kept is larger from round to round, so that it covers what is there to be crossed.
        FaceMarks more(kept.size(), 0);
        trial->mark_crossings(more);
        for (int ring = 0; ring <= i / 2; ++ring) add_ring(input, more);
        std::ranges::transform(kept, more, kept.begin(), [](char a, char b) { return char(a | b); });
        trial = std::make_unique<RemeshTrial>(input, options, crosses, kept);
    }
    Remeshed result{.mesh = trial->result()};
    result.kept = static_cast<std::size_t>(std::ranges::count(kept, char(1)));
    result.crossings = trial->crossings();
    result.distance = std::max(farthest(result.mesh, input), farthest(input, result.mesh));
    result.texture_lost = texture_lost;
    return result;
}

}  // namespace sherd
