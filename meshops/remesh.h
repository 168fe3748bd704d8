// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshops/mesh.h"

namespace sherd {

/// What remesh() has made.
struct Remeshed {
    Mesh mesh;
    std::size_t kept = 0;       ///< faces of the input that stay, since others would cross there
    std::size_t crossings = 0;  ///< pairs of faces that cross all the same where none of the input do
    double distance = 0;  ///< m, Hausdorff distance from the input, of vertices and middles of faces of both
};

/// Remeshes isotropically to `edge_length` (m): new vertices stay on the input surface, boundaries and edges
/// sharper than `feature_degrees` keep their shape. Where triangles of this size cross and those of the input
/// do not, as in what is thin or sharp, the input's stay, and what is around them is remeshed again. Texture
/// coordinates are lost. Throws Error if edge_length is not positive.
Remeshed remesh(const Mesh& mesh, double edge_length, double feature_degrees = 40);

}  // namespace sherd
