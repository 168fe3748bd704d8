// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshops/mesh.h"

namespace sherd {

struct RemeshOptions {
    double edge_length = 0;  ///< m, target length where nothing requires shorter edges
    double features = 30;  ///< degrees: edges with a larger dihedral angle are kept, as are corners of lines
                           ///< that turn by more
    bool adaptive = true;  ///< whether edges are shorter where the surface is curved or thin on that scale
};

/// Result of remesh().
struct Remeshed {
    Mesh mesh;
    std::size_t kept = 0;  ///< number of faces of the input that stay, where others would cross or be tiny
    std::size_t crossings = 0;  ///< number of pairs of faces that still cross, beyond those of the input
    double distance = 0;        ///< m, Hausdorff distance from the input, at vertices and middles of faces
    bool texture_lost = false;  ///< whether texture coordinates were dropped: most edges are seams
};

/// Remeshes to nearly equilateral triangles. New vertices are on the input surface. Borders, edges where
/// groups, materials or texture coordinates change, and sharp edges keep their shape. If triangles cross
/// where those of the input do not, as in thin or sharp parts, or if they are far smaller than requested,
/// edges are made shorter there, or the faces of the input stay. Texture coordinates, groups, materials,
/// colours and axes are carried over. Throws Error if the edge length is not positive.
Remeshed remesh(const Mesh& mesh, const RemeshOptions& options);

}  // namespace sherd
