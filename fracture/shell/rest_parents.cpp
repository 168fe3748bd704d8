// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/shell/rest_parents.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/shell/thickness.h"
#include "fracture/shell/mesh_inheritance.h"
#include "meshops/mesh_measures.h"
#include "meshops/topology/surface_point.h"

namespace sherd {
namespace {

/// Fractions of areas, and deviations of weights, below this are round-off.
constexpr double nothing = 1e-10;

bool lies_in_parent(const RestMesh& rest, std::size_t face) {
    for (int corner = 0; corner < 3; ++corner)
        if (std::abs(place_in_parent(rest, face, corner).sum() - 1) > nothing) return false;
    return true;
}

}  // namespace

RestParents::RestParents(const Mesh& mesh) : start(3, mesh.number_of_vertices()) {
    for (const Vertex v : mesh.vertices()) {
        const auto number = static_cast<Index>(v);
        start.col(number) = position(mesh, v);
        column.push_back(number);
        vertex.push_back(number);
        places.push_back({{number, number, number}, {1, 0, 0}});
    }
    for (const Face face : mesh.faces()) {
        unfractured.push_back(face_vertices(mesh, face));
        area.push_back(face_area(mesh, face));
    }
}

RestParents::Parts RestParents::parts_of(Index face) const {
    const auto known = reshaped.find(face);
    return known == reshaped.end() ? Parts{{face, 1}} : known->second;
}

std::array<Vector3d, 3> RestParents::corners(Index unfractured_face) const {
    const auto& [a, b, c] = unfractured[unfractured_face];
    return {start.col(a), start.col(b), start.col(c)};
}

void RestParents::follow(const Mesh& mesh, const TopologyChange& change) {
    std::map<Index, Parts> now;
    for (const auto& [face, shares] : change.reshaped)
        for (const auto& [parent, share] : shares)
            for (const auto& [parent_at_rest, part] : parts_of(static_cast<Index>(parent)))
                if (share * part > nothing) now[static_cast<Index>(face)][parent_at_rest] += share * part;
    for (auto& [face, parts] : now) reshaped[face] = std::move(parts);
    for (const WithParents<Vertex>& inserted : change.vertices) {
        if (inserted.is_copy()) {
            column.push_back(column[inserted.parent()]);
            continue;
        }
        column.push_back(static_cast<Index>(places.size()));
        vertex.push_back(static_cast<Index>(inserted.element));
        places.push_back(place_of(mesh, inserted.element));
    }
    for (const WithParents<Vertex>& moved : change.moved)
        places[column[moved.element]] = place_of(mesh, moved.element);
}

RestParents::Place RestParents::place_of(const Mesh& mesh, Vertex at) const {
    Place nearest{};
    double least = std::numeric_limits<double>::infinity();
    for (const Face face : mesh.faces_around_target(mesh.halfedge(at))) {
        if (face == Mesh::null_face()) continue;
        for (const auto& [parent_at_rest, part] : parts_of(static_cast<Index>(face))) {
            const std::array<Vector3d, 3> points = corners(parent_at_rest);
            const Vector3d w = nearest_weights(points, position(mesh, at));
            const double distance =
                (w[0] * points[0] + w[1] * points[1] + w[2] * points[2] - position(mesh, at)).norm();
            if (distance >= least) continue;
            least = distance;
            nearest = {unfractured[parent_at_rest], {w[0], w[1], w[2]}};
        }
    }
    return nearest;
}

Index RestParents::parent_of(Index face) const {
    Index parent = face;
    double largest = -1;
    for (const auto& [parent_at_rest, part] : parts_of(face))
        if (part * area[parent_at_rest] > largest) {
            largest = part * area[parent_at_rest];
            parent = parent_at_rest;
        }
    return parent;
}

RestMesh RestParents::rest(const Shell& shell) const {
    RestMesh rest;
    rest.position.resize(3, static_cast<Eigen::Index>(places.size()));
    for (std::size_t r = 0; r < places.size(); ++r) {
        rest.position.col(static_cast<Eigen::Index>(r)) = shell.rest.col(vertex[r]);
        rest.vertex_parents.push_back(places[r].parents);
        rest.vertex_weights.push_back(places[r].weights);
    }
    for (std::size_t f = 0; f < shell.triangles.size(); ++f) {
        const auto& [a, b, c] = shell.triangles[f].vertices;
        rest.faces.push_back({column[a], column[b], column[c]});
        rest.area.push_back(shell.triangles[f].membrane.area);
        rest.thickness.push_back(mean_thickness(shell, shell.triangles[f].vertices));
        rest.face_parent.push_back(parent_of(static_cast<Index>(f)));
    }
    rest.unfractured_faces = unfractured;
    rest.unfractured_position = start;
    std::vector<std::uint8_t> mixed(rest.faces.size(), 0);
    for (const auto& [face, parts] : reshaped) mixed[face] = lies_in_parent(rest, face) ? 0 : 1;
    if (std::ranges::count(mixed, 1) > 0) rest.face_mixed = std::move(mixed);
    return rest;
}

}  // namespace sherd
