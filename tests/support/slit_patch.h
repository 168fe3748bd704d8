// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tips/crack_tip.h"
#include "tests/support/uneven_patch.h"

namespace sherd::test {

/// Patch of uneven_patch() that is slit along its middle from the side x = 0, and the tip of the slit.
struct SlitPatch {
    Shell shell;
    std::vector<char> foreign;  ///< [V] flags of the outer boundary
    CrackTip tip;
};

/// edges: length of the slit. turn: rotation of the whole patch at rest.
inline SlitPatch slit_patch(const Shell& whole, int edges, const Material& material = patch_material,
                            const Matrix3d& turn = Matrix3d::Identity()) {
    constexpr int middle = patch_across / 2;
    const auto row_of = [](Index vertex) { return vertex % patch_across; };
    Positions rest(3, whole.rest.cols() + edges);
    rest.leftCols(whole.rest.cols()) = whole.rest;
    std::vector<std::array<Index, 3>> triangles;
    for (const TriangleStencil& triangle : whole.triangles) {
        triangles.push_back(triangle.vertices);
        if (std::ranges::none_of(triangle.vertices, [&](Index v) { return row_of(v) > middle; })) continue;
        for (Index& vertex : triangles.back())
            if (row_of(vertex) == middle && vertex < edges * patch_across) {
                const Index column = vertex / patch_across;
                vertex = static_cast<Index>(whole.rest.cols()) + column;
                rest.col(vertex) = whole.rest.col(column * patch_across + middle);
            }
    }
    SlitPatch patch{small_sheet(turn * rest, triangles, material), {}, {}};
    for (Index v = 0; v < rest.cols(); ++v) {
        const bool inner = v >= patch_across && v < (patch_along - 1) * patch_across && row_of(v) > 0 &&
                           row_of(v) + 1 < patch_across;
        const bool crack_face = v > whole.rest.cols();
        patch.foreign.push_back(!inner && !crack_face);
    }
    patch.tip =
        crack_tip(patch.shell, VertexFaces(patch.shell), edges * patch_across + middle, patch.foreign);
    return patch;
}

/// Positions with large bending, stretch and rotation.
inline Positions bent_and_turned(const Shell& shell, unsigned seed) {
    Positions x = shell.rest;
    for (Index v = 0; v < x.cols(); ++v) {
        const Vector3d at = shell.rest.col(v);
        x.col(v) += Vector3d(0.05 * at.x() * at.y(), 0.04 * at.x() - 0.03 * at.y() * at.y(),
                             0.3 * at.x() * at.x() - 0.2 * at.x() * at.y());
    }
    Random random(seed);
    for (double& coordinate : x.reshaped()) coordinate += random.uniform(-0.01, 0.01);
    return (random.rotation() * x).colwise() + random.matrix<Vector3d>(1);
}

}  // namespace sherd::test
