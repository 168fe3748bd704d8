// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/topology/advance/advance_edge.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "meshops/mesh_measures.h"
#include "meshops/topology/advance/surface_ray.h"
#include "meshops/topology/advance/trial_choice.h"

namespace sherd {
namespace {

using Eigen::Vector3d;
using Way = AdvancedEdge::Way;

constexpr double longest = 1.6, shortest_rest = 0.5;  // mean edges: longest edge, shortest path after its end
constexpr double on_ray = 1e-10;                      // rad: an edge at a smaller angle to the ray lies on it

/// All possible changes of a patch that make an edge along a ray.
class Course {
  public:
    /// size: mean length of the edges at the tip, m.
    Course(const Patch& patch, Vertex tip, SurfaceRay ray, double size, const AdvanceOptions& options)
        : patch(patch), tip(tip), ray(std::move(ray)), size(size) {
        const bool is_in_reach = options.reach <= longest * size && !this->ray.end().is_valid();
        ends = this->ray.end().is_valid() || (is_in_reach && !options.goal.is_valid());
        const double rest = ends || is_in_reach ? this->ray.length() : options.reach;
        limit = std::min(this->ray.length(), rest - shortest_rest * size);
        Halfedge h = patch.mesh.halfedge(this->ray.first_face());
        while (patch.mesh.source(h) != tip) h = patch.mesh.next(h);
        side = patch.mesh.next(h);
    }

    /// Returns the two neighbours of the tip beside the ray, the one at the smaller angle to the ray first.
    std::array<Vertex, 2> neighbours() const {
        std::array both{patch.mesh.source(side), patch.mesh.target(side)};
        if (off_course(both[1]) < off_course(both[0])) std::swap(both[0], both[1]);
        return both;
    }

    double off_course(Vertex neighbour) const {
        const Vector3d way = way_to(neighbour);
        return std::atan2(way.cross(ray.direction()).norm(), way.dot(ray.direction()));
    }

    /// Whether an edge may end at this distance (m) along the ray.
    bool may_end_at(double distance) const {
        if (ends && std::abs(distance - ray.length()) <= 1e-9 * size) return true;
        return distance > 0 && distance <= limit;
    }

    bool lies_on_ray(Vertex neighbour) const {
        return off_course(neighbour) < on_ray && may_end_at(way_to(neighbour).norm());
    }

    Candidate best_snap(Vertex neighbour) const {
        Candidate best;
        std::vector<double> distances = samples();
        const double foot = way_to(neighbour).dot(ray.direction());
        if (may_end_at(foot)) distances.push_back(foot);
        for (const double distance : distances) {
            Candidate snap = snapped(neighbour, distance);
            if (snap.angle > best.angle) best = std::move(snap);
        }
        return best;
    }

    std::vector<Candidate> cuts() const {
        std::vector<Candidate> all;
        std::vector<double> distances = samples();
        const double crossing = crossing_distance();
        if (crossing < ray.length() && may_end_at(crossing)) distances.push_back(crossing);
        for (const double distance : distances)
            if (Candidate cut = cut_at(distance); cut.trial) all.push_back(std::move(cut));
        return all;
    }

    /// Returns a candidate that makes an edge to `goal` by flipping `side`, if `goal` is the vertex across
    /// it; without a trial if the flip is impossible.
    Candidate flipped_to(Vertex goal) const {
        const Halfedge over = patch.mesh.opposite(side);
        auto trial = std::make_unique<PatchTrial>(patch);
        if (!goal.is_valid() || patch.mesh.is_border(over) ||
            patch.mesh.target(patch.mesh.next(over)) != goal || !trial->can_flip(patch.mesh.edge(side)))
            return {};
        trial->flip(patch.mesh.edge(side));
        return kept(std::move(trial), goal, Way::relaxed, way_to(goal).norm());
    }

    const SurfaceRay& line() const { return ray; }

  private:
    Vector3d way_to(Vertex vertex) const { return position(patch.mesh, vertex) - position(patch.mesh, tip); }

    std::vector<double> samples() const {
        std::vector<double> distances;
        for (double part = 0.5; part < longest; part += 0.1)
            if (part * size < (1 - 1e-6) * ray.length() && may_end_at(part * size))
                distances.push_back(part * size);
        if (ends)
            distances.push_back(ray.length());
        else if (distances.empty())
            distances.push_back(ray.length() / 2);
        return distances;
    }

    bool is_at_line(double distance) const { return ray.end().is_valid() && distance == ray.length(); }

    SurfacePoint place_at(double distance) const {
        if (!is_at_line(distance)) return ray.at(patch.mesh, distance);
        const Halfedge end = ray.end();
        const double t = ray.end_fraction();
        return {{patch.mesh.source(end), patch.mesh.target(end), patch.mesh.target(patch.mesh.next(end))},
                {1 - t, t, 0}};
    }

    static bool has(const SurfacePoint& place, Vertex corner) {
        return corner_number(place.corners, corner) < 3;
    }

    /// Crossing of the ray with `side`: fraction of the side, and distance (m) along the ray.
    double crossing_fraction() const {
        const Vector3d a = way_to(patch.mesh.source(side)), b = way_to(patch.mesh.target(side));
        const Vector3d normal = a.cross(b), across = normal.cross(ray.direction());
        return std::clamp(a.dot(across) / (a - b).dot(across), 0.0, 1.0);
    }
    double crossing_distance() const {
        const Vector3d a = way_to(patch.mesh.source(side)), b = way_to(patch.mesh.target(side));
        return (a + crossing_fraction() * (b - a)).dot(ray.direction());
    }

    Candidate snapped(Vertex neighbour, double distance) const {
        const SurfacePoint place = place_at(distance);
        const bool may_slide = patch.mobility[neighbour] == Mobility::slides && is_at_line(distance) &&
                               (place.corners[0] == neighbour || place.corners[1] == neighbour);
        const bool may_move = patch.mobility[neighbour] == Mobility::free && !is_at_line(distance);
        if ((!may_slide && !may_move) || !has(place, neighbour)) return {};
        auto trial = std::make_unique<PatchTrial>(patch);
        trial->move(neighbour, place);
        return kept(std::move(trial), neighbour, Way::snapped, distance);
    }

    Candidate cut_at(double distance) const {
        auto trial = std::make_unique<PatchTrial>(patch);
        const Vertex inserted = inserted_in(*trial, distance);
        if (!inserted.is_valid()) return {};
        return kept(std::move(trial), inserted, Way::cut, distance);
    }

    Vertex inserted_in(PatchTrial& trial, double distance) const {
        const Mesh& mesh = patch.mesh;
        const SurfacePoint place = place_at(distance);
        for (const Halfedge along : {mesh.opposite(mesh.prev(side)), mesh.next(side)}) {
            const Halfedge out = mesh.source(along) == tip ? along : mesh.opposite(along);
            if (off_course(mesh.target(out)) >= on_ray) continue;
            const double length = way_to(mesh.target(out)).norm();
            return distance < length ? trial.split_edge(out, distance / length) : Mesh::null_vertex();
        }
        if (is_at_line(distance) && (ray.end() != side || patch.rim[mesh.edge(side)]))
            return Mesh::null_vertex();
        if (is_at_line(distance)) return trial.split_edge(side, ray.end_fraction());
        if (patch.line[mesh.edge(side)]) return trial.split_face(ray.first_face(), in_first_face(place));
        if (!has(place, mesh.source(side)) || !has(place, mesh.target(side))) return Mesh::null_vertex();
        const Vertex inserted = trial.split_edge(side, crossing_fraction());
        trial.move(inserted, place);
        return inserted;
    }

    /// Returns the weights of a place in the first face of the ray, in the order of the corners of this face.
    Vector3d in_first_face(const SurfacePoint& place) const {
        const std::array<Vertex, 3> corners = face_corners(patch.mesh, ray.first_face());
        Vector3d weights = Vector3d::Zero();
        for (int i = 0; i < 3; ++i) weights[corner_number(corners, place.corners[i])] = place.weights[i];
        return weights;
    }

    Candidate kept(std::unique_ptr<PatchTrial> trial, Vertex vertex, Way way, double distance) const {
        trial->keep(trial->mesh().edge(trial->mesh().halfedge(tip, vertex)));
        return plain_candidate(std::move(trial), vertex, way, distance);
    }

    const Patch& patch;
    Vertex tip;
    SurfaceRay ray;
    double size;
    bool ends;      ///< whether an edge may end where the ray does
    double limit;   ///< m, largest distance at which an edge may end before that
    Halfedge side;  ///< side opposite to the tip of the first face of the ray
};

AdvancedEdge existing_edge(const Mesh& mesh, const Patch& patch, const Course& course, Vertex tip,
                           Vertex end) {
    const Vector3d way = position(patch.mesh, end) - position(mesh, tip);
    return {Way::existing,
            mesh.halfedge(tip, patch.vertices[end]),
            course.line().direction_at(std::min(way.norm(), course.line().length())),
            course.off_course(end),
            std::numbers::pi,
            {}};
}

/// Returns the vertices whose surroundings may be changed to make an edge along a ray: corners of its first
/// face, and the vertices across its sides.
std::vector<Vertex> centres_of(const Mesh& mesh, const SurfaceRay& ray) {
    const std::array<Vertex, 3> corners = face_corners(mesh, ray.first_face());
    std::vector<Vertex> centres(corners.begin(), corners.end());
    for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(ray.first_face())))
        if (const Halfedge over = mesh.opposite(h); !mesh.is_border(over))
            centres.push_back(mesh.target(mesh.next(over)));
    return centres;
}

}  // namespace

std::optional<AdvancedEdge> advance_edge(Mesh& mesh, Vertex tip, const Vector3d& direction,
                                         const AdvanceOptions& options) {
    const double size = mean_edge_at(mesh, tip), length = std::min(options.reach, longest * size);
    const auto far = SurfaceRay::from(mesh, tip, direction, length, [](Edge) { return false; });
    if (!far) return std::nullopt;
    const Patch patch = patch_around(mesh, centres_of(mesh, *far), options.kept);
    const Vertex local = patch.local(tip);
    auto ray =
        SurfaceRay::from(patch.mesh, local, direction, length, [&](Edge edge) { return patch.line[edge]; });
    if (!ray) return std::nullopt;
    const Course course(patch, local, *std::move(ray), size, options);

    const std::array<Vertex, 2> neighbours = course.neighbours();
    if (options.goal.is_valid() && mesh.halfedge(tip, options.goal).is_valid())
        return existing_edge(mesh, patch, course, tip, patch.local(options.goal));
    if (course.lies_on_ray(neighbours[0])) return existing_edge(mesh, patch, course, tip, neighbours[0]);
    std::vector<Candidate> snaps;
    for (const Vertex neighbour : neighbours)
        if (options.snap)
            if (Candidate snap = course.best_snap(neighbour); snap.trial) snaps.push_back(std::move(snap));
    if (Candidate flip = course.flipped_to(patch.local(options.goal)); flip.trial)
        snaps.insert(snaps.begin(), std::move(flip));
    const Candidate best = chosen(std::move(snaps), course.cuts(), options);
    if (!best.trial) return existing_edge(mesh, patch, course, tip, neighbours[0]);
    PatchTrial::Applied applied = best.trial->apply(mesh);
    return AdvancedEdge{best.way,
                        mesh.halfedge(tip, applied.vertices[best.vertex]),
                        course.line().direction_at(best.distance),
                        0,
                        best.angle,
                        std::move(applied.change)};
}

}  // namespace sherd
