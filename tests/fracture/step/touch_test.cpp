// SPDX-License-Identifier: GPL-3.0-or-later
// A run lists the obstacles that nothing touched: an obstacle touched in any way must not be among them.
#include <gtest/gtest.h>

#include "fracture/step/simulation.h"
#include "meshops/generate/generate.h"
#include "tests/support/contact/obstacles.h"

namespace sherd::test {
namespace {

/// Disc of rubber, 10 cm across, 3 mm thick, that comes down at 2 m/s from z = 2 mm.
SheetInput falling_disc() {
    SheetInput sheet;
    sheet.mesh = generate_disc(0.05, {0.02, Layout::delaunay, 3});
    for (const Vertex v : sheet.mesh.vertices()) {
        const Point at = sheet.mesh.point(v);
        sheet.mesh.point(v) = Point(at.x(), at.y(), 0.002);
    }
    sheet.material = {1000, 0.003, 1e7, 0.3};
    sheet.velocity = Vector3d(0, 0, -2);
    return sheet;
}

RigidBody ball(const Vector3d& centre) {
    RigidBody ball = rigid_sphere(0.01, 2000);
    ball.centre = centre;
    ball.surface = sphere_surface(0.01, 2);
    return ball;
}

using Flags = std::vector<char>;

TEST(Touch, ByVerticesAndByFacesIsOfTheObstacleThatItIsOf) {
    SimulationOptions options;
    const double thin = 5e-4;  // narrower than a face: no vertex comes near
    options.stepper.contact.obstacles = {
        floor(), solid_box(Vector3d(0.5, 0, 0), Vector3d(0.1, 0.1, 0.1)),
        solid_box(Vector3d(0.004, 0.003, -0.011), Vector3d(thin, thin, 0.01))};
    options.stepper.contact.obstacles[0].motion.place.translation().z() = -0.5;
    Simulation simulation({falling_disc()}, options);
    EXPECT_EQ(simulation.touched_obstacles(), (Flags{0, 0, 0}));
    for (int i = 0; i < 40; ++i) simulation.step();
    EXPECT_EQ(simulation.touched_obstacles(), (Flags{0, 0, 1}));
    for (double z : simulation.shell().mechanics().position.row(2)) ASSERT_GT(z, -0.4);
}

TEST(Touch, OnceIsEnough) {
    SimulationOptions options;
    options.stepper.contact.obstacles = {floor()};
    Simulation simulation({falling_disc()}, options);
    bool touched_and_left = false;
    for (int i = 0; i < 100; ++i) {
        const StepReport report = simulation.step();
        touched_and_left = touched_and_left || (simulation.touched_obstacles()[0] && report.contacts == 0);
    }
    EXPECT_TRUE(touched_and_left) << "it bounces";
    EXPECT_EQ(simulation.touched_obstacles(), Flags{1});
}

TEST(Touch, OfBodiesWithSheetsObstaclesAndEachOther) {
    SimulationOptions options;
    options.stepper.contact.obstacles = {floor(), floor()};
    options.stepper.contact.obstacles[0].motion.place.translation().z() = -0.3;
    options.stepper.contact.obstacles[1].motion.place.translation().z() = -5;
    options.stepper.contact.bodies = {ball({0.003, 0.002, -0.0115}), ball({0.2, 0, -0.29}), ball({0.4, 0, 0}),
                                      ball({0.4, 0.0201, 0}), ball({0.6, 0, 0})};
    options.stepper.contact.bodies[2].velocity = Vector3d(0, 1, 0);
    Simulation simulation({falling_disc()}, options);
    for (int i = 0; i < 20; ++i) simulation.step();
    EXPECT_EQ(simulation.touched_bodies(), (Flags{1, 1, 1, 1, 0}));
    EXPECT_EQ(simulation.touched_obstacles(), (Flags{1, 0})) << "a ball rests on the first";
}

}  // namespace
}  // namespace sherd::test
