// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshops/mesh.h"

namespace sherd {

struct RemeshOptions {
    double edge_length = 0;  ///< m, of edges where nothing asks for shorter ones
    double features = 30;    ///< degrees: edges that bend by more, and corners of lines, keep their shape
    bool adaptive = true;    ///< shorter edges where the surface is curved, or thin, on that scale
};

/// What remesh() has made.
struct Remeshed {
    Mesh mesh;
    std::size_t kept = 0;       ///< faces of the input that stay, since others would cross there
    std::size_t crossings = 0;  ///< pairs of faces that cross all the same, beyond those of the input
    double distance = 0;  ///< m, Hausdorff distance from the input, of vertices and middles of faces of both
    bool texture_lost = false;  ///< texture coordinates of a mesh whose edges are mostly seams
};

/// Remeshes to triangles of about equal sides. New vertices are on the input surface; borders, edges where
/// groups or texture coordinates change, and sharp edges keep their shape. Where triangles cross and those of
/// the input do not, as in what is thin or sharp, and where they are far smaller than asked for, edges are
/// made shorter, or the input's faces stay. Texture coordinates, groups and axes are carried over. Throws
/// Error if a length is not positive.
Remeshed remesh(const Mesh& mesh, const RemeshOptions& options);

}  // namespace sherd
