// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/record/hinge_peaks.h"

#include <gtest/gtest.h>

#include "fracture/step/simulation.h"
#include "meshops/generate/generate.h"
#include "tests/support/contact/obstacles.h"

namespace sherd {
namespace {

SheetInput disc() {
    SheetInput sheet;
    sheet.mesh = generate_disc(0.1, {0.03, Layout::delaunay, 3});
    sheet.material = {2400, 0.004, 7e10, 0.2};
    return sheet;
}

/// Measures of all hinges: `factor`, and twice and three times as much, times the number of the hinge's
/// edge.
HingeMeasures by_edge(const BreakableShell& sheet, double factor) {
    VectorXd values(static_cast<Index>(sheet.mechanics().hinges.size()));
    for (Index i = 0; i < values.size(); ++i)
        values[i] = factor * static_cast<double>(sheet.edge_of_hinge(i));
    return {values, 2 * values, 3 * values};
}

// Hinges are renumbered when one fails: a peak must not pass to another edge.
TEST(HingePeaks, StayWithTheirEdgesWhateverFails) {
    BreakableShell sheet({disc()});
    std::vector<Edge> failing;
    for (std::size_t i = 0; i < sheet.mechanics().hinges.size(); i += 3)
        failing.push_back(sheet.edge_of_hinge(i));
    HingePeaks peaks;
    peaks.record(sheet, by_edge(sheet, 5));
    peaks.finish_step();
    sheet.fail(failing);
    ASSERT_GT(sheet.mesh().number_of_edges(), static_cast<std::size_t>(peaks.of_edges().strain.size()))
        << "cracks have opened";
    peaks.record(sheet, by_edge(sheet, 7));
    peaks.finish_step();
    peaks.record(sheet, by_edge(sheet, 6));
    peaks.finish_step();
    for (const Edge edge : failing) EXPECT_EQ(peaks.of_edges().bending[edge], 5.0 * edge);
    for (std::size_t i = 0; i < sheet.mechanics().hinges.size(); ++i) {
        const Edge edge = sheet.edge_of_hinge(i);
        EXPECT_EQ(peaks.of_edges().bending[edge], 7.0 * edge);
        EXPECT_EQ(peaks.of_edges().strain[edge], 14.0 * edge);
        EXPECT_EQ(peaks.of_edges().stress[edge], 21.0 * edge);
    }
}

// A failed step is repeated with a shorter one; its measures must be dropped.
TEST(HingePeaks, ReplaceAttemptsThatWereGivenUp) {
    const BreakableShell sheet({disc()});
    HingePeaks peaks;
    peaks.record(sheet, by_edge(sheet, 100));
    peaks.record(sheet, by_edge(sheet, 1));
    peaks.finish_step();
    EXPECT_EQ(peaks.of_edges().bending.maxCoeff(), by_edge(sheet, 1).bending.maxCoeff());
}

// If the largest peak were not that of the reports, the table of a run would contradict itself.
TEST(HingePeaks, TheLargestIsThatOfTheReports) {
    SheetInput sheet = disc();
    for (const Vertex v : sheet.mesh.vertices()) {
        const Point at = sheet.mesh.point(v);
        sheet.mesh.point(v) = Point(at.x(), at.y(), 0.0025 + 0.05 * (at.x() + 0.1));
    }
    sheet.velocity = Vector3d(0, 0, -2);
    SimulationOptions options;
    options.stepper.contact.obstacles = {test::floor()};
    Simulation simulation({sheet}, options);
    StepReport peaks;
    for (int i = 0; i < 20; ++i) raise_peaks(peaks, simulation.step());
    EXPECT_GT(peaks.peak_stress, 1e5);
    EXPECT_EQ(simulation.peaks().of_edges().stress.maxCoeff(), peaks.peak_stress);
    EXPECT_EQ(simulation.peaks().of_edges().strain.maxCoeff(), peaks.peak_strain);
    EXPECT_EQ(simulation.peaks().of_edges().bending.maxCoeff(), peaks.peak_bending_strain);
    EXPECT_EQ(simulation.peaks().of_edges().strain.size(),
              static_cast<Index>(simulation.shell().mesh().number_of_edges()));
}

}  // namespace
}  // namespace sherd
