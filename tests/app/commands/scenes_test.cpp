// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the shipped scenes to their end, through the real program, and checks in every frame what must hold
// for any run: otherwise runs could break a law without a message.
#include <CGAL/boost/graph/helpers.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>

#include "app/recording/recording.h"
#include "app/scene/read/scene.h"
#include "tests/support/mesh/corner_rule.h"
#include "tests/support/mesh/mesh_shapes.h"
#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"
#include "tests/support/recording/frame_intersections.h"

namespace sherd {
namespace {

using test::CornerRule;

const std::filesystem::path scenes = SHERD_SCENES;

void expect_manifold(const Snapshot& frame) {
    const Mesh mesh = test::frame_mesh(frame);
    ASSERT_EQ(mesh.number_of_faces(), frame.faces.size()) << "faces that do not fit a 2-manifold";
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh));
    EXPECT_EQ(mesh.number_of_edges(), frame.edges.size());
    for (const Vertex vertex : mesh.vertices()) {
        std::size_t fan = 0;
        for (const Face face : mesh.faces_around_target(mesh.halfedge(vertex)))
            fan += face != Mesh::null_face();
        std::size_t incident = 0;
        for (const auto& face : frame.faces)
            incident += std::count(face.begin(), face.end(), static_cast<Index>(vertex));
        if (fan != incident) ADD_FAILURE() << "vertex " << vertex.idx() << " has more than one fan";
        if (mesh.number_of_vertices() > 4000) break;  // the loop is quadratic; the corner rule checks all
    }
}

/// Faces must keep their size at rest, or share it out where cracks split them; no mass or area may be lost
/// or added.
void expect_same_matter(const Snapshot& frame, const Snapshot& first) {
    EXPECT_NEAR(frame.mass.sum(), first.mass.sum(), 1e-13 * first.mass.sum());
    ASSERT_EQ(frame.rest.faces.size(), frame.faces.size());
    double whole = 0, whole_first = 0;
    for (const double area : first.rest.area) whole_first += area;
    for (std::size_t f = 0; f < frame.faces.size(); ++f) {
        std::array<Vector3d, 3> rest;
        for (int i = 0; i < 3; ++i) rest[i] = frame.rest.position.col(frame.original[frame.faces[f][i]]);
        const double area = 0.5 * (rest[1] - rest[0]).cross(rest[2] - rest[0]).norm();
        ASSERT_NEAR(area, frame.rest.area[f], 1e-12 * area);
        whole += area;
    }
    EXPECT_NEAR(whole, whole_first, 1e-12 * whole_first);
    const bool is_unchanged = frame.rest.faces == first.rest.faces &&
                              frame.rest.position.cols() == first.rest.position.cols() &&
                              frame.rest.position == first.rest.position;
    EXPECT_TRUE(!is_unchanged || frame.rest.area == first.rest.area);
}

/// Faces must not pass through each other, except for crack faces (lips), whose overlap is limited to a tenth
/// of the thickness elsewhere.
void expect_no_intersection(const Snapshot& frame) {
    for (const auto& [a, b] : test::frame_intersections(frame).passing)
        ADD_FAILURE() << "faces " << a.idx() << " and " << b.idx() << " pass through each other";
}

/// Edge states and vertices must agree with the corner rule, applied to the failed edges of the mesh at rest.
void expect_corner_rule(const Snapshot& frame) {
    const auto at_rest = [&](std::size_t edge) {
        return CornerRule::ordered(frame.original[frame.edges[edge][0]],
                                   frame.original[frame.edges[edge][1]]);
    };
    std::set<CornerRule::VertexPair> failed;
    for (std::size_t e = 0; e < frame.edges.size(); ++e)
        if (frame.edge_state[e] != EdgeState::interior) failed.insert(at_rest(e));
    CornerRule rule(frame.rest.faces, {failed.begin(), failed.end()});
    std::map<int, int> vertex_of_root;
    for (std::size_t f = 0; f < frame.faces.size(); ++f)
        for (int i = 0; i < 3; ++i) {
            ASSERT_EQ(frame.original[frame.faces[f][i]], frame.rest.faces[f][i]);
            ASSERT_EQ(
                vertex_of_root.emplace(rule.vertex(static_cast<int>(f), i), frame.faces[f][i]).first->second,
                frame.faces[f][i]);
        }
    EXPECT_EQ(rule.vertex_count(), frame.position.cols());
    for (std::size_t e = 0; e < frame.edges.size(); ++e) {
        const auto [from, to] = at_rest(e);
        const bool is_parted = rule.is_open(from, to) || rule.is_border(from, to);
        ASSERT_EQ(is_parted, frame.edge_state[e] == EdgeState::boundary) << "edge " << e;
    }
}

/// Only gravity may act between two steps without contact.
void expect_momentum(const std::vector<StepReport>& steps, double mass, const Vector3d& gravity) {
    for (std::size_t i = 1; i < steps.size(); ++i) {
        if (steps[i].contacts > 0 || steps[i - 1].contacts > 0) continue;
        const Vector3d expected = steps[i - 1].linear_momentum + mass * steps[i].step_size * gravity;
        ASSERT_LT((steps[i].linear_momentum - expected).norm(), 1e-9 * expected.norm())
            << "step " << steps[i].step;
    }
}

/// Without prescribed motion no step may add energy, whatever fractures and collides.
void expect_no_energy_from_nowhere(const std::vector<StepReport>& steps) {
    const auto energy = [](const StepReport& step) {
        return step.kinetic + step.bending + step.membrane + step.gravity + step.contact;
    };
    for (std::size_t i = 1; i < steps.size(); ++i)
        ASSERT_LT(energy(steps[i]) - energy(steps[i - 1]), 1e-6 * steps[i - 1].kinetic + 1e-12)
            << "step " << steps[i].step;
}

/// Checks the energy residual: if it were larger, a force would be missing in the balance, or the reported
/// losses would be wrong.
void expect_balance(const std::vector<StepReport>& steps, bool is_explicit) {
    double largest = 0, unexplained = 0;
    for (const StepReport& step : steps) {
        largest = std::max({largest, step.kinetic, step.bending, step.membrane, step.contact});
        unexplained = std::max(unexplained, std::abs(step.unexplained));
    }
    // Implicit Euler dissipates energy. Central differences neither dissipate nor add energy, which only
    // oscillates a little.
    EXPECT_GT(steps.back().lost_to_scheme, is_explicit ? -1e-3 * largest : 0);
    EXPECT_LT(unexplained, 1e-6 * largest);
}

// The scene must break into large fragments, not into dust.
void expect_shards(const Snapshot& last) {
    std::map<Index, std::size_t> faces;
    for (const Index fragment : last.face_fragment) ++faces[fragment];
    const auto single =
        std::count_if(faces.begin(), faces.end(), [](const auto& entry) { return entry.second == 1; });
    EXPECT_GE(faces.size(), 3u);
    EXPECT_LT(10 * static_cast<std::size_t>(single), last.faces.size());
    const auto large = std::count_if(faces.begin(), faces.end(), [&](const auto& entry) {
        return 100 * entry.second > last.faces.size();
    });
    EXPECT_GE(large, 3);
}

/// Shipped scene, and settings that make its run shorter.
struct ShippedScene {
    std::string name;
    std::string duration = {};        ///< s, of the test; empty: the scene's own
    std::string short_duration = {};  ///< s, of the short form of a long test; empty: the scene's own
    std::vector<std::string> settings = {};
};

/// Whether tests/long --short requests the short form.
bool is_short() {
    return std::getenv("SHERD_SHORT") != nullptr;
}

void PrintTo(const ShippedScene& scene, std::ostream* stream) {
    *stream << scene.name;
}

class WholeScene : public ::testing::TestWithParam<ShippedScene> {};

TEST_P(WholeScene, KeepsEveryLawInEveryFrame) {
    const test::TemporaryDirectory directory;
    const std::filesystem::path scene_file = scenes / (GetParam().name + ".toml");
    std::vector<std::string> command{"run", scene_file.string(), "-o", "run.h5"};
    for (const std::string& setting : GetParam().settings) command.insert(command.end(), {"--set", setting});
    const std::string duration = is_short() ? GetParam().short_duration : GetParam().duration;
    if (!duration.empty()) command.insert(command.end(), {"--set", "duration=" + duration});
    const auto result = test::run_sherd(command, directory.path);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const Recording recording(directory.path / "run.h5");
    const Snapshot first = recording.frame(0);
    for (std::size_t i = 0; i < recording.frame_count(); ++i) {
        SCOPED_TRACE("frame " + std::to_string(i));
        const Snapshot frame = recording.frame(i);
        expect_manifold(frame);
        expect_no_intersection(frame);
        EXPECT_EQ(test::faces_in_obstacles(frame, recording.obstacles(), recording.poses(i)), 0u)
            << "an obstacle passes through faces";
        expect_same_matter(frame, first);
        expect_corner_rule(frame);
    }
    if (GetParam().name == "plate_drop") expect_shards(recording.frame(recording.frame_count() - 1));
    const Scene scene = read_scene(scene_file);
    const std::vector<StepReport> steps = recording.steps();
    if (scene.sheets.front().pins.empty() && scene.simulation.stepper.shell.damping.mass == 0 &&
        scene.bodies.empty())
        expect_momentum(steps, first.mass.sum(), scene.simulation.stepper.gravity);
    const bool is_explicit = scene.simulation.stepper.scheme == Scheme::explicit_differences;
    if (!is_explicit &&
        std::none_of(scene.obstacles.begin(), scene.obstacles.end(),
                     [](const ObstacleSpec& obstacle) { return !obstacle.motion.keys.empty(); }))
        expect_no_energy_from_nowhere(steps);
    expect_balance(steps, is_explicit);
    const double thickness = scene.sheets.front().material.thickness;
    for (const StepReport& step : steps) {
        EXPECT_LT(step.crack_face_overlap, 0.1 * thickness) << "step " << step.step;
        EXPECT_LT(step.obstacle_overlap, 0.5 * thickness)
            << "a vertex is in an obstacle at step " << step.step;
    }
}

std::string name_of(const testing::TestParamInfo<ShippedScene>& scene) {
    return scene.param.name;
}

// Long scenes are shortened, or have coarser meshes. tests/benchmarks/contact_table.py runs them to their
// end.
INSTANTIATE_TEST_SUITE_P(Breaking, WholeScene,
                         testing::Values(ShippedScene{"plate_drop"},
                                         ShippedScene{"bowl_on_anvil", "0.008", "0.008"}),
                         name_of);
INSTANTIATE_TEST_SUITE_P(BreakingLong, WholeScene,
                         testing::Values(ShippedScene{"bowl_drop", "", "0.01"},
                                         ShippedScene{"plate_stack", "0.015", "0.008"},
                                         ShippedScene{"shards_in_box", "0.02", "0.01"},
                                         ShippedScene{"window_ball", "0.0012", "3e-4"}),
                         name_of);
INSTANTIATE_TEST_SUITE_P(
    Long, WholeScene,
    testing::Values(ShippedScene{"sheet_hang", "", "0.4"}, ShippedScene{"drape", "0.2", "0.1"},
                    ShippedScene{"crumple", "0.4", "0.1", {"sheet.tube.mesh.edge_length=0.01"}}),
    name_of);

}  // namespace
}  // namespace sherd
