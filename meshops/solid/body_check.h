// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshops/read_write/write_mesh.h"

namespace sherd {

/// Whether triangles form a body that solvers, boolean operations and printers accept.
struct BodyCheck {
    bool manifold = false;  ///< an edge has at most two triangles, which run along it in opposite directions;
                            ///< the triangles at a point form one fan
    bool closed = false;    ///< the body is manifold and each edge has two triangles
    bool outward = false;   ///< the body is closed and its normals point outwards, in cavities into the
                            ///< cavity; if the body intersects itself, only volume > 0 is checked
    double volume = 0;      ///< m^3, of a closed body; 0 for others
    std::vector<std::array<std::size_t, 2>> intersections;  ///< pairs of triangles that intersect or touch
};

BodyCheck check_body(const TriangleSheet& body);

}  // namespace sherd
