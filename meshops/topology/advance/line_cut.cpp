// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/topology/advance/line_cut.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "meshops/error.h"
#include "meshops/intersect/aabb_tree.h"
#include "meshops/mesh_measures.h"
#include "meshops/topology/advance/advance_edge.h"
#include "meshops/topology/advance/trial_choice.h"

namespace sherd {
namespace {

using Eigen::Vector3d;

/// Result of place_vertex().
struct PlacedVertex {
    Vertex vertex;
    double smallest_angle;  ///< smallest angle of the changed faces, rad; pi if there are none
    TopologyChange change;
};

constexpr double on_side = 1e-9;  // weight of a corner below which a point lies on the opposite side

/// The sides of a face, each from corner i to corner i + 1.
std::array<Halfedge, 3> sides_of(const Mesh& mesh, const std::array<Vertex, 3>& corners) {
    std::array<Halfedge, 3> sides;
    for (int i = 0; i < 3; ++i) sides[i] = mesh.halfedge(corners[i], corners[(i + 1) % 3]);
    return sides;
}

/// Returns `point`, or the nearest point of those sides of its face that are lines, if that is nearer than
/// `near` (m).
SurfacePoint drawn_to_lines(const Patch& patch, const SurfacePoint& point, double near) {
    const Vector3d place = position(patch.mesh, point);
    const std::array<Halfedge, 3> sides = sides_of(patch.mesh, point.corners);
    SurfacePoint drawn = point;
    for (int i = 0; i < 3; ++i) {
        if (!patch.line[patch.mesh.edge(sides[i])]) continue;
        const Vector3d from = position(patch.mesh, point.corners[i]);
        const Vector3d side = position(patch.mesh, point.corners[(i + 1) % 3]) - from;
        const double t = std::clamp((place - from).dot(side) / side.squaredNorm(), 0.0, 1.0);
        const double distance = (place - from - t * side).norm();
        if (distance >= near) continue;
        near = distance;
        drawn.weights.setZero();
        drawn.weights[i] = 1 - t;
        drawn.weights[(i + 1) % 3] = t;
    }
    return drawn;
}

/// Whether corner number `corner` of the point's face may be moved to the point.
bool may_move(const Patch& patch, int corner, const SurfacePoint& point) {
    const std::array<Halfedge, 3> sides = sides_of(patch.mesh, point.corners);
    const auto is_on_line = [&](int side) {
        return point.weights[(side + 2) % 3] < on_side && patch.line[patch.mesh.edge(sides[side])];
    };
    const Mobility mobility = patch.mobility[point.corners[corner]];
    if (mobility == Mobility::slides) return is_on_line(corner) || is_on_line((corner + 2) % 3);
    return mobility == Mobility::free && !is_on_line(0) && !is_on_line(1) && !is_on_line(2);
}

Candidate moved_corner(const Patch& patch, Vertex corner, const SurfacePoint& point) {
    auto trial = std::make_unique<PatchTrial>(patch);
    trial->move(corner, point);
    trial->fix(corner);
    return plain_candidate(std::move(trial), corner, AdvancedEdge::Way::snapped, 0);
}

Candidate inserted_vertex(const Patch& patch, const SurfacePoint& point) {
    auto trial = std::make_unique<PatchTrial>(patch);
    const std::array<Halfedge, 3> sides = sides_of(patch.mesh, point.corners);
    Vertex inserted = Mesh::null_vertex();
    for (int i = 0; i < 3 && !inserted.is_valid(); ++i)
        if (point.weights[(i + 2) % 3] < on_side)
            inserted =
                trial->split_edge(sides[i], point.weights[(i + 1) % 3] / (1 - point.weights[(i + 2) % 3]));
    if (!inserted.is_valid()) {
        const Face face = patch.mesh.face(sides[0]);
        const std::array<Vertex, 3> corners = face_corners(patch.mesh, face);
        Vector3d weights;
        for (int i = 0; i < 3; ++i) weights[corner_number(corners, point.corners[i])] = point.weights[i];
        inserted = trial->split_face(face, weights);
    }
    return plain_candidate(std::move(trial), inserted, AdvancedEdge::Way::cut, 0);
}

std::vector<Vertex> centres_at(const Mesh& mesh, const SurfacePoint& point) {
    std::vector<Vertex> centres(point.corners.begin(), point.corners.end());
    for (const Halfedge h : sides_of(mesh, point.corners))
        if (const Halfedge over = mesh.opposite(h); !mesh.is_border(over))
            centres.push_back(mesh.target(mesh.next(over)));
    return centres;
}

/// Makes a vertex at `point` as advance_edge() does: moves a corner of the face of the point there, or
/// inserts a vertex. If a line is within `near` (m) of the point, the nearest point of the line is used
/// instead. If a corner within `near` cannot be moved, the corner is used as it is. The best change is made,
/// whatever its angles.
PlacedVertex place_vertex(Mesh& mesh, const SurfacePoint& point, double near, const AdvanceOptions& options) {
    const Patch patch = patch_around(mesh, centres_at(mesh, point), options.kept);
    SurfacePoint local = point;
    for (Vertex& corner : local.corners) corner = patch.local(corner);
    local = drawn_to_lines(patch, local, near);
    const Vector3d place = position(patch.mesh, local);
    std::array<int, 3> order{0, 1, 2};
    const auto distance = [&](int i) { return (position(patch.mesh, local.corners[i]) - place).norm(); };
    std::ranges::sort(order, {}, distance);
    const bool is_free = options.snap && may_move(patch, order[0], local);
    if (distance(order[0]) <= (is_free ? on_side * near : near))
        return {patch.vertices[local.corners[order[0]]], std::numbers::pi, {}};

    std::vector<Candidate> snaps, cuts;
    for (const int i : order)
        if (options.snap && may_move(patch, i, local))
            snaps.push_back(moved_corner(patch, local.corners[i], local));
    cuts.push_back(inserted_vertex(patch, local));
    AdvanceOptions best = options;
    best.always_straight = true;
    const Candidate choice = chosen(std::move(snaps), std::move(cuts), best);
    if (!choice.trial) return {patch.vertices[local.corners[order[0]]], std::numbers::pi, {}};
    PatchTrial::Applied applied = choice.trial->apply(mesh);
    return {applied.vertices[choice.vertex], choice.angle, std::move(applied.change)};
}

constexpr double sample_spacing = 0.25, near_stop = 0.05, off_rim = 0.1;  // mean edges

std::string text_of(const Vector3d& place) {
    std::ostringstream text;
    text << "(" << place.x() << ", " << place.y() << ", " << place.z() << ")";
    return text.str();
}

/// Finds the point of a surface that is nearest to a given point.
class NearestOnSurface {
  public:
    explicit NearestOnSurface(const Mesh& mesh) : mesh(mesh) {
        for (const Face face : mesh.faces()) {
            const auto [a, b, c] = face_corners(mesh, face);
            triangles.emplace_back(mesh.point(a), mesh.point(b), mesh.point(c));
        }
        tree.insert(triangles.cbegin(), triangles.cend());
    }

    struct Found {
        Face face;
        Vector3d place;
        bool is_outside;  ///< whether the given point, seen along the normal of the face, lies beyond the rim
    };
    Found operator()(const Vector3d& point, double tolerance) const {
        const auto [at, primitive] = tree.closest_point_and_primitive({point.x(), point.y(), point.z()});
        const Face face(static_cast<Mesh::size_type>(primitive - triangles.cbegin()));
        const Vector3d place(at.x(), at.y(), at.z());
        const Vector3d normal = triangle_normal(face_points(mesh, face)).normalized(), way = point - place;
        return {face, place, normal.cross(way).norm() > tolerance && is_on_rim(face, place)};
    }

  private:
    bool is_on_rim(Face face, const Vector3d& place) const {
        constexpr double round_off = 1e-6;
        const SurfacePoint point = nearest_point(mesh, face, place);
        for (int i = 0; i < 3; ++i) {
            const Halfedge side = mesh.halfedge(point.corners[i], point.corners[(i + 1) % 3]);
            if (point.weights[(i + 2) % 3] < round_off && mesh.is_border(mesh.opposite(side))) return true;
        }
        return false;
    }

    const Mesh& mesh;
    std::vector<Kernel::Triangle_3> triangles;
    AabbTree<TrianglePrimitive> tree;
};

bool turns(const Vector3d& before, const Vector3d& at, const Vector3d& after) {
    const Vector3d in = (at - before).normalized(), out = (after - at).normalized();
    return in.dot(out) < std::cos(20 * std::numbers::pi / 180);
}

double longest_side(const Mesh& mesh, Face face) {
    const std::array<Vector3d, 3> p = face_points(mesh, face);
    return std::max({(p[1] - p[0]).norm(), (p[2] - p[1]).norm(), (p[0] - p[2]).norm()});
}

std::vector<LinePoint> without_repeats(std::span<const LinePoint> line) {
    std::vector<LinePoint> points;
    for (const LinePoint& point : line)
        if (points.empty() || point.place != points.back().place) points.push_back(point);
    return points;
}

}  // namespace

LineCut::LineCut(Mesh& mesh, bool keep_vertices)
    : mesh(mesh), surface(mesh), mean_edge(measure(mesh).mean_edge), smallest(std::numbers::pi) {
    options.snap = !keep_vertices;
    options.always_straight = true;
    const std::size_t old = keep_vertices ? mesh.number_of_vertices() : 0;
    options.kept.is_fixed_vertex = [this, old](Vertex v) { return v.idx() < old || kept.contains(v); };
    options.kept.is_line = [this](Edge e) { return on_path.contains(e); };
}

LineCut::Curve LineCut::project(std::span<const LinePoint> line) const {
    const NearestOnSurface nearest(surface);
    Curve curve;
    const bool is_closed = line.front().place == line.back().place;
    const auto add_stop = [&](std::size_t i) {
        const auto found = nearest(line[i].place, off_rim * mean_edge);
        const double distance = (found.place - line[i].place).norm(),
                     longest = longest_side(surface, found.face);
        if (!(distance <= longest))
            throw Error(line[i].name + ": the point " + text_of(line[i].place) + " is " +
                        std::to_string(distance) + " m from the mesh, more than the longest edge there (" +
                        std::to_string(longest) + " m)");
        const bool is_end = i == 0 || i + 1 == line.size();
        const bool is_third = is_closed && (i == line.size() / 3 || i == 2 * line.size() / 3);
        if (is_end || is_third || turns(line[i - 1].place, line[i].place, line[i + 1].place)) {
            curve.stops.push_back(curve.points.size());
            curve.ends.push_back(i);
        }
        curve.points.push_back(found.place);
        return found.is_outside;
    };
    bool is_outside = add_stop(0);
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Vector3d from = line[i - 1].place, way = line[i].place - from;
        const int parts = static_cast<int>(std::ceil(way.norm() / (sample_spacing * mean_edge)));
        bool has_left = false;
        for (int k = 1; k < parts; ++k) {
            const auto found = nearest(from + way * k / parts, off_rim * mean_edge);
            if (!found.is_outside && has_left)
                throw Error(line[i].name + ": the line leaves the mesh on its way to this point, near " +
                            text_of(curve.points.back()));
            has_left = found.is_outside && !(is_outside && i == 1);
            is_outside = found.is_outside;
            if (!found.is_outside) curve.points.push_back(found.place);
        }
        is_outside = add_stop(i);
        if ((is_outside || has_left) && i + 1 < line.size())
            throw Error(line[i].name + ": the line leaves the mesh at this point " + text_of(line[i].place));
    }
    return curve;
}

Vertex LineCut::vertex_at(const Vector3d& place) {
    SurfacePoint nearest;
    double least = std::numeric_limits<double>::infinity();
    for (const Face face : mesh.faces()) {
        const SurfacePoint point = nearest_point(mesh, face, place);
        const double distance = (position(mesh, point) - place).squaredNorm();
        if (distance >= least) continue;
        least = distance;
        nearest = point;
    }
    const PlacedVertex placed = place_vertex(mesh, nearest, near_stop * mean_edge, options);
    follow(placed.change, placed.smallest_angle);
    kept.insert(placed.vertex);
    return placed.vertex;
}

void LineCut::follow(const TopologyChange& change, double angle) {
    smallest = std::min(smallest, angle);
    for (const WithParents<Vertex>& vertex : change.moved)
        if (vertex.element.idx() < surface.number_of_vertices()) moved.insert(vertex.element);
    for (const WithParents<Edge>& edge : change.edges) {
        if (!edge.is_copy() || !on_path.contains(edge.parent())) continue;
        on_path.insert(edge.element);
        path.push_back(edge.element);
    }
}

void LineCut::add(Halfedge made) {
    kept.insert(mesh.target(made));
    if (mesh.is_border(mesh.edge(made)) || !on_path.insert(mesh.edge(made)).second) return;
    path.push_back(mesh.edge(made));
}

void LineCut::walk(Vertex from, Vertex to, std::span<const Vector3d> curve, const std::string& name) {
    std::size_t done = 0, steps = 20 + 4 * curve.size();
    options.goal = to;
    for (Vertex tip = from; tip != to;) {
        const Vector3d here = position(mesh, tip), end = position(mesh, to);
        const double size = mean_edge_at(mesh, tip);
        std::size_t ahead = done;
        while (ahead + 1 < curve.size() && (curve[ahead] - here).norm() < size) ++ahead;
        options.reach = (end - here).norm();
        const bool is_near_end = ahead + 1 == curve.size() || mesh.halfedge(tip, to).is_valid();
        const Vector3d direction = (is_near_end ? end : curve[ahead]) - here;
        auto advanced = advance_edge(mesh, tip, direction, options);
        if (!advanced)
            throw Error(name + ": the line leaves the mesh at " + text_of(here) +
                        " on its way to this point");
        if (steps-- == 0)
            throw Error(
                name +
                ": the line cannot be followed to this point; its points may be closer to each other " +
                "than the mesh edges are long: leave some out or remesh");
        follow(advanced->change, advanced->smallest_angle);
        add(advanced->halfedge);
        tip = mesh.target(advanced->halfedge);
        const auto nearer = [&](const Vector3d& a, const Vector3d& b) {
            return (a - position(mesh, tip)).norm() < (b - position(mesh, tip)).norm();
        };
        const auto window = curve.subspan(done, std::min(curve.size(), ahead + 4) - done);
        done += std::min_element(window.begin(), window.end(), nearer) - window.begin();
    }
}

void LineCut::cut(std::span<const LinePoint> given) {
    const std::vector<LinePoint> line = without_repeats(given);
    if (line.size() < 2) throw Error(given.front().name + ": a line needs two different points");
    const Curve curve = project(line);
    std::vector<Vertex> stops;
    for (const std::size_t stop : curve.stops) stops.push_back(vertex_at(curve.points[stop]));
    for (std::size_t i = 1; i < stops.size(); ++i) {
        const std::size_t begin = curve.stops[i - 1], end = curve.stops[i] + 1;
        walk(stops[i - 1], stops[i], std::span(curve.points).subspan(begin, end - begin),
             line[curve.ends[i]].name);
    }
}

double LineCut::length() const {
    double sum = 0;
    for (const Edge edge : path)
        sum += (position(mesh, mesh.vertex(edge, 1)) - position(mesh, mesh.vertex(edge, 0))).norm();
    return sum;
}

std::size_t LineCut::inserted_vertices() const {
    return mesh.number_of_vertices() - surface.number_of_vertices();
}

}  // namespace sherd
