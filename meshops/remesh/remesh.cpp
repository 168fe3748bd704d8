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

#include "meshops/attributes.h"
#include "meshops/error.h"
#include "meshops/intersect/aabb_tree.h"
#include "meshops/intersect/self_intersections.h"
#include "meshops/mesh_measures.h"
#include "meshops/remesh/plain_copy.h"
#include "meshops/remesh/remeshing.h"
#include "meshops/remesh/transfer_properties.h"
#include "meshops/topology/property_border.h"

namespace sherd {
namespace {

using FaceMarks = std::vector<char>;  ///< a mark for each face of the input

/// Marks also the faces that have a vertex in common with marked ones.
void add_ring(const Mesh& mesh, FaceMarks& marks) {
    const FaceMarks before = marks;
    for (const Face face : mesh.faces()) {
        if (!before[face]) continue;
        for (const Vertex v : face_corners(mesh, face))
            for (const Face next : mesh.faces_around_target(mesh.halfedge(v)))
                if (next != Mesh::null_face()) marks[next] = 1;
    }
}

/// Marks also the faces that are connected to marked ones within `distance` (m) of these, and then all faces
/// that have a vertex in common with marked ones.
void add_near(const Mesh& mesh, double distance, FaceMarks& marks) {
    const FaceMarks before = marks;
    for (const Face face : mesh.faces())
        if (before[face])
            for (const Face near : faces_near(mesh, {face}, centroid(mesh, face), distance)) marks[near] = 1;
    add_ring(mesh, marks);
}

/// Drops texture coordinates if most edges are seams, as where every triangle is an island of the texture: so
/// many seams could not be kept. Returns whether the coordinates were dropped.
bool drop_torn_texture(Mesh& mesh) {
    auto [texture, exists] = find_property(mesh, attribute::texture);
    if (!exists) return false;
    std::size_t seams = 0;
    for (const Edge edge : mesh.edges()) seams += is_property_border(mesh, mesh.halfedge(edge)) ? 1 : 0;
    if (2 * seams < mesh.number_of_edges()) return false;
    mesh.remove_property_map(texture);
    return true;
}

/// Returns the largest distance, m, of the vertices and middles of faces of a mesh from the mesh `from`.
double farthest(const Mesh& mesh, const Mesh& from) {
    const AabbTree<CGAL::AABB_face_graph_triangle_primitive<Mesh>> tree(faces(from).first, faces(from).second,
                                                                        from);
    double squared = 0;
    const auto include = [&](const Point& at) { squared = std::max(squared, tree.squared_distance(at)); };
    for (const Vertex v : mesh.vertices()) include(mesh.point(v));
    for (const Face face : mesh.faces()) include(point_at(centroid(mesh, face)));
    return std::sqrt(squared);
}

/// Faces of an input that cross each other.
struct InputCrossings {
    FaceMarks there, near;  ///< faces that cross, and these with the faces near them
    std::size_t most = 0;   ///< number of pairs of faces that may cross there after remeshing
};

// Lengths, in target edge lengths, up to which edges are not split: edges of most faces; and edges of faces
// that cross in the input, since their parts would cross more often.
constexpr double longest = 4.0 / 3, large = 2;

/// Returns the lengths of the shortest and the longest edge of a face, m.
std::pair<double, double> edge_range(const Mesh& mesh, Face face) {
    const std::array<Eigen::Vector3d, 3> p = face_points(mesh, face);
    return std::minmax({(p[1] - p[0]).norm(), (p[2] - p[1]).norm(), (p[0] - p[2]).norm()});
}

/// Whether two faces have coincident corners, as along a seam that is not joined: such faces touch after
/// remeshing, too.
bool share_a_place(const Mesh& mesh, const std::array<Face, 2>& pair) {
    const std::array<Vertex, 3> one = face_corners(mesh, pair[0]), other = face_corners(mesh, pair[1]);
    return std::ranges::any_of(one, [&](Vertex a) {
        return std::ranges::any_of(other, [&](Vertex b) { return mesh.point(a) == mesh.point(b); });
    });
}

InputCrossings input_crossings(const Mesh& input, double edge_length) {
    constexpr double pairs = 6;  // crossing pairs of faces per edge length along an intersection
    InputCrossings found{FaceMarks(input.number_of_faces(), 0), {}};
    for (const auto& pair : self_intersections(input)) {
        for (const Face face : pair) found.there[face] = 1;
        if (share_a_place(input, pair)) continue;
        const double side =
            std::max(edge_range(input, pair[0]).second, edge_range(input, pair[1]).second) / edge_length;
        found.most += side <= large ? 1 : static_cast<std::size_t>(pairs * side);
    }
    found.near = found.there;
    add_near(input, edge_length / 2, found.near);
    return found;
}

/// Returns the lengths, m, up to which the edges of kept faces are not split; 0 for other faces.
std::vector<double> unsplit(const InputCrossings& crossings, double edge_length, const FaceMarks& kept) {
    std::vector<double> lengths(kept.size(), 0);
    for (std::size_t face = 0; face < kept.size(); ++face)
        if (kept[face]) lengths[face] = (crossings.there[face] ? large : longest) * edge_length;
    return lengths;
}

/// An attempt to remesh an input: the shape of some faces is kept, and edges are made shorter where the
/// result is bad.
class RemeshTrial {
  public:
    RemeshTrial(const Mesh& input, const RemeshOptions& options, const InputCrossings& there,
                const FaceMarks& kept)
        : surface(input, feature_lines(input, options.features, options.edge_length, kept),
                  smoothing * options.edge_length),
          sizes(surface, options.edge_length, options.adaptive),
          remeshing(surface, sizes, unsplit(there, options.edge_length, kept)),
          options(options),
          there(there),
          kept(kept) {
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

    /// Returns the number of pairs of faces that cross: all pairs where no faces of the input cross and,
    /// where faces of the input cross, the pairs beyond the number that InputCrossings allows.
    std::size_t crossings() const {
        return crossing.size() + (old_crossing.size() > there.most ? old_crossing.size() - there.most : 0);
    }
    /// Whether faces cross or edges are far too short, so that the input's faces would be better.
    bool is_worse() const { return crossings() > 0 || !tiny_edges().empty(); }
    /// Marks the faces of the input below crossing faces and below edges that are far too short.
    void mark_worse(FaceMarks& marks) const {
        const auto mark = [&](Vertex v) { marks[remeshing.face_below(v)] = 1; };
        for (const auto& pair : crossing)
            for (const Face face : pair) std::ranges::for_each(face_corners(remeshing.mesh(), face), mark);
        if (old_crossing.size() > there.most)
            for (const auto& pair : old_crossing)
                for (const Face face : pair)
                    std::ranges::for_each(face_corners(remeshing.mesh(), face), mark);
        for (const Edge edge : tiny_edges())
            for (const int end : {0, 1}) mark(remeshing.mesh().vertex(edge, end));
    }

    /// The mesh, with the properties of the input.
    Mesh result() const {
        std::vector<Face> below;
        for (const Vertex v : remeshing.mesh().vertices()) below.push_back(remeshing.face_below(v));
        Mesh mesh = plain_copy(remeshing.mesh());
        transfer_properties(surface, below, mesh);
        return mesh;
    }

  private:
    using Triangle = std::array<Eigen::Vector3d, 3>;
    static constexpr double smoothing = 1.0 / 4, shortest = 1.0 / 10;  // edge lengths

    void find_crossings() {
        crossing.clear();
        old_crossing.clear();
        for (const auto& pair : self_intersections(remeshing.mesh())) {
            const bool is_old = std::ranges::any_of(pair, [&](Face face) { return crosses_below(face); });
            if (!is_old)
                crossing.push_back(pair);
            else if (!share_a_place(remeshing.mesh(), pair))
                old_crossing.push_back(pair);
        }
    }

    /// Returns the edges that are far shorter than requested, where the faces of the input are not kept.
    std::vector<Edge> tiny_edges() const {
        const Mesh& mesh = remeshing.mesh();
        std::vector<Edge> tiny;
        for (const Edge edge : mesh.edges()) {
            const Vertex a = mesh.vertex(edge, 0), b = mesh.vertex(edge, 1);
            const double least = std::min(finest(a), finest(b)) / 2;
            if ((position(mesh, a) - position(mesh, b)).norm() >=
                std::min(shortest * options.edge_length, least))
                continue;
            if (!kept[remeshing.face_below(a)] || !kept[remeshing.face_below(b)]) tiny.push_back(edge);
        }
        return tiny;
    }

    bool crosses_below(Face face) const {
        const Eigen::Vector3d middle = centroid(remeshing.mesh(), face);
        const std::array<Vertex, 3> corners = face_corners(remeshing.mesh(), face);
        return std::ranges::any_of(corners, [&](Vertex v) {
            const Face below = remeshing.face_below(v);
            return there.near[below] != 0 || there.near[surface.nearest(below, middle).face] != 0;
        });
    }

    /// Reduces the target length where faces cross. Returns whether it was larger anywhere.
    bool refine_crossings() {
        constexpr double ratio = 0.4;
        bool are_longer = false;
        for (const auto& pair : crossing)
            for (const Face face : pair)
                for (const Vertex v : face_corners(remeshing.mesh(), face))
                    are_longer |= refine(v, std::max(ratio * remeshing.size_at(v), finest(v)));
        return are_longer;
    }

    /// Reduces the target length where lines are so near to each other that angles are small. Returns whether
    /// it was larger anywhere.
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

    /// Returns the smallest target length at a vertex, m: a sixth of the requested length or, if that is
    /// less, the shortest edge of the input there.
    double finest(Vertex v) const {
        constexpr double smallest = 1.0 / 6;
        return std::min(smallest * options.edge_length,
                        edge_range(surface.mesh, remeshing.face_below(v)).first);
    }

    bool refine(Vertex v, double size) {
        return sizes.refine(surface.nearest(remeshing.face_below(v), position(remeshing.mesh(), v)), size);
    }

    const InputSurface surface;
    SizeField sizes;
    Remeshing remeshing;
    const RemeshOptions& options;
    const InputCrossings& there;
    const FaceMarks& kept;
    std::vector<std::array<Face, 2>> crossing,
        old_crossing;  ///< pairs that cross where the input's faces do not, and where they do
};

}  // namespace

Remeshed remesh(const Mesh& mesh, const RemeshOptions& options) {
    if (!(options.edge_length > 0) || !std::isfinite(options.edge_length))
        throw Error("remeshing: edge_length must be positive, not " + std::to_string(options.edge_length));
    Mesh input = mesh;
    input.collect_garbage();
    const bool texture_lost = drop_torn_texture(input);
    const InputCrossings there = input_crossings(input, options.edge_length);
    FaceMarks kept(input.number_of_faces(), 0);
    auto trial = std::make_unique<RemeshTrial>(input, options, there, kept);
    constexpr int keepings = 8;
    for (int i = 0; i < keepings && trial->is_worse(); ++i) {
        // The part that is kept grows from round to round, until it covers the faces that would be crossed.
        FaceMarks more(kept.size(), 0);
        trial->mark_worse(more);
        for (int ring = 0; ring <= i / 2; ++ring) add_ring(input, more);
        std::ranges::transform(kept, more, kept.begin(), [](char a, char b) { return char(a | b); });
        trial = std::make_unique<RemeshTrial>(input, options, there, kept);
    }
    Remeshed result{.mesh = trial->result()};
    result.kept = static_cast<std::size_t>(std::ranges::count(kept, char(1)));
    result.crossings = trial->crossings();
    result.distance = std::max(farthest(result.mesh, input), farthest(input, result.mesh));
    result.texture_lost = texture_lost;
    return result;
}

}  // namespace sherd
