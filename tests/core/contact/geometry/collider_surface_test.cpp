// SPDX-License-Identifier: GPL-3.0-or-later
// Too wide an edge or too large a footprint makes contact too stiff; a missing edge lets a sheet's edge
// through.
#include "core/contact/geometry/collider_surface.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/support/contact/obstacles.h"

namespace sherd::test {
namespace {

TEST(ColliderSurface, ABoxHasTwelveEdgesAndEightCorners) {
    const auto box = box_surface(Vector3d(1, 2, 3), Vector3d(0.5, 1, 2));
    EXPECT_EQ(box->triangles.size(), 12u);
    EXPECT_EQ(box->edges.size(), 12u) << "not the diagonals of its sides";
    const double area = 2 * (1.0 * 2 + 2.0 * 4 + 4.0 * 1);
    EXPECT_NEAR(box->footprint.sum(), area, 1e-12);
    double of_edges = 0;
    for (std::size_t e = 0; e < box->edges.size(); ++e) {
        const auto [a, b] = box->edges[e];
        EXPECT_LT(a, b);
        of_edges += box->width[e] * (box->points.col(a) - box->points.col(b)).norm();
    }
    EXPECT_NEAR(of_edges, area * 2 / 3, 1e-12) << "a third is nearest to the diagonals";
}

TEST(ColliderSurface, ARoundOneKeepsAllEdges) {
    const auto sphere = sphere_surface(1, 3);
    EXPECT_EQ(sphere->edges.size(), 3 * sphere->triangles.size() / 2);
    EXPECT_NEAR(sphere->footprint.sum(), 4 * 3.14159265, 0.05 * 4 * 3.14159265);
}

TEST(ColliderSurface, ATriangleOfPointsThatAreNotThereIsRefused) {
    EXPECT_THROW(collider_surface(Positions::Zero(3, 3), {{0, 1, 3}}), std::out_of_range);
}

}  // namespace
}  // namespace sherd::test
