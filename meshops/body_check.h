// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshops/write_mesh.h"

namespace sherd {

/// Whether triangles are a body that solvers, boolean operations and printers take.
struct BodyCheck {
    bool manifold = false;  ///< each edge has two triangles at most, in opposite senses, each point one fan
    bool closed = false;    ///< and each edge has two
    bool outward = false;   ///< and each component that no other one holds has its outside outside
    double volume = 0;      ///< m^3, of a closed body
    std::vector<std::array<std::size_t, 2>> intersections;  ///< pairs of triangles, touching ones, too
};

BodyCheck check_body(const TriangleSheet& body);

}  // namespace sherd
