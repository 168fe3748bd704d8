// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/shell/surface_stress.h"

#include <Eigen/Geometry>

#include "core/shell/face_fields.h"

namespace sherd {

SurfaceStress& SurfaceStress::operator+=(const SurfaceStress& other) {
    top += other.top;
    bottom += other.bottom;
    return *this;
}

SurfaceStress surface_stress(const Shell& shell, Index face, const FaceStrains& strains) {
    const FaceState state = face_state(shell, face, strains.membrane.col(face), strains.curvature.col(face));
    const Eigen::Matrix<double, 3, 2> axes = frame_axes(columns(shell.rest, shell.triangles[face].vertices));
    const auto tensor = [&](const Vector3d& stress) -> Matrix3d {
        Eigen::Matrix2d in_plane;
        in_plane << stress[0], stress[2], stress[2], stress[1];
        return axes * in_plane * axes.transpose();
    };
    return {tensor(state.stress_top), tensor(state.stress_bottom)};
}

Vector3d rest_area_normal(const Shell& shell, Index face) {
    const TrianglePositions x = columns(shell.rest, shell.triangles[face].vertices);
    return Vector3d(x.col(1) - x.col(0)).cross(Vector3d(x.col(2) - x.col(0)));
}

std::vector<Index> faces_around(const Mesh& mesh, Vertex vertex) {
    std::vector<Index> faces;
    for (const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(vertex)))
        if (!mesh.is_border(h)) faces.push_back(static_cast<Index>(mesh.face(h)));
    return faces;
}

Vector3d rest_normal_at(const BreakableShell& shell, Vertex vertex) {
    Vector3d sum = Vector3d::Zero();
    for (const Index face : faces_around(shell.mesh(), vertex))
        sum += rest_area_normal(shell.mechanics(), face);
    return sum.normalized();
}

}  // namespace sherd
