// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/shell/rest_mesh.h"

#include <Eigen/Geometry>
#include <numeric>
#include <utility>

namespace sherd {
namespace {

/// Barycentric coordinates of a point in the plane of a triangle.
Vector3d in_plane_of(const Matrix3d& corners, const Vector3d& point) {
    const Vector3d a = corners.col(1) - corners.col(0), b = corners.col(2) - corners.col(0);
    const Vector3d normal = a.cross(b), way = point - corners.col(0);
    const double size = normal.squaredNorm();
    const double second = way.cross(b).dot(normal) / size, third = a.cross(way).dot(normal) / size;
    return {1 - second - third, second, third};
}

}  // namespace

RestMesh unfractured_mesh(Positions position, std::vector<std::array<Index, 3>> faces,
                          std::vector<double> area, std::vector<double> thickness) {
    RestMesh rest{.position = std::move(position),
                  .faces = std::move(faces),
                  .area = std::move(area),
                  .thickness = std::move(thickness),
                  .vertex_parents = {},
                  .vertex_weights = {},
                  .face_parent = {},
                  .unfractured_faces = {}};
    rest.unfractured_position = rest.position;
    for (Index v = 0; v < static_cast<Index>(rest.position.cols()); ++v)
        rest.vertex_parents.push_back({v, v, v});
    rest.vertex_weights.assign(rest.vertex_parents.size(), {1, 0, 0});
    rest.face_parent.resize(rest.faces.size());
    std::iota(rest.face_parent.begin(), rest.face_parent.end(), Index{0});
    rest.unfractured_faces = rest.faces;
    return rest;
}

Vector3d place_in_parent(const RestMesh& rest, std::size_t face, int corner) {
    const Index vertex = rest.faces[face][corner];
    const std::array<Index, 3>& parent = rest.unfractured_faces[rest.face_parent[face]];
    if (!rest.face_mixed.empty() && rest.face_mixed[face] != 0)
        return in_plane_of(columns(rest.unfractured_position, parent), rest.position.col(vertex));
    Vector3d place = Vector3d::Zero();
    for (int k = 0; k < 3; ++k)
        for (int i = 0; i < 3; ++i)
            if (rest.vertex_parents[vertex][i] == parent[k]) place[k] += rest.vertex_weights[vertex][i];
    return place;
}

}  // namespace sherd
