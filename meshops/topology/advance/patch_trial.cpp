// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/topology/advance/patch_trial.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "meshops/mesh_measures.h"
#include "meshops/topology/advance/surface_ray.h"

namespace sherd {
namespace {

using Eigen::Vector3d;

constexpr double turned_over_angle = -1;  // less than any other angle

/// Returns the smallest angle of a triangle; turned_over_angle if the triangle faces away from `normal`.
double upright_angle(const std::array<Vector3d, 3>& corners, const Vector3d& normal) {
    return triangle_normal(corners).dot(normal) > 0 ? smallest_angle(corners) : turned_over_angle;
}

std::array<Vertex, 3> ends(const Mesh& mesh, Halfedge h) {
    return {mesh.source(h), mesh.target(h), Mesh::null_vertex()};
}

}  // namespace

PatchTrial::PatchTrial(const Patch& patch)
    : patch(patch), sheet(patch.mesh), edits(sheet), mobility(patch.mobility), line(patch.line) {}

void PatchTrial::add_vertex(Vertex inserted) {
    mobility.resize(inserted.idx() + 1, Mobility::fixed);
    line.resize(sheet.number_of_edges(), 0);
}

Vertex PatchTrial::split_edge(Halfedge h, double t) {
    steps.push_back({Step::split_edge, ends(sheet, h), Vector3d(1 - t, t, 0)});
    const char was_line = line[sheet.edge(h)];
    const Vertex source = sheet.source(h), target = sheet.target(h);
    const Vertex inserted = edits.split_edge(h, t);
    add_vertex(inserted);
    for (const Vertex end : {source, target}) line[sheet.edge(sheet.halfedge(inserted, end))] = was_line;
    return inserted;
}

Vertex PatchTrial::split_face(Face face, const Vector3d& weights) {
    steps.push_back({Step::split_face, face_corners(sheet, face), weights});
    const Vertex inserted = edits.split_face(face, weights);
    add_vertex(inserted);
    return inserted;
}

void PatchTrial::move(Vertex vertex, const SurfacePoint& place) {
    steps.push_back({Step::move, place.corners, place.weights, vertex});
    edits.move(vertex, place);
}

void PatchTrial::flip(Edge edge) {
    steps.push_back({Step::flip, ends(sheet, sheet.halfedge(edge)), Vector3d::Zero()});
    edits.flip(edge);
}

void PatchTrial::keep(Edge edge) {
    line[edge] = 1;
    for (const int side : {0, 1}) fix(sheet.vertex(edge, side));
}

double PatchTrial::angle_of(Face face) const {
    const std::array<Vector3d, 3> corners = face_points(sheet, face);
    return upright_angle(corners, edits.parent_normal(face));
}

double PatchTrial::smallest_angle() const {
    double smallest = std::numbers::pi;
    for (const Face face : edits.changed_faces()) smallest = std::min(smallest, angle_of(face));
    return smallest;
}

double PatchTrial::replaced_angle() const {
    double smallest = std::numbers::pi;
    for (const auto& [face, was] : edits.replaced())
        smallest = std::min(smallest, sherd::smallest_angle(face_points(patch.mesh, face)));
    return smallest;
}

double PatchTrial::star_angle(Vertex vertex, const Vector3d& place) const {
    double smallest = std::numbers::pi;
    for (const Face face : sheet.faces_around_target(sheet.halfedge(vertex))) {
        if (face == Mesh::null_face()) continue;
        std::array<Vector3d, 3> corners = face_points(sheet, face);
        const Vector3d normal = edits.is_changed(face) ? edits.parent_normal(face) : triangle_normal(corners);
        corners[corner_number(face_corners(sheet, face), vertex)] = place;
        smallest = std::min(smallest, upright_angle(corners, normal));
    }
    return smallest;
}

bool PatchTrial::flip_where_better() {
    constexpr double least_gain = 1e-6;  // rad: no flips to and fro by round-off
    std::set<Edge> near;
    for (const Face face : edits.changed_faces())
        for (const Halfedge h : sheet.halfedges_around_face(sheet.halfedge(face))) near.insert(sheet.edge(h));
    bool has_flipped = false;
    for (const Edge edge : near) {
        if (!can_flip(edge)) continue;
        const Halfedge h = sheet.halfedge(edge), g = sheet.opposite(h);
        const Vertex above = sheet.target(sheet.next(h)), below = sheet.target(sheet.next(g));
        const Vector3d s = position(sheet, sheet.source(h)), t = position(sheet, sheet.target(h));
        const Vector3d p = position(sheet, above), q = position(sheet, below);
        const double now = std::min(sherd::smallest_angle({s, t, p}), sherd::smallest_angle({t, s, q}));
        const double then = std::min(sherd::smallest_angle({s, q, p}), sherd::smallest_angle({t, p, q}));
        if (then < now + least_gain) continue;
        flip(edge);
        has_flipped = true;
    }
    return has_flipped;
}

SurfacePoint PatchTrial::on_old_surface(const Vector3d& place) const {
    SurfacePoint nearest;
    double least = std::numeric_limits<double>::infinity();
    for (const Face face : patch.mesh.faces()) {
        const SurfacePoint point = nearest_point(patch.mesh, face, place);
        const double distance = (position(patch.mesh, point) - place).squaredNorm();
        if (distance >= least) continue;
        least = distance;
        nearest = point;
    }
    return nearest;
}

bool PatchTrial::relax(Vertex vertex) {
    constexpr int ways = 8, halvings = 5;
    const Vector3d normal = vertex_normal(sheet, vertex).normalized();
    const Vector3d u = normal.unitOrthogonal(), v = normal.cross(u), from = position(sheet, vertex);
    const double before = star_angle(vertex, from);
    Vector3d best = from;
    double most = before, step = 0.25 * mean_edge_at(sheet, vertex);
    for (int i = 0; i < halvings; ++i, step /= 2) {
        const Vector3d centre = best;
        for (int k = 0; k < ways; ++k) {
            const double angle = 2 * std::numbers::pi * k / ways;
            const Vector3d place = centre + step * (std::cos(angle) * u + std::sin(angle) * v);
            const double smallest = star_angle(vertex, place);
            if (smallest <= most) continue;
            most = smallest;
            best = place;
        }
    }
    constexpr double least_gain = 1e-3;  // rad
    if (most < before + least_gain) return false;
    const SurfacePoint place = on_old_surface(best);
    if (star_angle(vertex, position(patch.mesh, place)) < before + least_gain) return false;
    move(vertex, place);
    return true;
}

void PatchTrial::improve(double bound) {
    constexpr int rounds = 6;
    for (int round = 0; round < rounds; ++round) {
        bool is_better = flip_where_better();
        std::set<Vertex> near;
        for (const Face face : edits.changed_faces())
            if (angle_of(face) < bound)
                for (const Vertex vertex : face_corners(sheet, face))
                    if (mobility[vertex] == Mobility::free) near.insert(vertex);
        for (const Vertex vertex : near) is_better = relax(vertex) || is_better;
        if (!is_better || smallest_angle() >= bound) return;
    }
}

PatchTrial::Applied PatchTrial::apply(Mesh& to) const {
    std::vector<Vertex> number = patch.vertices;
    Retriangulation edits_there(to);
    for (const Step& step : steps) {
        std::array<Vertex, 3> there;
        for (int i = 0; i < 3; ++i)
            there[i] = step.vertices[i].is_valid() ? number[step.vertices[i]] : Mesh::null_vertex();
        if (step.kind == Step::move) {
            edits_there.move(number[step.moved], {there, step.weights});
            continue;
        }
        const Halfedge h = to.halfedge(there[0], there[1]);
        if (step.kind == Step::flip) {
            edits_there.flip(to.edge(h));
        } else if (step.kind == Step::split_edge) {
            number.push_back(edits_there.split_edge(h, step.weights[1]));
        } else {
            Vector3d weights;
            const std::array<Vertex, 3> corners = face_corners(to, to.face(h));
            for (int i = 0; i < 3; ++i) weights[corner_number(corners, there[i])] = step.weights[i];
            number.push_back(edits_there.split_face(to.face(h), weights));
        }
    }
    return {edits_there.finish(), number};
}

}  // namespace sherd
