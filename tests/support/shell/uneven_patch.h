// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "core/bending/mirror_hinge.h"
#include "tests/support/shell/small_sheet.h"

namespace sherd::test {

inline constexpr int patch_across = 5, patch_along = 7;  // numbers of vertices along y and x
inline const Material patch_material{1000, 0.05, 12 / (0.05 * 0.05 * 0.05), 0.3};

/// Rectangle of 1.2 m by 0.8 m with unequal triangles; a vertex at (x, y) of it is put at place(x, y).
template <class Place>
Shell uneven_patch(Place place) {
    Positions rest(3, patch_along * patch_across);
    std::vector<std::array<Index, 3>> triangles;
    Random random(4);
    for (int i = 0; i < patch_along; ++i)
        for (int j = 0; j < patch_across; ++j) {
            const bool inner = i > 0 && j > 0 && i + 1 < patch_along && j + 1 < patch_across;
            const double jitter = inner ? 0.05 : 0;
            const double x = 0.2 * i + random.uniform(-jitter, jitter),
                         y = 0.2 * j + random.uniform(-jitter, jitter);
            rest.col(patch_across * i + j) = place(x, y);
            if (i == 0 || j == 0) continue;
            const Index a = patch_across * (i - 1) + j - 1, b = a + patch_across, c = b + 1, d = a + 1;
            if ((i + j) % 3 == 0)
                triangles.insert(triangles.end(), {{a, b, c}, {a, c, d}});
            else
                triangles.insert(triangles.end(), {{b, c, d}, {a, b, d}});
        }
    return small_sheet(rest, triangles, patch_material);
}

inline Shell flat_patch() {
    return uneven_patch([](double x, double y) { return Vector3d(x, y, 0); });
}

/// Saddle-like shell, with rest angles up to half a radian.
inline Shell curved_patch() {
    return uneven_patch(
        [](double x, double y) { return Vector3d(x, y, 0.2 * std::sin(4 * x) + 0.3 * y * y - 0.2 * x * y); });
}

inline Positions shaken(const Shell& shell, double amplitude, unsigned seed) {
    Random random(seed);
    Positions x = shell.rest;
    for (double& coordinate : x.reshaped()) coordinate += random.uniform(-amplitude, amplitude);
    return x;
}

/// Clamps the side x = 0, and puts a symmetry plane at y = 0.
inline std::vector<MirrorHinge> patch_mirrors(Shell& shell) {
    std::vector<char> wall(shell.rest.cols()), plane(shell.rest.cols());
    for (Index v = 0; v < static_cast<Index>(wall.size()); ++v) {
        wall[v] = v < patch_across;
        plane[v] = v % patch_across == 0;
    }
    std::vector<MirrorHinge> hinges;
    for (const TriangleEdge& side : boundary_triangle_edges(shell, wall))
        hinges.push_back(clamp_hinge(shell, side, 1));
    for (const TriangleEdge& side : boundary_triangle_edges(shell, plane))
        hinges.push_back(symmetry_hinge(shell, side, Vector3d::UnitY(), 1));
    EXPECT_EQ(hinges.size(), static_cast<std::size_t>(patch_along + patch_across - 2));
    return hinges;
}

inline Positions gradient_of(const Energy& energy, const Positions& x) {
    Positions sum = Positions::Zero(3, x.cols());
    energy.add_gradient(x, sum);
    return sum;
}

inline Eigen::MatrixXd hessian_of(const Energy& energy, const Positions& x, Curvature curvature) {
    std::vector<std::pair<Index, Index>> pairs;
    energy.add_pattern(pairs);
    BlockMatrix matrix(static_cast<Index>(x.cols()), pairs, std::vector<char>(x.cols(), 0));
    energy.add_hessian(x, curvature, matrix);
    return dense(matrix);
}

}  // namespace sherd::test
