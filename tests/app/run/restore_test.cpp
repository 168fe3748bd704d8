// SPDX-License-Identifier: GPL-3.0-or-later
// If the state lacked a member, or did not restore a member as it was, a resumed run would have other bits.
#include <gtest/gtest.h>

#include <map>
#include <sstream>

#include "app/run/state_archive.h"
#include "app/scene/assemble/built_scene.h"
#include "app/scene/read/scene.h"
#include "meshops/error.h"
#include "tests/support/recording/same_report.h"

namespace sherd::test {
namespace {

/// Scene of a disc that falls onto the floor, followed by a ball, with the keys `solver` in its table
/// [solver].
std::string stepped_disc(const std::string& duration, const std::string& solver) {
    return "duration = " + duration + R"(
[sheet.plate]
mesh = { generate = "disc", radius = 0.1, edge_length = 0.02 }
place = { translate = [0, 0, 0.0175], rotate = { axis = [0, 1, 0], degrees = 9 } }
velocity = [0, 0, -5]
material = { preset = "stoneware" }
fracture = { strain = 0.3 }
[obstacle.floor]
plane = {}
friction = 0.3
[obstacle.ball]
sphere = { radius = 0.01, centre = [0, 0, 0.06] }
density = 7850
velocity = [0, 0, -5]
[solver]
)" + solver;
}

const std::map<std::string, std::string> scenes{
    {"strength", R"(duration = 0.004
[sheet.plate]
mesh = { generate = "plate", radius = 0.1, edge_length = 0.016 }
place = { translate = [0, 0, 0.04], rotate = { axis = [1, 0, 0], degrees = 20 } }
velocity = [0, 0, -6]
material = { preset = "stoneware", axis = { direction = [1, 0, 0] } }
fracture = { strain = 0.3, weibull = 8 }
[obstacle.floor]
plane = {}
friction = 0.3
[obstacle.die]
box = { size = [0.02, 0.02, 0.02], centre = [0.01, 0.01, 0.0601] }
density = 2500
[contact]
friction = 0.2
[solver]
step = 1e-4
)"},
    {"paper's rule", R"(duration = 0.006
[sheet.plate]
mesh = { generate = "plate", radius = 0.1, edge_length = 0.016 }
place = { translate = [0, 0, 0.04], rotate = { axis = [1, 0, 0], degrees = 20 } }
velocity = [0, 0, -6]
material = { preset = "stoneware" }
fracture = { strain = 0.1, measure = "bending" }
[obstacle.floor]
plane = {}
[solver]
step = 1e-4
bending = "nonlinear"
jacobian = "cubic"
rule = "paper"
)"},
    {"toughness", R"(duration = 0.002
[sheet.pane]
mesh = { generate = "rectangle", width = 0.2, height = 0.2, edge_length = 0.02 }
place = { translate = [-0.1, -0.1, 0] }
clamp = { boundary = true }
material = { preset = "glass" }
fracture = { strength = 4e7, toughness = 5e5 }
[obstacle.ball]
sphere = { radius = 0.02, centre = [0.013, 0.008, 0.0225] }
density = 7850
velocity = [0, 0, -10]
[force.wind]
velocity = [5, 0, 0]
gust = { amplitude = 2, time = 0.001, length = 0.1 }
[[force.load]]
pressure = 200
[[gauge]]
name = "middle"
at = [0.02, 0.03, 0]
record = ["displacement", "stress"]
[solver]
step = 5e-5
)"},
    {"explicit", R"(duration = 2.4e-4
[sheet.pane]
mesh = { generate = "rectangle", width = 0.2, height = 0.2, edge_length = 0.016 }
place = { translate = [-0.1, -0.1, 0] }
clamp = { boundary = true }
material = { preset = "glass" }
fracture = { strength = 4e7, toughness = 5e5 }
[obstacle.ball]
sphere = { radius = 0.02, centre = [0.013, 0.008, 0.0225] }
density = 7850
velocity = [0, 0, -12]
[solver]
scheme = "explicit"
step = 2e-6
damping.stiffness = 2e-8
)"},
    {"schemes by turns", stepped_disc("0.002", "scheme = \"auto\"\ndamping.stiffness = 1e-7\n")},
    {"bdf two", stepped_disc("0.006", "scheme = \"bdf2\"\n")},
    {"arcs, damping and moving clamps", R"(duration = 0.02
[sheet.strip]
mesh = { generate = "rectangle", width = 0.3, height = 0.1, edge_length = 0.03 }
material = { density = 1100, thickness = 0.002, young = 1e6, poisson = 0.4 }
clamp = { box = [[-1, -1, -1], [0.001, 1, 1]], keys = [{ time = 0 }, { time = 0.02, rotate = { axis = [0, 1, 0], degrees = 20 } }] }
symmetry = { point = [0, 0, 0], normal = [0, 1, 0] }
[solver]
step = 1e-3
membrane = "arc"
damping = { stiffness = 1e-4, mass = 1 }
)"},
    {"path of equilibria", R"([sheet.roof]
mesh = { generate = "rectangle", width = 0.2, height = 0.2, edge_length = 0.04 }
bend = { curvature = 1 }
pin = { boundary = true }
material = { density = 1100, thickness = 0.002, young = 1e6, poisson = 0.4 }
[[force.load]]
point = [0, 0, -3]
box = [[0.08, 0.08, -1], [0.12, 0.12, 1]]
[solver]
scheme = "static"
arc_length = true
longest_path = 2
step = 0.0025
)"},
    {"overlap at the start", R"(duration = 0.01
[sheet.one]
mesh = { generate = "disc", radius = 0.1, edge_length = 0.03 }
place = { translate = [0, 0, -0.0005] }
material = { density = 1100, thickness = 0.002, young = 1e6, poisson = 0.4 }
[sheet.other]
mesh = { generate = "disc", radius = 0.1, edge_length = 0.03 }
place = { translate = [0.01, 0, 0], rotate = { axis = [0, 1, 0], degrees = 4 } }
velocity = [0, 0, 1]
material = { density = 1100, thickness = 0.002, young = 1e6, poisson = 0.4 }
[obstacle.floor]
plane = {}
[solver]
step = 5e-4
)"},
};

BuiltScene built(const std::string& name) {
    std::vector<std::string> warnings;
    return build_scene(parse_scene(scenes.at(name), "scene.toml"), warnings);
}

Simulation simulation_of(const std::string& name) {
    BuiltScene scene = built(name);
    return {std::move(scene.sheets), scene.options};
}

struct Step {
    StepReport report;
    CrackEvents events;
};

Step step_of(Simulation& simulation) {
    Step step{simulation.step(), {}};
    step.events = simulation.take_events();
    return step;
}

void expect_same_snapshot(const Simulation& one, const Simulation& other) {
    const Snapshot a = one.snapshot(), b = other.snapshot();
    EXPECT_TRUE(same(a.position, b.position) && same(a.velocity, b.velocity) && same(a.mass, b.mass));
    EXPECT_TRUE(same(a.rest.position, b.rest.position) && a.faces == b.faces && a.edges == b.edges);
    EXPECT_TRUE(a.face_fragment == b.face_fragment && a.edge_state == b.edge_state);
    EXPECT_TRUE(same(a.edge_strain, b.edge_strain) && same(a.edge_cohesive_share, b.edge_cohesive_share));
}

class Restore : public testing::TestWithParam<std::string> {};

/// At every fourth step the state is restored into a new simulation, which then makes the next four steps,
/// too: both simulations must agree.
TEST_P(Restore, StateGoesOnBitForBit) {
    const double duration = parse_scene(scenes.at(GetParam()), "scene.toml").duration;
    Simulation whole = simulation_of(GetParam());
    std::unique_ptr<Simulation> other;
    std::size_t failures = 0;
    int steps = 0;
    for (; whole.time() < 0.999 * duration && !whole.arrived(); ++steps) {
        if (steps % 4 == 1) {
            std::ostringstream text;
            StateWriter{text}(whole);
            other = std::make_unique<Simulation>(built(GetParam()).sheets, built(GetParam()).options);
            StateReader reader(text.view());
            reader(*other);
            reader.finish();
            expect_same_snapshot(whole, *other);
        }
        const Step one = step_of(whole);
        failures += one.events.failures.size();
        if (!other) continue;
        const Step same_step = step_of(*other);
        expect_same(one.report, same_step.report);
        expect_same(one.events, same_step.events);
        expect_same_snapshot(whole, *other);
        ASSERT_FALSE(HasFailure()) << "step " << steps + 1;
    }
    EXPECT_GT(steps, 8);
    const bool breaks = scenes.at(GetParam()).find("fracture") != std::string::npos;
    EXPECT_EQ(failures > 4, breaks) << failures;
}

INSTANTIATE_TEST_SUITE_P(BreakingScenes, Restore, testing::ValuesIn([] {
                             std::vector<std::string> names;
                             for (const auto& [name, text] : scenes) names.push_back(name);
                             return names;
                         }()),
                         [](const auto& name) {
                             std::string plain;
                             for (const char c : name.param)
                                 if (std::isalpha(static_cast<unsigned char>(c))) plain += c;
                             return plain;
                         });

// A state that is truncated, or that belongs to another scene, must be refused.
TEST(StateArchive, RefusesWhatIsCutOffAndWhatIsOfSomethingElse) {
    Simulation whole = simulation_of("strength");
    std::ostringstream stream;
    StateWriter{stream}(whole);
    const std::string state = stream.str();
    const auto read = [](Simulation into, std::string_view text) {
        StateReader reader(text);
        reader(into);
        reader.finish();
    };
    EXPECT_THROW(read(simulation_of("strength"), std::string_view(state).substr(0, 10000)), Error);
    EXPECT_THROW(read(simulation_of("strength"), state + "x"), Error);
    EXPECT_THROW(read(simulation_of("explicit"), state), std::exception);
}

}  // namespace
}  // namespace sherd::test
