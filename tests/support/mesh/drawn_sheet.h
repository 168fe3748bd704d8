// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshops/generate/generate.h"
#include "meshops/topology/retriangulation.h"
#include "tests/support/mesh/mesh_shapes.h"
#include "tests/support/shell/random_shapes.h"

namespace sherd::test {

inline constexpr unsigned sheet_shapes = 5;

/// Whether drawn_sheet(shape, seed) lies in a plane.
inline bool is_flat_sheet(unsigned shape) {
    return shape == 0 || shape > 2;
}

/// Small sheet. shape: 0 a flat rectangle, 1 a tube, 2 a sphere, 3 a flat grid of squares, 4 a flat rectangle
/// with slivers and vertices of any degree.
inline Mesh drawn_sheet(unsigned shape, unsigned seed) {
    switch (shape) {
        case 0:
            return generate_rectangle(1, 0.7, {.edge_length = 0.12, .seed = seed});
        case 1:
            return generate_cylinder(0.5, 0.9, {.edge_length = 0.17, .seed = seed});
        case 2:
            return generate_sphere(0.5, {.edge_length = 0.17, .seed = seed});
        case 3:
            return grid(7, 6);
        default:
            break;
    }
    Mesh mesh = generate_rectangle(1, 0.7, {.edge_length = 0.2, .seed = seed});
    Random random(seed);
    Retriangulation edits(mesh);
    for (int i = 0; i < 30; ++i)
        edits.split_edge(mesh.halfedge(Face(random.below(mesh.number_of_faces()))), random.uniform(0.3, 0.7));
    edits.finish();
    return mesh;
}

}  // namespace sherd::test
