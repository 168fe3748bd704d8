// SPDX-License-Identifier: GPL-3.0-or-later
// Crack paths in slowly loaded sheets: a user would notice a wrong one at once.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "fracture/step/simulation.h"
#include "meshops/generate/generate.h"
#include "tests/support/shell/materials.h"

namespace sherd {
namespace {

constexpr double width = 0.06, span = 0.2, edge_length = 0.006, strength = 4e7;
constexpr double ramp = 0.06;  // s

/// Result of a sheet under a load that grows from zero.
struct Outcome {
    double time = 0;  ///< s, of the first failure
    Snapshot end;
    CrackEvents events;
    std::vector<double> fragment_areas;
};

/// Pushes down on `faces`, with up to `force` (N/m^2). Returns the outcome when the sheet has fallen apart
/// and no edge has failed for ten steps.
Outcome press(const SheetInput& input, const std::vector<Index>& faces, double force) {
    SimulationOptions options;
    options.stepper.gravity.setZero();
    options.stepper.step = 2e-4;
    options.stepper.shell.damping.stiffness = 1e-4;
    options.stepper.contact.sheets = false;  // only the start and the paths of cracks count here
    const BreakableShell sheet({input});
    Load load;
    load.spread = area_forces(sheet.mechanics(), faces, Vector3d(0, 0, -force));
    load.ramp = ramp;
    options.stepper.shell.loads = {load};
    Simulation simulation({input}, options);
    Outcome outcome;
    int quiet = 0;
    while (simulation.time() < ramp && quiet < 10) {
        const StepReport report = simulation.step();
        EXPECT_EQ(report.halvings, 0) << "step " << report.step;
        if (report.stages > 0 && outcome.time == 0) outcome.time = report.time;
        quiet = report.stages > 0 || report.fragments == 1 ? 0 : quiet + 1;
    }
    outcome.events = simulation.take_events();
    outcome.end = simulation.snapshot();
    for (std::size_t f = 0; f < outcome.end.faces.size(); ++f) {
        const auto fragment = static_cast<std::size_t>(outcome.end.face_fragment[f]);
        outcome.fragment_areas.resize(std::max(outcome.fragment_areas.size(), fragment + 1));
        outcome.fragment_areas[fragment] += sheet.face_areas()[f];
    }
    return outcome;
}

SheetInput glass_rectangle(double length, double height, unsigned seed) {
    SheetInput sheet;
    sheet.mesh = generate_rectangle(length, height, {edge_length, Layout::delaunay, seed});
    sheet.material = test::glass;
    sheet.strength = uniform_strength(strength, Measure::stress);
    return sheet;
}

/// Faces whose centre has an x between `low` and `high` (m).
std::vector<Index> faces_between(const Mesh& mesh, double low, double high) {
    std::vector<Index> faces;
    for (const Face face : mesh.faces()) {
        double x = 0;
        for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(face))) x += mesh.point(v).x() / 3;
        if (x > low && x < high) faces.push_back(static_cast<Index>(face));
    }
    return faces;
}

SheetInput strip_on_two_supports(unsigned seed) {
    SheetInput strip = glass_rectangle(span, width, seed);
    for (const Vertex vertex : strip.mesh.vertices())
        if (strip.mesh.point(vertex).x() == 0 || strip.mesh.point(vertex).x() == span)
            strip.pinned.push_back(static_cast<Index>(vertex));
    return strip;
}

/// Edges of a path along the mesh from the rim at (x, 0) upward, to the height `depth` (m).
std::vector<Edge> notch(const Mesh& mesh, double x, double depth) {
    const auto distance = [&](Vertex v) { return std::hypot(mesh.point(v).x() - x, mesh.point(v).y()); };
    Vertex at = *std::min_element(mesh.vertices().begin(), mesh.vertices().end(),
                                  [&](Vertex a, Vertex b) { return distance(a) < distance(b); });
    std::vector<Edge> edges;
    while (mesh.point(at).y() < depth) {
        Halfedge best;
        double least = INFINITY;
        for (const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(at))) {
            const Point& next = mesh.point(mesh.source(h));
            if (next.y() < mesh.point(at).y() + 0.4 * edge_length || std::abs(next.x() - x) >= least)
                continue;
            least = std::abs(next.x() - x);
            best = h;
        }
        edges.push_back(mesh.edge(best));
        at = mesh.source(best);
    }
    return edges;
}

double largest_distance(const Outcome& outcome, const SheetInput& sheet, double x) {
    double largest = 0;
    for (const EdgeFailure& failure : outcome.events.failures)
        for (const Index v : failure.vertices)
            largest = std::max(largest, std::abs(sheet.mesh.point(Vertex(outcome.end.original[v])).x() - x));
    return largest;
}

// From a notch at a third of the span, where a uniform load bends the strip less than in its middle, the
// crack must run straight across, without failures elsewhere.
TEST(BreakingPath, RunsFromANotchAcrossABentStrip) {
    for (const unsigned seed : {1u, 2u, 3u}) {
        SheetInput strip = strip_on_two_supports(seed);
        const double place = span / 3;
        strip.strength.factors.assign(strip.mesh.number_of_edges(), 1);
        for (const Edge edge : notch(strip.mesh, place, 0.3 * width)) strip.strength.factors[edge] = 1e-3;
        const Outcome outcome = press(strip, faces_between(strip.mesh, 0, span), 3e4);
        ASSERT_EQ(outcome.fragment_areas.size(), 2u);
        EXPECT_NEAR(outcome.fragment_areas[0], 2. / 3 * span * width, 0.04 * span * width);
        EXPECT_LT(outcome.events.failures.size(), 1.5 * width / edge_length);
        EXPECT_LT(largest_distance(outcome, strip, place), 3 * edge_length);
    }
}

// A load on a narrow band in the middle, like that of a bar, must break the strip there once, at its
// strength.
TEST(BreakingPath, BreaksAStripBentOverAnEdgeOnce) {
    constexpr double most = 3e5;  // N/m^2
    for (const unsigned seed : {1u, 2u, 3u}) {
        const SheetInput strip = strip_on_two_supports(seed);
        const Outcome outcome =
            press(strip, faces_between(strip.mesh, span / 2 - edge_length, span / 2 + edge_length), most);
        ASSERT_EQ(outcome.fragment_areas.size(), 2u);
        EXPECT_NEAR(outcome.fragment_areas[0], span * width / 2, 0.04 * span * width);
        EXPECT_LT(outcome.events.failures.size(), 1.5 * width / edge_length);
        EXPECT_LT(largest_distance(outcome, strip, span / 2), 3 * edge_length);
        // Three-point bending, 6 M / (b t^2); the supports, which do not slide, add some tension.
        const double bar = most * outcome.time / ramp * 2 * edge_length * width;
        const double stress = 1.5 * bar * span / (width * test::glass.thickness * test::glass.thickness);
        EXPECT_GT(stress, 0.7 * strength);
        EXPECT_LT(stress, 1.1 * strength);
    }
}

/// Share of the crack's length in each of six classes of angle to the x axis: 0 to 15 degrees, ..., 75 to 90.
std::array<double, 6> angle_histogram(const Outcome& outcome, const SheetInput& sheet) {
    std::array<double, 6> share{};
    double total = 0;
    for (const EdgeFailure& failure : outcome.events.failures) {
        const Point &a = sheet.mesh.point(Vertex(outcome.end.original[failure.vertices[0]])),
                    &b = sheet.mesh.point(Vertex(outcome.end.original[failure.vertices[1]]));
        const double dx = std::abs(b.x() - a.x()), dy = std::abs(b.y() - a.y()), length = std::hypot(dx, dy);
        share[std::min(5, static_cast<int>(std::atan2(dy, dx) * 12 / std::numbers::pi))] += length;
        total += length;
    }
    for (double& part : share) part /= total;
    return share;
}

// In a plate that is four times as strong along its axis as across, cracks must run along the axis, whatever
// its direction on the mesh.
TEST(BreakingPath, FollowsTheWeakDirectionOfAPlate) {
    for (const double degrees : {0, 90}) {
        SheetInput plate = glass_rectangle(0.2, 0.2, 4);
        for (const Vertex vertex : plate.mesh.vertices())
            if (plate.mesh.is_border(vertex)) plate.pinned.push_back(static_cast<Index>(vertex));
        const double angle = degrees * std::numbers::pi / 180;
        plate.axes.assign(plate.mesh.number_of_faces(), Vector3d(std::cos(angle), std::sin(angle), 0));
        plate.strength.along = 4 * strength;
        const Outcome outcome = press(plate, faces_between(plate.mesh, 0, 0.2), 4e5);
        std::array<double, 6> share = angle_histogram(outcome, plate);
        if (degrees == 90) std::reverse(share.begin(), share.end());
        EXPECT_GT(share[0] + share[1], 0.5) << "within 30 degrees of the axis";
        EXPECT_LT(share[4] + share[5], 0.1) << "within 30 degrees of across it";
        EXPECT_GT(outcome.events.failures.size(), 100u);
    }
}

}  // namespace
}  // namespace sherd
