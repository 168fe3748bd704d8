// SPDX-License-Identifier: GPL-3.0-or-later
// Statics serve for verification and design: users need the load at which a deflection or the first crack
// occurs.
#include <gtest/gtest.h>

#include "meshops/error.h"
#include "tests/support/program/built_text.h"
#include "tests/support/program/message_thrown_by.h"

namespace sherd::test {
namespace {

/// Cantilever of 10 m by 1 m under an end load of 4 N (Sze, Liu, Lo 2004).
const std::string cantilever = R"(
[sheet.strip]
mesh = { generate = "rectangle", width = 10, height = 1, edge_length = 0.5 }
material = { density = 1, thickness = 0.1, young = 1.2e6, poisson = 0 }
clamp = { box = [[-1, -1, -1], [1e-6, 2, 1]] }
[[gauge]]
name = "tip"
at = [10, 0.5, 0]
[[force.load]]
line = [0, 0, 4]
box = [[9.9999, -1, -1], [11, 2, 1]]
[force]
gravity = [0, 0, 0]
[contact]
sheets = false
[solver]
scheme = "static"
bending = "coupled"
max_iterations = 100
)";

TEST(Statics, ReachLargeDeflectionsUnderTheirLoad) {
    const auto run = simulation_of(cantilever + "step = 0.1");
    StepReport report;
    while (run->time() < 1) {
        report = run->step();
        EXPECT_NEAR(report.load, report.time, 1e-12);
        EXPECT_EQ(report.kinetic, 0);
        EXPECT_NEAR(report.reactions[0].force.z(), -4 * report.load, 1e-3);
        if (std::abs(report.load - 0.4) < 1e-9) {
            EXPECT_NEAR(report.gauges[0].displacement.z(), 4.292, 0.01);
        }
    }
    EXPECT_NEAR(report.gauges[0].displacement.x(), -3.286, 0.01);
    EXPECT_NEAR(report.gauges[0].displacement.z(), 6.698, 0.01);
    EXPECT_FALSE(run->arrived()) << "that is for paths and cracks";
}

// The path must end exactly at the load, whatever the steps, and at the equilibrium that load control finds.
TEST(Statics, APathEndsAtTheSameEquilibrium) {
    const auto run = simulation_of(cantilever + "step = 0.13\narc_length = true");
    StepReport report;
    report.load = 0;
    for (int i = 0; i < 100 && !run->arrived(); ++i) {
        const double before = report.load;
        report = run->step();
        EXPECT_GT(report.load, before);
    }
    EXPECT_EQ(report.load, 1);
    EXPECT_NEAR(report.gauges[0].displacement.x(), -3.286, 0.01);
    EXPECT_NEAR(report.gauges[0].displacement.z(), 6.698, 0.01);
}

// A plate hangs by one end: its strain is proportional to the load, so that the load at the first crack is
// known.
TEST(Statics, TheLoadAtTheFirstCrackIsFound) {
    const std::string plate = R"([sheet.plate]
mesh = { generate = "rectangle", width = 1, height = 0.5, edge_length = 0.1 }
material = { density = 1000, thickness = 0.01, young = 1e9, poisson = 0 }
clamp = { box = [[-1, -1, -1], [1e-6, 2, 1]] }
[force]
gravity = [1, 0, 0]
[solver]
scheme = "static"
load = 1e4
step = 100
)";
    const double peak = simulation_of(plate)->step().peak_stress / 100;
    ASSERT_GT(peak, 0);
    const auto run = simulation_of(
        plate + "until_crack = true\n[sheet.plate.fracture]\nstrength = " + std::to_string(1234.567 * peak));
    StepReport report;
    while (!run->arrived()) report = run->step();
    EXPECT_NEAR(report.load, 1234.567, 1e-2 * 1234.567);
    EXPECT_GE(report.peak_overload, 1);
    EXPECT_LT(report.peak_overload, 1.001);
    EXPECT_FALSE(run->take_events().failures.empty());
}

TEST(Statics, PinsMoveWithTheLoadFactor) {
    const auto run = simulation_of(R"([sheet.strip]
mesh = { generate = "rectangle", width = 1, height = 0.2, edge_length = 0.1 }
material = { density = 1, thickness = 0.01, young = 1e6, poisson = 0 }
[[sheet.strip.pin]]
box = [[-1, -1, -1], [1e-6, 2, 1]]
[[sheet.strip.pin]]
box = [[0.9999, -1, -1], [2, 2, 1]]
keys = [{ time = 0 }, { time = 1, translate = [1e-3, 0, 0] }]
[force]
gravity = [0, 0, 0]
[solver]
scheme = "static"
step = 0.5
)");
    for (const double share : {0.5, 1.0}) {
        const double tension = 1e6 * 0.01 * 0.2 * 1e-3 * share;
        const StepReport report = run->step();
        EXPECT_NEAR(report.reactions[1].force.x(), tension, 2e-3 * tension) << share;
        EXPECT_NEAR(report.reactions[0].force.x(), -tension, 2e-3 * tension);
    }
}

// Keys that need time, and missing keys that statics need, must be reported: otherwise results would be wrong
// without a message.
TEST(Statics, RefuseWhatNeedsTime) {
    const auto message = [](const std::string& text) { return message_thrown_by([&] { built_from(text); }); };
    const std::string loose = R"([sheet.plate]
mesh = { generate = "rectangle", width = 1, height = 1, edge_length = 0.2 }
material = { density = 1, thickness = 0.01, young = 1e6, poisson = 0 }
)";
    const std::string held = loose + "pin = { box = [[-1, -1, -1], [0.1, 2, 1]] }\n";
    const std::string scheme = "[solver]\nscheme = \"static\"\n";
    EXPECT_NE(message(loose + scheme).find("nothing holds it"), std::string::npos);
    EXPECT_NE(message("duration = 1\n" + held + scheme).find("solver.load"), std::string::npos);
    EXPECT_NE(message(held + "velocity = [1, 0, 0]\n" + scheme).find("velocity"), std::string::npos);
    EXPECT_NE(message(held + "[force.wind]\nvelocity = [1, 0, 0]\n" + scheme).find("wind is not"),
              std::string::npos);
    EXPECT_NE(message(held + "[[force.load]]\npressure = 1\nramp = 1\n" + scheme).find("ramp"),
              std::string::npos);
    EXPECT_NE(message(held + scheme + "damping.mass = 1\n").find("damping is not"), std::string::npos);
    EXPECT_NE(message(held + scheme + "longest_path = 3\n").find("arc_length = true"), std::string::npos);
    EXPECT_NE(message("duration = 1\n" + held + "[solver]\nload = 2\n").find("scheme"), std::string::npos);
    EXPECT_NE(message(held + scheme + "load = 0.5\nstep = 0.6\n").find("longer than load"),
              std::string::npos);
    EXPECT_NE(message(held + scheme + "step = 0.3\narc_length = true\n[force]\ngravity = [0, 0, 0]\n")
                  .find("needs a load"),
              std::string::npos);
}

// A sheet that can move as a whole has no equilibrium, and must give a message instead of flying away.
TEST(Statics, SayWhatIsNotHeld) {
    const auto run = simulation_of(R"([sheet.plate]
mesh = { generate = "rectangle", width = 1, height = 1, edge_length = 0.2 }
material = { density = 1, thickness = 0.01, young = 1e6, poisson = 0 }
symmetry = { point = [0, 0, 0], normal = [1, 0, 0] }
[solver]
scheme = "static"
)");
    const std::string message = message_thrown_by([&] { run->step(); });
    EXPECT_NE(message.find("load 0"), std::string::npos) << message;
    EXPECT_TRUE(message.find("nothing holds") != std::string::npos ||
                message.find("as a whole") != std::string::npos)
        << message;
}

}  // namespace
}  // namespace sherd::test
