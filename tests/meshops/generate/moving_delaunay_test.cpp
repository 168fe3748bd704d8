// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/generate/moving_delaunay.h"

#include <gtest/gtest.h>

#include "tests/support/shell/random_shapes.h"

namespace sherd {
namespace {

using Eigen::Vector2d;

class Plane final : public Surface {
  public:
    Eigen::Vector3d position(const Vector2d& p) const override { return {p.x(), p.y(), 0}; }
    Vector2d chart(const Vector2d& p) const override { return p; }
    Vector2d project(const Eigen::Vector3d& point, const Vector2d&) const override { return point.head<2>(); }
};

/// Points on a regular grid in a square of side 1, with `side` edges along each of its sides; points on the
/// rim come first.
SurfacePoints square(int side) {
    SurfacePoints points;
    const auto at = [side](int i, int j) { return Vector2d(double(i) / side, double(j) / side); };
    for (int i = 0; i < side; ++i)
        for (const Vector2d& p : {at(i, 0), at(side, i), at(side - i, side), at(0, side - i)})
            points.parameter.push_back(p);
    points.fixed = points.parameter.size();
    for (int i = 1; i < side; ++i)
        for (int j = 1; j < side; ++j) points.parameter.push_back(at(i, j));
    return points;
}

void expect_like_new(MovingDelaunay& moved, const SurfacePoints& points) {
    moved.follow();
    EXPECT_EQ(moved.triangles(), MovingDelaunay(Plane(), points).triangles());
}

// If the moved triangulation were not that from scratch, a generated mesh would depend on how its points
// moved. Points move by distances from a hundredth of an edge up to distances that invert triangles.
TEST(MovingDelaunay, IsTheTriangulationFromScratch) {
    const Plane plane;
    test::Random random(1);
    for (const bool creased : {false, true}) {
        const SurfacePoints start = square(20);
        SurfacePoints points = start;
        if (creased) points.creases = {{0, 4}, {4, 8}};
        MovingDelaunay moved(plane, points);
        for (const double way : {0.01, 0.1, 0.2, 0.4, 0.8, 0.1}) {
            for (std::size_t i = points.fixed; i < points.parameter.size(); ++i)
                points.parameter[i] =
                    (start.parameter[i] + Vector2d(random.uniform(-way, way), random.uniform(-way, way)) / 20)
                        .cwiseMax(0.001)
                        .cwiseMin(0.999);
            expect_like_new(moved, points);
        }
    }
}

// The four corners of a square lie on a circle, so that both diagonals are Delaunay: the moved triangulation
// must choose the same ones as a triangulation from scratch.
TEST(MovingDelaunay, TakesTheSameDiagonalsOfSquares) {
    const Plane plane;
    test::Random random(2);
    const SurfacePoints start = square(12);
    SurfacePoints points = start;
    MovingDelaunay moved(plane, points);
    for (std::size_t i = points.fixed; i < points.parameter.size(); ++i)
        points.parameter[i] += Vector2d(random.uniform(-0.01, 0.01), random.uniform(-0.01, 0.01));
    expect_like_new(moved, points);
    points.parameter = start.parameter;
    expect_like_new(moved, points);
}

}  // namespace
}  // namespace sherd
