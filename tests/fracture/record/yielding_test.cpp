// SPDX-License-Identifier: GPL-3.0-or-later
// Metal that is bent too far keeps its shape: without the yield ratio in the report a dented lid would be
// taken for a sound one.
#include "fracture/record/yielding.h"

#include <gtest/gtest.h>

#include <numbers>

#include "fracture/step/simulation.h"
#include "meshops/generate/generate.h"
#include "tests/support/shell/materials.h"

namespace sherd {
namespace {

SheetInput strip(double yield, double offset = 0) {
    SheetInput input;
    input.mesh = generate_rectangle(0.1, 0.05, {0.02, Layout::structured, 1});
    for (const Vertex vertex : input.mesh.vertices()) {
        const Point at = input.mesh.point(vertex);
        input.mesh.point(vertex) = Point(at.x(), at.y(), at.z() + offset);
    }
    input.material = test::glass;
    input.material.yield = yield;
    return input;
}

TEST(Yielding, VonMisesStressIsThatOfKnownStates) {
    EXPECT_DOUBLE_EQ(von_mises({3, 0, 0}), 3);
    EXPECT_DOUBLE_EQ(von_mises({0, -3, 0}), 3);
    EXPECT_DOUBLE_EQ(von_mises({3, 3, 0}), 3);
    EXPECT_DOUBLE_EQ(von_mises({0, 0, 2}), 2 * std::numbers::sqrt3);
}

// Equal stretches e and a curvature k give the stress Y / (1 - nu) (e +- k t / 2) in all directions.
TEST(Yielding, IsTheWorseSurfaceOfTheWorstFaceOverTheStressOfItsSheet) {
    const BreakableShell shell({strip(1e8), strip(0, 1), strip(2e7, 2)});
    const auto faces = static_cast<Eigen::Index>(shell.mechanics().triangles.size());
    const double stretch = 1e-4, curvature = 0.02, elasticity = test::glass.young / (1 - test::glass.poisson);
    FaceStrains strains{Eigen::Matrix3Xd::Zero(3, faces), Eigen::Matrix3Xd::Zero(3, faces)};
    strains.membrane.topRows(2).setConstant(stretch);
    strains.curvature.topRows(2).setConstant(curvature);
    const YieldPeak peak = yield_peak(shell, strains);
    const double stress = elasticity * (stretch + curvature * test::glass.thickness / 2);
    EXPECT_NEAR(peak.ratio, stress / 2e7, 1e-9);
    EXPECT_EQ(peak.place.sheet, 2);
    EXPECT_NEAR(peak.place.rest.z(), 2, 1e-12);
    // The first sheet alone is beyond its yield stress, in one face.
    const Eigen::Index face = 3;
    strains.membrane.col(face) *= 100;
    const YieldPeak other = yield_peak(shell, strains);
    EXPECT_NEAR(other.ratio, elasticity * (100 * stretch + curvature * test::glass.thickness / 2) / 1e8,
                1e-9);
    EXPECT_EQ(other.place.sheet, 0);
    EXPECT_EQ(yield_peak(BreakableShell({strip(0)}), strains).ratio, 0) << "nothing there yields";
}

// The reports of implicit and of explicit steps must include the yield ratio.
TEST(Yielding, IsInTheReportOfEachStep) {
    for (const Scheme scheme : {Scheme::implicit_euler, Scheme::explicit_differences}) {
        SheetInput input = strip(1e6);
        input.start.resize(3, static_cast<Eigen::Index>(input.mesh.number_of_vertices()));
        for (const Vertex vertex : input.mesh.vertices()) {
            const Point at = input.mesh.point(vertex);
            input.start.col(vertex.idx()) = Vector3d(1.0001 * at.x(), at.y(), at.z());
        }
        SimulationOptions options;
        options.stepper.scheme = scheme;
        options.stepper.step = 1e-5;
        Simulation simulation({input}, options);
        const StepReport report = simulation.step();
        EXPECT_GT(report.peak_yield, 0.5);
        EXPECT_EQ(report.yielding.sheet, 0);
    }
}

}  // namespace
}  // namespace sherd
