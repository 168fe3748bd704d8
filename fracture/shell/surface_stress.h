// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fracture/shell/breakable_shell.h"

namespace sherd {

/// Membrane strains and curvatures (1/m) of all faces, [3, F] each: see ShellEnergies.
struct FaceStrains {
    Eigen::Matrix3Xd membrane, curvature;
};

/// Stress at the two surfaces of a sheet, Pa, as tensors in the space of the rest shape.
struct SurfaceStress {
    Matrix3d top = Matrix3d::Zero(), bottom = Matrix3d::Zero();

    SurfaceStress& operator+=(const SurfaceStress& other);
    SurfaceStress operator*(double factor) const { return {factor * top, factor * bottom}; }
};

/// Surface stress of one face: see face_state().
SurfaceStress surface_stress(const Shell& shell, Index face, const FaceStrains& strains);

/// Normal of a face at rest, m^2: its length is twice the area.
Vector3d rest_area_normal(const Shell& shell, Index face);
/// Unit normal at a vertex at rest: the mean of its faces' normals, weighted by area.
Vector3d rest_normal_at(const BreakableShell& shell, Vertex vertex);
/// The faces around a vertex.
std::vector<Index> faces_around(const Mesh& mesh, Vertex vertex);

}  // namespace sherd
