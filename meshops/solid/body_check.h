// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshops/read_write/write_mesh.h"

namespace sherd {

/// Whether triangles form a body that solvers, boolean operations and printers accept.
struct BodyCheck {
    bool manifold = false;  ///< two triangles an edge at most, oppositely oriented, and one fan a point
    bool closed = false;    ///< the body is manifold and each edge has two triangles
    bool outward = false;   ///< the body is closed and the normals of each outermost component point outwards
    double volume = 0;      ///< m^3, of a closed body
    std::vector<std::array<std::size_t, 2>> intersections;  ///< pairs of triangles that intersect or touch
};

BodyCheck check_body(const TriangleSheet& body);

}  // namespace sherd
