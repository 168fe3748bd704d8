// SPDX-License-Identifier: GPL-3.0-or-later
// Cracks by strength and toughness. If the mesh instead of its load drove a tip, or a tip lost its path, its
// speed or its neighbours, star-shaped cracks would become holes, and straight cracks zigzags.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/contact/colliders/rigid_body.h"
#include "fracture/step/simulation.h"
#include "meshops/generate/generate.h"
#include "tests/support/shell/materials.h"

namespace sherd {
namespace {

constexpr double strip_length = 0.12, strip_width = 0.06, strip_edge = 0.004;  // m
const double usual_limit = usual_speed_limit(test::glass);
/// m/s, higher than any tip's speed, so that none branches
constexpr double no_limit = 6000;

/// Glass strip along x, whose hinges near the middle of one side are weak, so that a crack starts there, and
/// strong elsewhere.
SheetInput weakened_strip(std::uint32_t seed, double toughness, CrackPath path = CrackPath::cut,
                          double limit = usual_limit) {
    SheetInput input;
    input.mesh = generate_rectangle(strip_length, strip_width, {strip_edge, Layout::delaunay, seed});
    input.material = test::glass;
    input.strength = uniform_strength(4e7, Measure::stress);
    for (const Edge edge : input.mesh.edges()) {
        const Point middle = CGAL::midpoint(input.mesh.point(input.mesh.vertex(edge, 0)),
                                            input.mesh.point(input.mesh.vertex(edge, 1)));
        const bool weak =
            std::abs(middle.x() - strip_length / 2) < strip_edge && middle.y() < 1.5 * strip_edge;
        input.strength.factors.push_back(weak ? 0.2 : 10);
    }
    input.toughness.value = toughness;
    input.toughness.speed_limit = limit;
    input.toughness.path = path;
    return input;
}

/// Forces, N/m, that pull both ends of the strip apart.
std::vector<Load> pulled(const BreakableShell& sheets, double force) {
    const Shell& shell = sheets.mechanics();
    std::vector<Load> loads(1);
    for (const double sign : {-1.0, 1.0}) {
        std::vector<char> end(shell.rest.cols());
        for (Index v = 0; v < static_cast<Index>(end.size()); ++v)
            end[v] = std::abs(shell.rest(0, v) - (sign < 0 ? 0 : strip_length)) < 1e-9;
        const auto forces =
            line_forces(shell, boundary_triangle_edges(shell, end), Vector3d(sign * force, 0, 0));
        loads[0].dead.insert(loads[0].dead.end(), forces.begin(), forces.end());
    }
    return loads;
}

SimulationOptions explicit_steps() {
    SimulationOptions options;
    options.stepper.scheme = Scheme::explicit_differences;
    options.stepper.step = 1e-6;
    return options;
}

/// Strip pulled at both ends by `stress` (Pa).
Simulation pulled_strip(std::uint32_t seed, double toughness, double stress, CrackPath path = CrackPath::cut,
                        double limit = usual_limit, SimulationOptions options = explicit_steps()) {
    BreakableShell sheets({weakened_strip(seed, toughness, path, limit)});
    options.stepper.gravity.setZero();
    options.stepper.contact.sheets = false;
    options.stepper.shell.damping.stiffness = 2e-8;
    options.stepper.shell.loads = pulled(sheets, stress * test::glass.thickness);
    return Simulation(std::move(sheets), options);
}

/// Failed edges of a run by their ends at rest, with the times.
struct Failures {
    std::vector<std::pair<Vector3d, Vector3d>> edges;
    std::vector<double> times;

    void add(Simulation& simulation) {
        const CrackEvents events = simulation.take_events();
        const Positions& rest = simulation.shell().mechanics().rest;
        for (const EdgeFailure& failure : events.failures) {
            edges.emplace_back(rest.col(failure.vertices[0]), rest.col(failure.vertices[1]));
            times.push_back(failure.time);
        }
    }
};

/// Length of all cracks when the strip is in two, over its width.
double path_ratio(std::uint32_t seed, CrackPath path) {
    Simulation simulation = pulled_strip(seed, 1e6, 1.5e7, path, no_limit);
    Failures failures;
    Index pieces = 1;
    for (int i = 0; i < 400 && pieces == 1; ++i) {
        pieces = simulation.step().fragments;
        failures.add(simulation);
    }
    EXPECT_EQ(pieces, 2) << "seed " << seed;
    double cracked = 0;
    for (const auto& [a, b] : failures.edges) {
        cracked += (a - b).norm();
        EXPECT_NEAR(0.5 * (a + b).x(), strip_length / 2, 3 * strip_edge) << "seed " << seed;
    }
    return cracked / strip_width;
}

// A pulled strip breaks straight across, from its weak place, in two: without branches or dust.
TEST(CrackGrowth, RunsStraightAcrossAPull) {
    for (const std::uint32_t seed : {1u, 2u, 3u}) {
        EXPECT_LT(path_ratio(seed, CrackPath::cut), 1.05) << "seed " << seed << ": the mesh led the crack";
        EXPECT_LT(path_ratio(seed, CrackPath::edges), 1.3) << "seed " << seed << ": a tenth longer is usual";
    }
}

// Triangles made by cracks must keep the area and the mass of the sheet, and no fragment may be lost.
TEST(CrackGrowth, KeepsAreaAndMass) {
    Simulation simulation = pulled_strip(1, 1e6, 1.5e7);
    const Shell& shell = simulation.shell().mechanics();
    const double mass = shell.mass.sum();
    const std::size_t faces = shell.triangles.size();
    for (int i = 0; i < 100; ++i) simulation.step();
    double area = 0;
    for (const double one : simulation.shell().face_areas()) area += one;
    EXPECT_NEAR(area / (strip_length * strip_width), 1, 1e-12);
    EXPECT_NEAR(shell.mass.sum() / mass, 1, 1e-12);
    EXPECT_LE(shell.triangles.size(), faces + 2 * 20) << "at most two for an edge of the crack";
}

// Each tip keeps its number as long as it propagates, and its load is recorded meanwhile.
TEST(CrackGrowth, RecordsItsTips) {
    Simulation simulation = pulled_strip(1, 1e6, 1.5e7, CrackPath::cut, no_limit);
    std::vector<TipRecord> tips;
    for (int i = 0; i < 60; ++i) {
        const StepReport report = simulation.step();
        for (const TipRecord& tip : simulation.take_events().tips) {
            EXPECT_EQ(tip.time, report.time);
            EXPECT_EQ(tip.step, report.step);
            tips.push_back(tip);
        }
    }
    ASSERT_GT(tips.size(), 10u);
    const double needed = 1e12 / test::glass.young;
    std::size_t pulled = 0;
    for (const TipRecord& tip : tips) {
        EXPECT_EQ(tip.tip, tips.front().tip) << "a crack from the rim has one";
        EXPECT_NEAR(tip.toughness / needed, 1, 1e-12);
        EXPECT_NEAR(tip.direction.norm(), 1, 1e-12);
        EXPECT_LT(tip.speed, (1 + 1e-9) * no_limit);
        pulled += tip.opening > std::abs(tip.shear) ? 1 : 0;
    }
    EXPECT_GT(pulled, 3 * tips.size() / 4) << "it is pulled open";
    EXPECT_GT((tips.back().position - tips.front().position).norm(), 2 * strip_edge);
}

// Far above its toughness a crack must branch, and both branches must propagate.
TEST(CrackGrowth, BranchesWhereItsMeanReleaseIsTooLarge) {
    Simulation simulation = pulled_strip(1, 1e6, 1.5e7);
    std::map<Index, std::vector<Vector3d>> places;
    for (int i = 0; i < 60; ++i) {
        simulation.step();
        for (const TipRecord& tip : simulation.take_events().tips) places[tip.tip].push_back(tip.position);
    }
    const auto ran = std::ranges::count_if(places, [](const auto& tip) {
        return (tip.second.back() - tip.second.front()).norm() > 2 * strip_edge;
    });
    EXPECT_GT(ran, 1) << "branches stopped where they began";
}

// The shares of cohesive force must fade to zero, on failed edges and no others.
TEST(CrackGrowth, SnapshotsTellHowFarEdgesHaveFaded) {
    Simulation simulation = pulled_strip(1, 1e6, 1.5e7);
    std::map<std::size_t, double> before;
    std::size_t seen = 0;
    int faded = 0;
    for (int i = 0; i < 400; ++i) {
        simulation.step();
        const Snapshot frame = simulation.snapshot();
        ASSERT_TRUE(frame.edge_cohesive_share.empty() ||
                    frame.edge_cohesive_share.size() == frame.edges.size());
        std::map<std::size_t, double> now;
        for (std::size_t e = 0; e < frame.edge_cohesive_share.size(); ++e) {
            if (frame.edge_cohesive_share[e] == 0) continue;
            EXPECT_NE(frame.edge_state[e], EdgeState::interior) << "edge " << e;
            now[e] = frame.edge_cohesive_share[e];
            EXPECT_LE(now[e], before.contains(e) ? before[e] : 1) << "edge " << e;
            faded += before.contains(e) && now[e] < before[e];
        }
        EXPECT_EQ(now.empty(), frame.edge_cohesive_share.empty()) << "written only where an edge opens";
        seen = std::max(seen, now.size());
        before = now;
    }
    EXPECT_GE(seen, 1u);
    EXPECT_GE(faded, 1);
    EXPECT_TRUE(before.empty()) << "in the end nothing holds the strip together";
}

/// Strip in implicit steps of `step` s, until it is in two, or for 400 steps.
struct ImplicitRun {
    StepReport last;
    double needed = 0;   ///< J, fracture energy of the cracks
    double largest = 0;  ///< J, largest kinetic or membrane energy
    int fading = 0;      ///< number of edges that a step left half open

    explicit ImplicitRun(double step) {
        SimulationOptions options;
        options.stepper.step = step;
        Simulation simulation = pulled_strip(1, 1e6, 1.5e7, CrackPath::cut, usual_limit, options);
        Failures failures;
        for (int i = 0; i < 400 && last.fragments < 2; ++i) {
            last = simulation.step();
            failures.add(simulation);
            largest = std::max({largest, last.kinetic, last.membrane});
            for (const double held : simulation.snapshot().edge_cohesive_share) fading += held > 0;
        }
        for (const auto& [a, b] : failures.edges)
            needed += (a - b).norm() * test::glass.thickness * 1e12 / test::glass.young;
    }
};

// Cracks take their energy from the stored one, and no more than they need, whether an edge opens within a
// step or in several: in the latter case a part has become kinetic energy before.
TEST(CrackGrowth, CracksTakeTheirEnergyInImplicitStepsToo) {
    for (const double step : {5e-7, 1e-5}) {
        const ImplicitRun run(step);
        EXPECT_GE(run.last.fragments, 2);
        EXPECT_EQ(run.fading > 0, step < 1e-6);
        const double share = run.last.lost_to_cracks / run.needed;
        EXPECT_LT(share, 1.05) << "in steps of " << step << " s";
        EXPECT_GT(share, step < 1e-6 ? 0.5 : 0.8) << "in steps of " << step << " s";
        EXPECT_LT(std::abs(run.last.unexplained), 1e-6 * run.largest);
    }
}

// No tip may exceed its speed limit, however it is loaded.
TEST(CrackGrowth, KeepsTheSpeedLimit) {
    const double limit = usual_speed_limit(test::glass);
    EXPECT_NEAR(limit, 1500, 100) << "as measured in glass";
    Simulation simulation = pulled_strip(1, 1e5, 3e7);
    Failures failures;
    for (int i = 0; i < 200 && simulation.step().fragments < 2; ++i) failures.add(simulation);
    ASSERT_GT(failures.edges.size(), 8u);
    for (std::size_t i = 0; i < failures.edges.size(); ++i) {
        const double way = failures.edges[i].first.y() - failures.edges[0].first.y();
        const double time = failures.times[i] - failures.times[0];
        EXPECT_LT(way, limit * time + 3 * strip_edge) << "after " << time << " s";
    }
}

// Where the load is below the toughness a crack that has started must arrest.
TEST(CrackGrowth, AToughSheetArrestsItsCrack) {
    Simulation simulation = pulled_strip(1, 1e7, 1.5e7);
    Failures failures;
    for (int i = 0; i < 200; ++i) {
        simulation.step();
        failures.add(simulation);
    }
    EXPECT_GE(failures.edges.size(), 1u);
    EXPECT_LT(failures.edges.size(), 4u);
}

TEST(CrackGrowth, ASheetWithoutToughnessBreaksAsBefore) {
    const BreakableShell tough({weakened_strip(1, 1e6)}), plain({weakened_strip(1, 0)});
    EXPECT_FALSE(CrackGrowth(plain, MembraneModel::constant_strain, false).needed());
    EXPECT_TRUE(CrackGrowth(tough, MembraneModel::constant_strain, false).needed());
    EXPECT_EQ(tough.crack_tip_factor(Edge(0)), 1);
    EXPECT_EQ(plain.crack_tip_factor(Edge(0)), Strength().crack_tip_factor);
}

// A plate that a nose strikes must break in a star, without a hole and without dust.
TEST(CrackGrowth, AStruckPlateBreaksInAStar) {
    SheetInput plate;
    plate.mesh = generate_rectangle(0.12, 0.12, {0.003, Layout::delaunay, 1});
    plate.material = {.density = 1190, .thickness = 1e-3, .young = 3.2e9, .poisson = 0.35};
    plate.strength = uniform_strength(9e7, Measure::stress);
    plate.toughness = {.value = 1.1e6, .speed_limit = 400};
    RigidBody nose = rigid_sphere(1.5e-3, 3.5e5);
    const Vector3d blow(0.061, 0.0605, 0);
    nose.centre = blow + Vector3d(0, 0, 2.01e-3);
    nose.velocity = Vector3d(0, 0, -50);
    SimulationOptions options;
    options.stepper.scheme = Scheme::explicit_differences;
    options.stepper.step = 1e-6;
    options.stepper.contact.sheets = false;
    options.stepper.contact.bodies = {nose};
    options.stepper.shell.damping.stiffness = 1e-8;
    Simulation simulation({plate}, options);
    Failures failures;
    Index pieces = 1;
    for (int i = 0; i < 200; ++i) {
        pieces = simulation.step().fragments;
        failures.add(simulation);
    }
    double all = 0, radial = 0, farthest = 0;
    for (const auto& [a, b] : failures.edges) {
        const Vector3d way = b - a, out = 0.5 * (a + b) - blow;
        all += way.norm();
        if (std::abs(way.normalized().dot(out.normalized())) > std::cos(std::numbers::pi / 4))
            radial += way.norm();
        farthest = std::max(farthest, out.norm());
    }
    EXPECT_LE(pieces, 4) << "arms, and no hole";
    EXPECT_GT(farthest, 0.015);
    EXPECT_GT(all, 0.04) << "several of them";
    EXPECT_GT(radial, 0.7 * all);
}

}  // namespace
}  // namespace sherd
