// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/step/simulation.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "core/membrane/membrane_energy.h"
#include "fracture/cracks/breaking.h"
#include "fracture/shell/hinge_measures.h"
#include "meshops/error.h"
#include "meshops/generate/generate.h"
#include "tests/support/contact/obstacles.h"
#include "tests/support/mesh/mesh_shapes.h"

namespace sherd {
namespace {

SheetInput disc(double radius, double edge_length) {
    SheetInput sheet;
    sheet.mesh = generate_disc(radius, {edge_length, Layout::delaunay, 3});
    sheet.material = {2400, 0.004, 7e10, 0.2};
    return sheet;
}

// Free flight of a bent, spinning shell: only gravity may change its linear momentum.
TEST(Simulation, LinearMomentumFollowsGravityWhileNothingTouches) {
    SheetInput shell;
    const std::vector<Vector2d> profile{{0, 0}, {0.05, 0.01}, {0.08, 0.05}};
    shell.mesh = generate_revolution(profile, {0.01, Layout::delaunay, 1});
    shell.material = {2400, 0.002, 1e8, 0.2};
    shell.velocity = Vector3d(1, 2, 3);
    shell.spin = Vector3d(20, -30, 50);
    SimulationOptions options;
    options.stepper.step = 1e-3;
    Simulation simulation({shell}, options);
    const double mass = simulation.shell().mechanics().mass.sum();
    const Vector3d start = linear_momentum(simulation.shell().mechanics());
    for (int i = 0; i < 200; ++i) {
        const StepReport report = simulation.step();
        ASSERT_EQ(report.halvings, 0);
        const Vector3d expected = start + mass * report.time * options.stepper.gravity;
        ASSERT_LT((report.linear_momentum - expected).norm(), 1e-9 * expected.norm())
            << "step " << report.step;
    }
}

// In a step so long that its inertia is lost beside the stiffness, the matrix cannot be factorized: a
// shorter step must follow, as when iterations do not suffice, and the run must not end.
TEST(Simulation, AStepWithoutAMatrixIsHalved) {
    SimulationOptions options;
    options.stepper.step = 1e5;
    Simulation simulation({disc(0.1, 0.05)}, options);
    const StepReport report = simulation.step();
    EXPECT_GT(report.halvings, 0);
    const Vector3d fallen = simulation.shell().mechanics().velocity.rowwise().mean();
    EXPECT_NEAR(fallen.z(), -9.81 * report.time, 1e-3 * 9.81 * report.time);
}

// Without gravity and spin a curved sheet at rest must stay at rest: a force at rest would set it moving.
TEST(Simulation, CurvedSheetAtRestStaysAtRest) {
    SheetInput tube;
    tube.mesh = generate_cylinder(0.05, 0.1, {0.012, Layout::delaunay, 1});
    tube.material = {2400, 0.001, 1e9, 0.3};
    SimulationOptions options;
    options.stepper.gravity.setZero();
    Simulation simulation({tube}, options);
    for (int i = 0; i < 20; ++i) simulation.step();
    EXPECT_LT(simulation.shell().mechanics().velocity.cwiseAbs().maxCoeff(), 1e-9);
}

// The elastic forces of a sheet crumpled at random must have no net force and no net torque.
TEST(Simulation, ElasticForcesBalanceOnAnyDeformation) {
    const BreakableShell sheet({disc(0.1, 0.02)});
    Positions x = sheet.mechanics().position;
    for (Eigen::Index i = 0; i < x.size(); ++i) x(i) += 0.01 * std::sin(static_cast<double>(i * i));
    for (const bool bending : {true, false}) {
        Positions force = Positions::Zero(3, x.cols());
        if (bending)
            bending_energy(sheet.mechanics())->add_gradient(x, force);
        else
            MembraneEnergy(sheet.mechanics().triangles).add_gradient(x, force);
        Vector3d torque = Vector3d::Zero();
        double moments = 0;
        for (Eigen::Index v = 0; v < x.cols(); ++v) {
            torque += Vector3d(x.col(v)).cross(Vector3d(force.col(v)));
            moments += x.col(v).norm() * force.col(v).norm();
        }
        EXPECT_GT(force.norm(), 0);
        EXPECT_LT(force.rowwise().sum().norm(), 1e-12 * force.colwise().norm().sum());
        EXPECT_LT(torque.norm(), 1e-12 * moments);
    }
}

Simulation falling_disc(double strain_threshold, int max_iterations = 50) {
    SheetInput plate = disc(0.1, 0.012);
    plate.strength = uniform_strength(strain_threshold);
    for (const Vertex vertex : plate.mesh.vertices()) {
        const Point p = plate.mesh.point(vertex);
        const double tilt = 0.3;
        plate.mesh.point(vertex) = Point(std::cos(tilt) * p.x(), p.y(), 0.035 + std::sin(tilt) * p.x());
    }
    plate.velocity = Vector3d(0, 0, -4);
    SimulationOptions options;
    options.stepper.contact.obstacles = {test::floor()};
    options.max_iterations = max_iterations;
    return Simulation({plate}, options);
}

double total_energy(const StepReport& report) {
    return report.kinetic + report.bending + report.membrane + report.contact + report.gravity;
}

// Fracture may neither lose mass nor gain energy, and the events must list all changes of the mesh.
TEST(BreakingSimulation, BreaksWithoutGainingEnergyAndRecordsEveryEvent) {
    Simulation simulation = falling_disc(0.3);
    const Snapshot before = simulation.snapshot();
    const double start = total_energy(simulation.step());
    CrackEvents events;
    for (int i = 0; i < 120; ++i) {
        const StepReport report = simulation.step();
        EXPECT_LT(total_energy(report), start + 1e-9) << "step " << report.step;
        append(events, simulation.take_events());
    }
    const Snapshot after = simulation.snapshot();
    EXPECT_GT(events.failures.size(), 10u);
    EXPECT_EQ(after.position.cols(),
              before.position.cols() + static_cast<Eigen::Index>(events.splits.size()));
    EXPECT_EQ(after.edges.size(), before.edges.size() + events.openings.size());
    EXPECT_NEAR(after.mass.sum(), before.mass.sum(), 1e-14 * before.mass.sum());
    std::size_t failed = 0;
    for (std::size_t e = 0; e < before.edges.size(); ++e)
        failed += after.edge_state[e] != before.edge_state[e];
    EXPECT_EQ(failed, events.failures.size());
    const HingeMeasures measures =
        hinge_measures(simulation.shell(), simulation.shell().mechanics().position);
    EXPECT_LE(measures.strain.maxCoeff(), 0.3);
}

TEST(BreakingSimulation, GivesTheSameBitsTwice) {
    Simulation first = falling_disc(0.3), second = falling_disc(0.3);
    for (int i = 0; i < 90; ++i) {
        first.step();
        second.step();
    }
    EXPECT_TRUE(first.snapshot().position == second.snapshot().position);
    EXPECT_EQ(first.snapshot().faces, second.snapshot().faces);
}

Simulation landing_disc(int max_iterations, double tolerance) {
    SheetInput plate = disc(0.1, 0.012);
    for (const Vertex vertex : plate.mesh.vertices()) {
        Point& p = plate.mesh.point(vertex);
        p = Point(p.x(), p.y(), 0.01 + 0.3 * p.x() + 0.03);
    }
    plate.velocity = Vector3d(0, 0, -20);
    SimulationOptions options;
    options.stepper.contact.obstacles = {test::floor()};
    options.stepper.step = 1e-3;
    options.max_iterations = max_iterations;
    options.tolerance = tolerance;
    return Simulation({plate}, options);
}

// A step that needs more iterations than allowed is divided into shorter ones, which must end at the same
// time.
TEST(Simulation, HalvesAStepThatCannotBeSolvedAndGoesOn) {
    Simulation simulation = landing_disc(4, 1e-6);
    Index halvings = 0;
    double time = 0, largest_after = 0;
    for (int whole = 1; whole <= 12; ++whole)
        while (simulation.time() < whole * 1e-3) {
            const StepReport report = simulation.step();
            time += report.step_size;
            EXPECT_NEAR(report.time, time, 1e-12);
            EXPECT_LE(report.time, whole * 1e-3);
            if (halvings > 0) largest_after = std::max(largest_after, report.step_size);
            halvings += report.halvings;
        }
    EXPECT_GT(halvings, 0);
    EXPECT_EQ(largest_after, 1e-3) << "the step has grown back";
}

/// Strip that is held at both ends, with the strength `strength` (1/m) across its middle and unbreakable
/// elsewhere. It is so heavy that its halves, once separated, fall by half their length within a step of 30
/// ms.
Simulation heavy_strip(double strength) {
    constexpr double length = 0.2, width = 0.04;
    SheetInput strip;
    strip.mesh = generate_rectangle(length, width, {width / 2, Layout::structured, 1});
    strip.material = {2400, 0.004, 7e10, 0.2};
    strip.strength = uniform_strength(strength);
    const auto is_at = [&](Vertex v, double x) { return std::abs(strip.mesh.point(v).x() - x) < 1e-9; };
    for (const Edge e : strip.mesh.edges()) {
        const bool across =
            is_at(strip.mesh.vertex(e, 0), length / 2) && is_at(strip.mesh.vertex(e, 1), length / 2);
        strip.strength.factors.push_back(across ? 1 : INFINITY);
    }
    for (const Vertex v : strip.mesh.vertices())
        if (is_at(v, 0) || is_at(v, length)) strip.pinned.push_back(static_cast<Index>(v));
    SimulationOptions options;
    options.stepper.step = 3e-2;
    options.stepper.gravity = Vector3d(0, 0, -100);
    options.max_iterations = 60;
    options.stepper.method = Method::newton;
    options.stepper.contact.sheets = false;
    return Simulation({strip}, options);
}

// Failures in a step that is then halved belong to the part of the step that was made, and the mesh and its
// mechanics must stay consistent. The whole strip bends little, which 19 iterations find; its halves hang
// down at the end of the step, which would take some 250 iterations.
TEST(BreakingSimulation, EventsHaveTheTimeOfTheStepThatWasDone) {
    Simulation whole = heavy_strip(INFINITY), simulation = heavy_strip(1e-6);
    const StepReport before = whole.step(), report = simulation.step();
    EXPECT_EQ(before.halvings, 0);
    EXPECT_GT(report.halvings, 0) << report.newton_iterations << " iterations, whole "
                                  << before.newton_iterations;
    EXPECT_LT(report.time, before.time);
    const CrackEvents events = simulation.take_events();
    ASSERT_EQ(events.failures.size(), 2u);
    EXPECT_NEAR(events.failures[0].strain, before.peak_strain, 1e-6 * before.peak_strain)
        << "it broke before the step was halved";
    EXPECT_EQ(events.openings.size(), 2u);
    EXPECT_EQ(events.splits.size(), 3u);
    EXPECT_EQ(events.fragment_splits.size(), 1u);
    const auto expect_time = [&](const auto& of_kind) {
        for (const auto& event : of_kind) EXPECT_EQ(event.time, report.time);
    };
    expect_time(events.failures);
    expect_time(events.openings);
    expect_time(events.splits);
    expect_time(events.fragment_splits);
    EXPECT_EQ(simulation.snapshot().position.cols(), whole.snapshot().position.cols() + 3);
    while (simulation.time() < 0.06) simulation.step();
    EXPECT_TRUE(simulation.take_events().failures.empty());
}

// No run may continue after its smallest step has failed.
TEST(Simulation, ThrowsWhenTheSmallestStepCannotBeSolved) {
    Simulation simulation = landing_disc(2, 1e-30);
    try {
        simulation.step();
        ADD_FAILURE() << "went on";
    } catch (const Error& error) {
        EXPECT_EQ(error.fault, Fault::run);
    }
    EXPECT_EQ(simulation.time(), 0);
}

}  // namespace
}  // namespace sherd
