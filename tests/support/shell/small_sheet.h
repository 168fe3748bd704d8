// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include "core/energy.h"
#include "core/shell/triangle_edge.h"
#include "tests/support/shell/random_shapes.h"

namespace sherd::test {

/// Shell made without a mesh, with an edge and a hinge wherever two triangles share a side.
inline Shell small_sheet(const Positions& rest, const std::vector<std::array<Index, 3>>& triangles,
                         const Material& material) {
    Shell shell;
    resize_vertices(shell, static_cast<Index>(rest.cols()));
    shell.rest = shell.position = rest;
    shell.thickness.setConstant(material.thickness);
    for (const std::array<Index, 3>& vertices : triangles) {
        shell.triangles.push_back(
            {vertices, membrane_triangle(columns(rest, vertices), membrane_elasticity(material))});
        for (const Index v : vertices)
            shell.mass[v] += shell.triangles.back().membrane.area * material.thickness * material.density / 3;
    }
    shell.young.setConstant(material.young);
    shell.footprint = shell.mass / (material.thickness * material.density);
    const Index count = static_cast<Index>(triangles.size());
    for (Index t = 0; t < 3 * count; ++t)
        for (Index u = 0; u < t; ++u) {
            const auto [a, b, apex] = edge_and_apex(shell, {t / 3, t % 3});
            const auto [c, d, other] = edge_and_apex(shell, {u / 3, u % 3});
            if (a != d || b != c) continue;
            shell.edge_hinge.push_back(static_cast<Index>(shell.hinges.size()));
            shell.hinge_edge.push_back(shell.edge_hinge.back());
            shell.hinges.push_back(hinge_stencil(shell, {a, b, apex, other}, hinge_stiffness(material)));
        }
    return shell;
}

/// Closed tetrahedron with outward normals.
inline Shell tetrahedron(const Material& material) {
    Positions rest(3, 4);
    rest << 0, 1, 0.1, 0.2, 0, 0.1, 1, 0.3, 0, 0, 0.1, 1;
    return small_sheet(rest, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}, material);
}

/// Two triangles, not symmetric, in the plane z = 0, normals along +z.
inline Shell two_triangles(const Material& material) {
    Positions rest(3, 4);
    rest << 0, 1, 0.3, 0.6, 0, 0, 0.8, -0.9, 0, 0, 0, 0;
    return small_sheet(rest, {{0, 1, 2}, {0, 3, 1}}, material);
}

/// All entries of a symmetric block matrix, [3 V, 3 V].
inline Eigen::MatrixXd dense(const BlockMatrix& matrix) {
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(matrix.size(), matrix.size());
    for (Index c = 0; c < matrix.size(); ++c)
        for (Index k = matrix.columns()[c]; k < matrix.columns()[c + 1]; ++k)
            result(matrix.rows()[k], c) = result(c, matrix.rows()[k]) = matrix.values()[k];
    return result;
}

/// Checks gradient and exact Hessian at x against central differences along random directions.
inline void expect_derivatives(const Energy& energy, const Positions& x, double step, double relative) {
    std::vector<std::pair<Index, Index>> pairs;
    energy.add_pattern(pairs);
    energy.add_contacts(x, false, pairs);
    const auto count = static_cast<Index>(x.cols());
    BlockMatrix hessian(count, pairs, std::vector<char>(count, 0));
    energy.add_hessian(x, Curvature::exact, hessian);
    const auto gradient = [&](const Positions& at) {
        Positions sum = Positions::Zero(3, count);
        energy.add_gradient(at, sum);
        return sum;
    };
    const Eigen::MatrixXd stiffness = dense(hessian);
    Random random(1);
    for (int i = 0; i < 10; ++i) {
        Positions d(3, count);
        for (double& entry : d.reshaped()) entry = random.uniform(-1, 1);
        const double slope = gradient(x).cwiseProduct(d).sum();
        EXPECT_NEAR(slope, (energy.value(x + step * d) - energy.value(x - step * d)) / (2 * step),
                    relative * gradient(x).norm() * d.norm());
        const VectorXd change = ((gradient(x + step * d) - gradient(x - step * d)) / (2 * step)).reshaped();
        EXPECT_LT((stiffness * d.reshaped() - change).norm(), relative * stiffness.norm() * d.norm());
    }
}

}  // namespace sherd::test
