// SPDX-License-Identifier: GPL-3.0-or-later
// With wrong moments a free body from a mesh would fall and turn like another body.
#include "meshops/solid/solid_moments.h"

#include <gtest/gtest.h>

#include <numbers>

#include "meshops/generate/generate.h"
#include "meshops/mesh_measures.h"
#include "tests/support/mesh/mesh_shapes.h"

namespace sherd::test {
namespace {

using Eigen::Matrix3d, Eigen::Vector3d;

// Tetrahedron of the unit vectors, far from the origin, where a sum about the origin would lose digits.
TEST(SolidMoments, OfATetrahedronAreExact) {
    const Vector3d at(1000, -2000, 500);
    Mesh mesh;
    std::vector<Vertex> v;
    for (const Vector3d& p : {Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(0, 1, 0), Vector3d(0, 0, 1)})
        v.push_back(mesh.add_vertex(point_at(at + p)));
    mesh.add_face(v[0], v[2], v[1]);
    mesh.add_face(v[0], v[1], v[3]);
    mesh.add_face(v[0], v[3], v[2]);
    mesh.add_face(v[1], v[2], v[3]);
    const SolidMoments solid = solid_moments(mesh);
    EXPECT_NEAR(solid.volume, 1.0 / 6, 1e-12);
    EXPECT_LT((solid.centre - at - Vector3d::Constant(0.25)).norm(), 1e-12);
    // About the corner `at`, the integrals over the tetrahedron are 1/60 for x^2, 1/120 for x y and 1/24 for
    // x. About the centre those of x^2 and x y are less by (1/24)^2 over the volume, 1/96.
    const Matrix3d second = Matrix3d::Constant(1.0 / 120 - 1.0 / 96) + Matrix3d::Identity() / 120;
    EXPECT_LT((solid.second - second).norm(), 1e-12);
}

// Theory, with the mass m and half axes b and c perpendicular to the axis of rotation: m (b^2 + c^2) / 5.
// The facets lie inside the ellipsoid, so that volume and inertia are a little less.
TEST(SolidMoments, OfAnEllipsoidAreThoseOfTheory) {
    const Vector3d half(1, 2, 3);
    Mesh mesh = generate_sphere(1, {.edge_length = 0.1});
    for (const Vertex v : mesh.vertices()) mesh.point(v) = point_at(half.cwiseProduct(position(mesh, v)));
    const SolidMoments solid = solid_moments(mesh);
    const double volume = 4.0 / 3 * std::numbers::pi * half.prod();
    EXPECT_NEAR(solid.volume, volume, 0.01 * volume);
    EXPECT_LT(solid.centre.norm(), 1e-2);
    const Vector3d squares = half.cwiseAbs2();
    const Vector3d inertia = volume / 5 * (Vector3d::Constant(squares.sum()) - squares);
    EXPECT_LT((solid.inertia() - Matrix3d(inertia.asDiagonal())).norm(), 0.02 * inertia.norm());
}

// Inverted faces enclose a negative volume, by which a mesh that was not repaired is detected.
TEST(SolidMoments, OfWhatIsInsideOutAreNegative) {
    const Mesh outward = octahedron();
    Mesh mesh;
    for (const Vertex v : outward.vertices()) mesh.add_vertex(outward.point(v));
    for (const auto& [a, b, c] : triangles_of(outward)) mesh.add_face(Vertex(a), Vertex(c), Vertex(b));
    EXPECT_NEAR(solid_moments(outward).volume, 4.0 / 3, 1e-12);
    EXPECT_NEAR(solid_moments(mesh).volume, -4.0 / 3, 1e-12);
}

}  // namespace
}  // namespace sherd::test
