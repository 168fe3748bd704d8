// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/simulation.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "fracture/breaking.h"
#include "fracture/opening_strain.h"
#include "meshops/generate.h"
#include "tests/support/mesh_shapes.h"

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
    options.step = 1e-3;
    Simulation simulation({shell}, options);
    const double mass = simulation.sheet().mechanics().mass.sum();
    const Vector3d start = linear_momentum(simulation.sheet().mechanics());
    for (int i = 0; i < 200; ++i) {
        const StepReport report = simulation.step();
        ASSERT_TRUE(report.converged);
        const Vector3d expected = start + mass * report.time * options.gravity;
        ASSERT_LT((report.linear_momentum - expected).norm(), 1e-9 * expected.norm())
            << "step " << report.step;
    }
}

// Without gravity and spin a sheet at rest must stay there: a force at rest would set it moving.
TEST(Simulation, CurvedSheetAtRestStaysAtRest) {
    SheetInput tube;
    tube.mesh = generate_cylinder(0.05, 0.1, {0.012, Layout::delaunay, 1});
    tube.material = {2400, 0.001, 1e9, 0.3};
    SimulationOptions options;
    options.gravity.setZero();
    Simulation simulation({tube}, options);
    for (int i = 0; i < 20; ++i) simulation.step();
    EXPECT_LT(simulation.sheet().mechanics().velocity.cwiseAbs().maxCoeff(), 1e-9);
}

// The elastic forces of a sheet crumpled at random must have no net force and no net torque.
TEST(Simulation, ElasticForcesBalanceOnAnyDeformation) {
    const BreakableSheet sheet({disc(0.1, 0.02)});
    Positions x = sheet.mechanics().position;
    for (Eigen::Index i = 0; i < x.size(); ++i) x(i) += 0.01 * std::sin(static_cast<double>(i * i));
    for (const bool bending : {true, false}) {
        Positions force = Positions::Zero(3, x.cols());
        if (bending)
            BendingEnergy(sheet.mechanics().hinges).add_gradient(x, force);
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

Simulation falling_disc(double strain_threshold) {
    SheetInput plate = disc(0.1, 0.012);
    plate.strain_threshold = strain_threshold;
    for (const Vertex vertex : plate.mesh.vertices()) {
        const Point p = plate.mesh.point(vertex);
        const double tilt = 0.3;
        plate.mesh.point(vertex) = Point(std::cos(tilt) * p.x(), p.y(), 0.035 + std::sin(tilt) * p.x());
    }
    plate.velocity = Vector3d(0, 0, -4);
    SimulationOptions options;
    options.planes = {Plane{}};
    return Simulation({plate}, options);
}

double total_energy(const StepReport& report) {
    return report.kinetic + report.bending + report.membrane + report.contact + report.gravity;
}

// Breaking may neither lose mass nor gain energy, and the events must tell all that happened to the mesh.
TEST(Simulation, BreaksWithoutGainingEnergyAndRecordsEveryEvent) {
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
    const VectorXd strains = opening_strains(simulation.sheet(), simulation.sheet().mechanics().position);
    EXPECT_LE(strains.maxCoeff(), 0.3);
}

TEST(Simulation, GivesTheSameBitsTwice) {
    Simulation first = falling_disc(0.3), second = falling_disc(0.3);
    for (int i = 0; i < 90; ++i) {
        first.step();
        second.step();
    }
    EXPECT_TRUE(first.snapshot().position == second.snapshot().position);
    EXPECT_EQ(first.snapshot().faces, second.snapshot().faces);
}

// A stage breaks the worst hinges only; its neighbours are judged again after the sheet has relaxed.
TEST(Breaking, PicksTheMostOverloadedWithinTwoRings) {
    SheetInput flat;
    flat.mesh = test::grid(12, 4);
    flat.material = {1000, 0.01, 1e7, 0.3};
    flat.strain_threshold = 0.1;
    const BreakableSheet sheet({flat});
    VectorXd strains = VectorXd::Zero(static_cast<Eigen::Index>(sheet.mechanics().hinges.size()));
    const auto hinge_at = [&](unsigned a, unsigned b) {
        return sheet.hinge_of_edge(sheet.mesh().edge(sheet.mesh().halfedge(Vertex(a), Vertex(b))));
    };
    strains[hinge_at(15, 28)] = 0.3;   // worst of the left half
    strains[hinge_at(16, 29)] = 0.2;   // one ring away
    strains[hinge_at(22, 35)] = 0.15;  // far away
    strains[hinge_at(36, 49)] = 0.05;  // not overloaded
    std::vector<Edge> expected{sheet.edge_of_hinge(hinge_at(15, 28)), sheet.edge_of_hinge(hinge_at(22, 35))};
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(failing_edges(sheet, strains, 1), expected);
    // Negative strain presses the edge together.
    strains[hinge_at(22, 35)] = -0.3;
    expected = {sheet.edge_of_hinge(hinge_at(15, 28))};
    EXPECT_EQ(failing_edges(sheet, strains, 1), expected);
    strains.setConstant(0.2);  // a tie everywhere breaks somewhere, and not everywhere
    const std::size_t count = failing_edges(sheet, strains, 1).size();
    EXPECT_GT(count, 0u);
    EXPECT_LT(count, sheet.mechanics().hinges.size() / 20);
}

// A hinge at the tip of a crack fails before an equally strained one elsewhere.
TEST(Breaking, ContinuesACrackBelowTheStrength) {
    SheetInput flat;
    flat.mesh = test::grid(12, 4);
    flat.material = {1000, 0.01, 1e7, 0.3};
    flat.strain_threshold = 0.1;
    BreakableSheet sheet({flat});
    const auto edge_at = [&](unsigned a, unsigned b) {
        return sheet.mesh().edge(sheet.mesh().halfedge(Vertex(a), Vertex(b)));
    };
    sheet.fail(std::array{edge_at(3, 16)});  // from the boundary inwards: open, with its tip at 16
    EXPECT_TRUE(sheet.cracks().is_tip(Vertex(16)));
    EXPECT_FALSE(sheet.cracks().is_tip(Vertex(3)));
    VectorXd strains = VectorXd::Zero(static_cast<Eigen::Index>(sheet.mechanics().hinges.size()));
    strains[sheet.hinge_of_edge(edge_at(16, 29))] = 0.08;
    strains[sheet.hinge_of_edge(edge_at(22, 35))] = 0.08;
    EXPECT_EQ(failing_edges(sheet, strains, 0.7), std::vector{edge_at(16, 29)});
    EXPECT_TRUE(failing_edges(sheet, strains, 1).empty());
}

// A strip rolled into a cylinder, stretched, or both: the strain of its outer surface, over half the
// thickness.
TEST(OpeningStrain, IsSurfaceStrainOverHalfTheThickness) {
    SheetInput strip;
    strip.mesh = generate_rectangle(0.3, 0.3, {0.01, Layout::delaunay, 5});
    strip.material = {1000, 0.002, 1e7, 0.3};
    const BreakableSheet sheet({strip});
    const double curvature = 0.5, stretch = 2e-4;
    Positions rolled = sheet.mechanics().rest, stretched = rolled;
    for (Eigen::Index v = 0; v < rolled.cols(); ++v) {
        const double s = rolled(0, v);
        rolled(0, v) = std::sin(curvature * s) / curvature;
        rolled(2, v) = (1 - std::cos(curvature * s)) / curvature;
        stretched(0, v) *= 1 + stretch;
    }
    const VectorXd bent = opening_strains(sheet, rolled), pulled = opening_strains(sheet, stretched);
    double bending = 0;
    int count = 0;
    for (std::size_t i = 0; i < sheet.mechanics().hinges.size(); ++i) {
        const auto& vertices = sheet.mechanics().hinges[i].vertices;
        const Vector3d edge =
            sheet.mechanics().rest.col(vertices[1]) - sheet.mechanics().rest.col(vertices[0]);
        const double across = std::pow(edge.y() / edge.norm(), 2);  // squared cosine between x and across
        EXPECT_NEAR(pulled[i], across * stretch / 0.001,
                    1e-4 * stretch / 0.001 + 1e-3 * across * stretch / 0.001);
        if (across < 0.98) continue;
        bending += bent[i];
        ++count;
    }
    EXPECT_NEAR(bending / count, curvature, 0.1 * curvature);
}

}  // namespace
}  // namespace sherd
