// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/topology/retriangulation.h"

#include <CGAL/boost/graph/Euler_operations.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "meshops/mesh.h"
#include "meshops/mesh_measures.h"
#include "meshops/plane.h"
#include "meshops/topology/inherit_attributes.h"

namespace sherd {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// The faces around a vertex, unfolded into a plane. The vertex is the origin, the edges at the vertex have
/// their lengths, and the angles at the vertex are scaled so that their sum is 2 pi, or pi on the boundary.
struct UnfoldedFan {
    std::vector<Face> faces;       ///< counterclockwise
    std::vector<Vertex> ring;      ///< faces[i] has the corners vertex, ring[i], ring[i + 1]
    std::vector<Vector2d> places;  ///< m, places of the ring's vertices in the plane
};

/// Returns the halfedge from the vertex at which all faces at the vertex begin, counterclockwise.
Halfedge first_outward(const Mesh& mesh, Vertex vertex) {
    for (const Halfedge in : mesh.halfedges_around_target(mesh.halfedge(vertex)))
        if (mesh.is_border(in)) return mesh.opposite(in);
    return mesh.opposite(mesh.halfedge(vertex));
}

/// Unfolds the faces around a vertex. The ring of an interior vertex ends with its first vertex.
UnfoldedFan unfold_fan(const Mesh& mesh, Vertex vertex) {
    const Vector3d centre = position(mesh, vertex);
    UnfoldedFan fan;
    std::vector<double> angles{0}, lengths;
    const Halfedge first = first_outward(mesh, vertex);
    Halfedge out = first;
    for (;;) {
        fan.ring.push_back(mesh.target(out));
        const Vector3d side = position(mesh, mesh.target(out)) - centre;
        lengths.push_back(side.norm());
        if (mesh.is_border(out)) break;
        fan.faces.push_back(mesh.face(out));
        const Vector3d next = position(mesh, mesh.target(mesh.next(out))) - centre;
        angles.push_back(angles.back() + std::atan2(side.cross(next).norm(), side.dot(next)));
        out = mesh.opposite(mesh.prev(out));
        if (out != first) continue;
        fan.ring.push_back(mesh.target(first));
        lengths.push_back(lengths.front());
        break;
    }
    const double whole = mesh.is_border(out) ? std::numbers::pi : 2 * std::numbers::pi;
    const double scale = whole / angles.back();
    for (std::size_t i = 0; i < fan.ring.size(); ++i)
        fan.places.emplace_back(lengths[i] * std::cos(scale * angles[i]),
                                lengths[i] * std::sin(scale * angles[i]));
    return fan;
}

/// Unfolds the faces at h into a plane. Returns the places (m) of the source of h, which is the origin; of
/// its target, on the x axis; of the third corner of the face at h, above the axis; and of the third corner
/// of the opposite face, below the axis.
std::array<Vector2d, 4> unfold_pair(const Mesh& mesh, Halfedge h) {
    const Vector3d source = position(mesh, mesh.source(h));
    const Vector3d side = position(mesh, mesh.target(h)) - source;
    const double length = side.norm();
    const auto apex = [&](Halfedge at) {
        const Vector3d way = position(mesh, mesh.target(mesh.next(at))) - source;
        return Vector2d(way.dot(side) / length, way.cross(side).norm() / length);
    };
    const Vector2d above = apex(h), below = apex(mesh.opposite(h));
    return {Vector2d::Zero(), Vector2d(length, 0), above, Vector2d(below.x(), -below.y())};
}

using PlaneTriangle = std::array<Vector2d, 3>;  ///< counterclockwise

/// Returns the part of a convex polygon to the left of the line from a to b.
std::vector<Vector2d> left_part(const std::vector<Vector2d>& polygon, const Vector2d& a, const Vector2d& b) {
    std::vector<Vector2d> part;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vector2d &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const double at_p = cross(b - a, p - a), at_q = cross(b - a, q - a);
        if (at_p >= 0) part.push_back(p);
        if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0))
            part.emplace_back(p + at_p / (at_p - at_q) * (q - p));
    }
    return part;
}

/// Returns the area that two triangles have in common.
double common_area(const PlaneTriangle& a, const PlaneTriangle& b) {
    std::vector<Vector2d> part(a.begin(), a.end());
    for (int i = 0; i < 3 && !part.empty(); ++i) part = left_part(part, b[i], b[(i + 1) % 3]);
    double doubled = 0;
    for (std::size_t i = 2; i < part.size(); ++i) doubled += cross(part[i - 1] - part[0], part[i] - part[0]);
    return std::max(doubled, 0.0) / 2;
}

/// Returns the fraction of each old triangle that each new triangle covers: [new, old]. Old and new triangles
/// cover the same polygon, so that the sum of each column is 1. If round-off or curvature makes the polygons
/// differ, the fractions are scaled to this sum.
Eigen::MatrixXd covered_fractions(std::span<const PlaneTriangle> now, std::span<const PlaneTriangle> old) {
    constexpr double round_off = 1e-15;
    Eigen::MatrixXd fractions(now.size(), old.size());
    for (std::size_t j = 0; j < old.size(); ++j) {
        for (std::size_t i = 0; i < now.size(); ++i) fractions(i, j) = common_area(now[i], old[j]);
        auto column = fractions.col(static_cast<Eigen::Index>(j));
        column = (column.array() < round_off * column.sum()).select(0, column);
        const double sum = column.sum();
        if (sum > 0)
            column /= sum;
        else
            column.setConstant(1.0 / static_cast<double>(now.size()));
    }
    return fractions;
}

bool has_corner(const Mesh& mesh, Face face, Vertex vertex) {
    return corner_number(face_corners(mesh, face), vertex) < 3;
}

/// Returns the faces of a fan as triangles in its plane, after its vertex has been moved to `centre`.
std::vector<PlaneTriangle> triangles_of(const UnfoldedFan& fan, const Vector2d& centre) {
    std::vector<PlaneTriangle> triangles;
    for (std::size_t i = 0; i < fan.faces.size(); ++i)
        triangles.push_back({centre, fan.places[i], fan.places[i + 1]});
    return triangles;
}

/// Returns the place, in the plane of the fan around the vertex `centre`, of the point of its faces that is
/// nearest to `point` (m).
Vector2d place_in(const UnfoldedFan& fan, const Mesh& mesh, Vertex centre, const Vector3d& point) {
    double least = std::numeric_limits<double>::infinity();
    Vector2d place = Vector2d::Zero();
    for (std::size_t i = 0; i < fan.faces.size(); ++i) {
        const std::array triangle{position(mesh, centre), position(mesh, fan.ring[i]),
                                  position(mesh, fan.ring[i + 1])};
        const Vector3d w = nearest_weights(triangle, point);
        const double distance = (w[0] * triangle[0] + w[1] * triangle[1] + w[2] * triangle[2] - point).norm();
        if (distance >= least) continue;
        least = distance;
        place = w[1] * fan.places[i] + w[2] * fan.places[i + 1];
    }
    return place;
}

template <class Element>
std::vector<typename WithParents<Element>::Parent> parents_of(const std::map<Element, double>& weights) {
    std::vector<typename WithParents<Element>::Parent> parents;
    for (const auto& [element, weight] : weights) parents.push_back({element, weight});
    std::ranges::stable_sort(parents, [](const auto& a, const auto& b) { return a.weight > b.weight; });
    return parents;
}

}  // namespace

Retriangulation::Retriangulation(Mesh& mesh)
    : mesh(mesh),
      old_vertices(mesh.number_of_vertices()),
      old_edges(mesh.number_of_edges()),
      old_face_count(mesh.number_of_faces()) {}

void Retriangulation::replace(Face face) {
    if (face == Mesh::null_face() || shares.contains(face)) return;
    const Vector3d normal = triangle_normal(face_points(mesh, face));
    old_faces[face] = {face_corners(mesh, face), normal.norm() / 2, normal};
    shares[face] = {{face, 1}};
}

void Retriangulation::distribute_fractions(const std::map<Face, Fractions>& received) {
    std::map<Face, Fractions> now;
    for (const auto& [face, parts] : received) {
        Fractions& fractions = now[face];
        for (const auto& [from, part] : parts)
            for (const auto& [old, share] : shares.at(from)) fractions[old] += part * share;
    }
    for (auto& [face, fractions] : now) shares[face] = std::move(fractions);
}

Retriangulation::VertexWeights Retriangulation::weights_of(Vertex vertex) const {
    const auto known = places.find(vertex);
    return known == places.end() ? VertexWeights{{vertex, 1}} : known->second;
}

Vector3d Retriangulation::old_position(Vertex vertex) const {
    const auto known = origin.find(vertex);
    return known == origin.end() ? position(mesh, vertex) : known->second;
}

void Retriangulation::put(Vertex vertex, const VertexWeights& weights) {
    Vector3d place = Vector3d::Zero();
    for (const auto& [parent, weight] : weights) place += weight * old_position(parent);
    if (vertex.idx() < old_vertices) origin.try_emplace(vertex, position(mesh, vertex));
    mesh.point(vertex) = point_at(place);
    places[vertex] = weights;
}

void Retriangulation::add_edges(Edge half, Edge copy) {
    for (std::size_t e = old_edges + inserted_edges.size(); e < mesh.number_of_edges(); ++e)
        inserted_edges.push_back({Edge(static_cast<Mesh::size_type>(e)), {}});
    if (!copy.is_valid()) return;
    std::vector<WithParents<Edge>::Parent> parents{{half, 1}};
    if (half.idx() >= old_edges)
        parents = inserted_edges[half.idx() - old_edges].parents;
    else if (std::ranges::count(turned, half) > 0)
        parents.clear();
    inserted_edges[copy.idx() - old_edges].parents = parents;
}

Vertex Retriangulation::split_edge(Halfedge h, double t) {
    const Vertex source = mesh.source(h), target = mesh.target(h);
    VertexWeights weights;
    for (const auto& [vertex, weight] : weights_of(source)) weights[vertex] += (1 - t) * weight;
    for (const auto& [vertex, weight] : weights_of(target)) weights[vertex] += t * weight;
    replace(mesh.face(h));
    replace(mesh.face(mesh.opposite(h)));
    const Halfedge to_new = CGAL::Euler::split_edge(h, mesh);
    const Vertex created = mesh.target(to_new);
    put(created, weights);
    add_edges(mesh.edge(h), mesh.edge(to_new));

    std::map<Face, Fractions> received;
    for (const Halfedge in : {to_new, mesh.opposite(h)}) {
        if (mesh.is_border(in)) continue;
        const Face face = mesh.face(in);
        CGAL::Euler::split_face(in, mesh.next(mesh.next(in)), mesh);
        for (const Halfedge side : {in, mesh.next(mesh.opposite(mesh.next(in)))}) {
            const Face part = mesh.face(side);
            received[part][face] = has_corner(mesh, part, source) ? t : 1 - t;
        }
    }
    add_edges(Edge(), Edge());
    distribute_fractions(received);
    return created;
}

Vertex Retriangulation::split_face(Face face, const Vector3d& weights) {
    replace(face);
    const std::array<Vertex, 3> corners = face_corners(mesh, face);
    VertexWeights merged;
    for (int i = 0; i < 3; ++i)
        for (const auto& [vertex, weight] : weights_of(corners[i])) merged[vertex] += weights[i] * weight;
    const Vertex created = mesh.target(CGAL::Euler::add_center_vertex(mesh.halfedge(face), mesh));
    put(created, merged);
    add_edges(Edge(), Edge());
    std::map<Face, Fractions> received;
    for (const Face part : mesh.faces_around_target(mesh.halfedge(created)))
        for (int i = 0; i < 3; ++i)
            if (!has_corner(mesh, part, corners[i])) received[part][face] = weights[i];
    distribute_fractions(received);
    return created;
}

bool Retriangulation::can_flip(Edge edge) const {
    if (mesh.is_border(edge)) return false;
    const Halfedge h = mesh.halfedge(edge), g = mesh.opposite(h);
    const Vertex above = mesh.target(mesh.next(h)), below = mesh.target(mesh.next(g));
    if (above == below || mesh.halfedge(above, below).is_valid()) return false;
    const auto [source, target, a, b] = unfold_pair(mesh, h);
    const double scale = 1e-9 * target.x() * target.x();
    if (cross(b - source, a - source) <= scale || cross(a - target, b - target) <= scale) return false;
    const Vector3d s = position(mesh, mesh.source(h)), t = position(mesh, mesh.target(h));
    const Vector3d p = position(mesh, above), q = position(mesh, below);
    const Vector3d normal = triangle_normal({s, t, p}) + triangle_normal({t, s, q});
    return triangle_normal({s, q, p}).dot(normal) > 0 && triangle_normal({t, p, q}).dot(normal) > 0;
}

void Retriangulation::flip(Edge edge) {
    const Halfedge h = mesh.halfedge(edge), g = mesh.opposite(h);
    const std::array faces{mesh.face(h), mesh.face(g)};
    for (const Face face : faces) replace(face);
    const std::array vertices{mesh.source(h), mesh.target(h), mesh.target(mesh.next(h)),
                              mesh.target(mesh.next(g))};
    const auto places = unfold_pair(mesh, h);
    const auto triangle = [&](Face face) {
        PlaneTriangle corners;
        const std::array<Vertex, 3> of_face = face_corners(mesh, face);
        for (int i = 0; i < 3; ++i)
            corners[i] = places[std::ranges::find(vertices, of_face[i]) - vertices.begin()];
        return corners;
    };
    const std::array old{triangle(faces[0]), triangle(faces[1])};
    CGAL::Euler::flip_edge(h, mesh);
    const std::array now{triangle(faces[0]), triangle(faces[1])};
    const Eigen::MatrixXd parts = covered_fractions(now, old);
    std::map<Face, Fractions> received;
    for (const Face face : faces) received[face];
    for (const int i : {0, 1})
        for (const int j : {0, 1})
            if (parts(i, j) > 0) received[faces[i]][faces[j]] = parts(i, j);
    distribute_fractions(received);
    if (edge.idx() >= old_edges)
        inserted_edges[edge.idx() - old_edges].parents.clear();
    else if (std::ranges::count(turned, edge) == 0)
        turned.push_back(edge);
}

void Retriangulation::move(Vertex vertex, const SurfacePoint& place) {
    const UnfoldedFan fan = unfold_fan(mesh, vertex);
    for (const Face face : fan.faces) replace(face);
    VertexWeights weights;
    Vector3d target = Vector3d::Zero();
    for (int i = 0; i < 3; ++i) {
        if (place.weights[i] == 0) continue;
        weights[place.corners[i]] += place.weights[i];
        target += place.weights[i] * old_position(place.corners[i]);
    }
    const Vector2d centre = place_in(fan, mesh, vertex, target);
    const Eigen::MatrixXd parts =
        covered_fractions(triangles_of(fan, centre), triangles_of(fan, Vector2d::Zero()));
    std::map<Face, Fractions> received;
    for (const Face face : fan.faces) received[face];
    for (std::size_t i = 0; i < fan.faces.size(); ++i)
        for (std::size_t j = 0; j < fan.faces.size(); ++j)
            if (parts(i, j) > 0) received[fan.faces[i]][fan.faces[j]] = parts(i, j);
    put(vertex, weights);
    distribute_fractions(received);
}

std::vector<Face> Retriangulation::changed_faces() const {
    std::vector<Face> faces;
    for (const auto& [face, of_face] : shares) faces.push_back(face);
    return faces;
}

Vector3d Retriangulation::parent_normal(Face face) const {
    Vector3d sum = Vector3d::Zero();
    for (const auto& [old, share] : shares.at(face)) sum += share * old_faces.at(old).normal;
    return sum;
}

TopologyChange Retriangulation::finish() {
    TopologyChange change;
    for (const auto& [vertex, weights] : places)
        (vertex.idx() < old_vertices ? change.moved : change.vertices)
            .push_back({vertex, parents_of(weights)});
    change.edges = inserted_edges;
    change.flipped = turned;
    std::ranges::sort(change.flipped);
    for (const auto& [face, fractions] : shares) {
        change.reshaped.push_back({face, parents_of(fractions)});
        if (face.idx() < old_face_count) {
            change.changed.push_back(face);
            continue;
        }
        std::map<Face, double> weights;
        double area = 0;
        for (const auto& [old, share] : fractions) area += share * old_faces.at(old).area;
        for (const auto& [old, share] : fractions) weights[old] = share * old_faces.at(old).area / area;
        change.faces.push_back({face, parents_of(weights)});
    }
    inherit_attributes(mesh, old_faces, change);
    return change;
}

}  // namespace sherd
