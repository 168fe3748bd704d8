// SPDX-License-Identifier: GPL-3.0-or-later
// With errors in the fields of faces, a recording would have the stress of other faces, or of another time,
// than it claims.
#include <gtest/gtest.h>

#include <cstdio>
#include <numbers>

#include "core/forces/shell_energies.h"
#include "fracture/step/simulation.h"
#include "meshops/generate/generate.h"

namespace sherd {
namespace {

/// Strip that is held at one end and hangs under its weight.
SheetInput hanging_strip(double strength) {
    SheetInput strip;
    strip.mesh = generate_rectangle(0.3, 0.06, {0.02, Layout::delaunay, 3});
    strip.material = {1000, 0.002, 1e7, 0.3};
    strip.strength.across = strip.strength.along = strength;
    for (const Vertex vertex : strip.mesh.vertices())
        if (strip.mesh.point(vertex).x() < 0.021) strip.pinned.push_back(static_cast<Index>(vertex));
    return strip;
}

SimulationOptions with_all_fields(BendingModel model) {
    SimulationOptions options;
    options.stepper.step = 5e-3;
    options.stepper.shell.bending = {.model = model, .jacobian = exact_jacobian(model)};
    options.fields = {true, true, true};
    for (const Index face : {3, 40})
        options.gauges.push_back({.face = face, .place = {0.1, 0.02, 0}, .fields = options.fields});
    return options;
}

void expect_fields_of_all_faces(const Snapshot& snapshot) {
    visit_fields(snapshot.fields, [&](const char* name, const Eigen::Matrix3Xd& values, const FieldMeaning&) {
        EXPECT_EQ(values.cols(), static_cast<Eigen::Index>(snapshot.faces.size())) << name;
        EXPECT_TRUE(values.allFinite()) << name;
    });
}

TEST(FieldsOfRuns, GaugesShowThoseOfTheirFacesAtTheEndOfTheStep) {
    for (const BendingModel model : {BendingModel::cubic, BendingModel::coupled}) {
        Simulation simulation({hanging_strip(1e9)}, with_all_fields(model));
        const Snapshot start = simulation.snapshot();
        expect_fields_of_all_faces(start);
        EXPECT_LT(start.fields.stress_top.norm(), 1e-3);
        simulation.step();
        const StepReport report = simulation.step();
        const Snapshot end = simulation.snapshot();
        expect_fields_of_all_faces(end);
        for (const std::size_t g : {0, 1}) {
            const Index face = simulation.gauges()[g].face;
            EXPECT_EQ(report.gauges[g].stress_top, end.fields.stress_top.col(face));
            EXPECT_EQ(report.gauges[g].stress_bottom, end.fields.stress_bottom.col(face));
            EXPECT_EQ(report.gauges[g].curvature, end.fields.curvature.col(face));
            EXPECT_EQ(report.gauges[g].membrane_strain, end.fields.membrane_strain.col(face));
            EXPECT_GT(largest_stress(report.gauges[g]), 10);
        }
    }
}

// The top of a strip that hangs down is stretched along it, most of all near its wall.
TEST(FieldsOfRuns, TopOfAHangingStripIsStretched) {
    Simulation simulation({hanging_strip(1e9)}, with_all_fields(BendingModel::coupled));
    for (int i = 0; i < 4; ++i) simulation.step();
    const FaceFields fields = simulation.snapshot().fields;
    const FieldPeak peak = stress_peak(fields);
    EXPECT_TRUE(peak.top);
    const Snapshot snapshot = simulation.snapshot();
    const double x = columns(snapshot.rest.position, snapshot.rest.faces[peak.face]).row(0).mean();
    EXPECT_LT(x, 0.1);
    EXPECT_LT(curvature_peak(fields).value, 0);
}

TEST(FieldsOfRuns, GoOnWhereTheSheetBreaks) {
    for (const BendingModel model : {BendingModel::cubic, BendingModel::coupled}) {
        Simulation simulation({hanging_strip(0.3)}, with_all_fields(model));
        int steps = 0;
        while (simulation.take_events().splits.empty() && ++steps < 20) simulation.step();
        ASSERT_LT(steps, 20);
        const Snapshot snapshot = simulation.snapshot();
        EXPECT_GT(snapshot.position.cols(), snapshot.rest.position.cols());
        expect_fields_of_all_faces(snapshot);
    }
}

TEST(FieldsOfRuns, AreNotThereUnlessWanted) {
    SimulationOptions options = with_all_fields(BendingModel::cubic);
    options.fields = {};
    options.gauges.resize(1);
    options.gauges[0].fields = {.curvature = true};
    Simulation simulation({hanging_strip(1e9)}, options);
    const StepReport report = simulation.step();
    EXPECT_FALSE(choice_of(simulation.snapshot().fields).any());
    EXPECT_GT(report.gauges[0].curvature.norm(), 0);
    EXPECT_EQ(report.gauges[0].stress_top.norm(), 0);
}

/// Root mean square error of the faces' curvature on a square of side 1 m that is bent to the height a
/// sin(pi x), over the root mean square of the curvature; without a rim of 0.15 m, where free edges matter.
double error_of_curvature(BendingModel model, double edge_length) {
    SheetInput square;
    square.mesh = generate_rectangle(1, 1, {edge_length, Layout::delaunay, 5});
    square.material = {1000, 0.002, 1e7, 0.3};
    const BreakableShell sheet({square});
    const Shell& shell = sheet.mechanics();
    constexpr double pi = std::numbers::pi, height = 1e-4, rim = 0.15;
    Positions bent = shell.rest;
    bent.row(2) = height * (pi * shell.rest.row(0).array()).sin();
    const Eigen::Matrix3Xd curvatures =
        ShellEnergies(shell, {.bending = {.model = model}}).face_curvatures(bent);
    double wrong = 0, all = 0;
    for (std::size_t f = 0; f < shell.triangles.size(); ++f) {
        const TrianglePositions corners = columns(shell.rest, shell.triangles[f].vertices);
        const Vector3d middle = corners.rowwise().mean();
        if (middle.head<2>().minCoeff() < rim || middle.head<2>().maxCoeff() > 1 - rim) continue;
        Eigen::Matrix2d exact, found;
        exact << -height * pi * pi * std::sin(pi * middle.x()), 0, 0, 0;
        const Vector3d k = curvatures.col(static_cast<Eigen::Index>(f));
        found << k[0], k[2] / 2, k[2] / 2, k[1];
        const Eigen::Matrix2d axes = frame_axes(corners).topRows<2>();
        wrong += (axes * found * axes.transpose() - exact).squaredNorm();
        all += exact.squaredNorm();
    }
    return std::sqrt(wrong / all);
}

// Prints a table of docs/theory/bending.md: stress from fields of single hinges must not be trusted.
TEST(FieldsOfRuns, CurvatureConvergesWithCoupledHingesOnly) {
    double before = 1;
    for (const double edge : {0.1, 0.05, 0.025}) {
        const double single = error_of_curvature(BendingModel::cubic, edge),
                     coupled = error_of_curvature(BendingModel::coupled, edge);
        std::printf("edges of %5.3f: single hinges %4.1f %%, coupled %4.1f %%\n", edge, 100 * single,
                    100 * coupled);
        EXPECT_GT(single, 0.1);
        EXPECT_LT(single, 0.3);
        EXPECT_LT(coupled, 0.7 * before);
        before = coupled;
    }
    EXPECT_LT(before, 0.02);
}

}  // namespace
}  // namespace sherd
