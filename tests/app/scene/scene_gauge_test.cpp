// SPDX-License-Identifier: GPL-3.0-or-later
// A gauge at the wrong place would be believed.
#include <gtest/gtest.h>

#include "meshops/error.h"
#include "tests/support/built_text.h"
#include "tests/support/thrown_by.h"

namespace sherd::test {
namespace {

// Two squares of 1 m side, one above the other.
const std::string squares = R"(duration = 1
[sheet.a]
mesh = { generate = "rectangle", width = 1, height = 1, edge_length = 0.25 }
material = { density = 1000, thickness = 0.01, young = 1e8, poisson = 0 }
velocity = [1, 2, 3]
[sheet.b]
mesh = { generate = "rectangle", width = 1, height = 1, edge_length = 0.25 }
material = { density = 1000, thickness = 0.01, young = 1e8, poisson = 0 }
place = { translate = [0, 0, 1] }
[force]
gravity = [0, 0, 0]
)";

TEST(SceneGauge, ShowsTheDisplacementOfItsPoint) {
    BuiltText prepared = built_from(squares + R"(
[[gauge]]
name = "low"
at = [0.3, 0.4, 0.1]
[[gauge]]
name = "high"
sheet = "b"
at = [1.1, 0.5, 1]
[solver]
step = 1e-2
)");
    Simulation simulation(std::move(prepared.built.sheets), prepared.built.options);
    ASSERT_EQ(simulation.gauges().size(), 2u);
    EXPECT_LT((simulation.gauges()[0].place - Vector3d(0.3, 0.4, 0)).norm(), 1e-12);
    EXPECT_LT((simulation.gauges()[1].place - Vector3d(1, 0.5, 1)).norm(), 1e-12);
    simulation.step();
    const StepReport report = simulation.step();
    ASSERT_EQ(report.gauges.size(), 2u);
    EXPECT_LT((report.gauges[0].displacement - Vector3d(0.02, 0.04, 0.06)).norm(), 1e-9);
    EXPECT_LT(report.gauges[1].displacement.norm(), 1e-12);
}

TEST(SceneGauge, WhatCannotBeIsRefused) {
    const auto says = [](const std::string& keys, const std::string& wanted) {
        const std::string message = thrown_by([&] { built_from(squares + "[[gauge]]\n" + keys); });
        EXPECT_NE(message.find(wanted), std::string::npos) << message;
    };
    says("name = \"g\"\nat = [0, 0, 0.5]\n", "gauge[0].at: is 0.5 m from the nearest point of any sheet");
    says("name = \"g\"\nat = [0, 0, 0]\nsheet = \"b\"\n", "is 1 m from the nearest point of sheet.b");
    says("name = \"g\"\nat = [0, 0, 0]\nsheet = \"c\"\n", "gauge[0].sheet: names no sheet");
    says("name = \"a/b\"\nat = [0, 0, 0]\n", "gauge[0].name: names a group of the recording");
    says("at = [0, 0, 0]\n", "gauge[0].name: is missing");
    says("name = \"g\"\n", "gauge[0].at: is missing");
    says("name = \"g\"\nat = [0, 0, 0]\n[[gauge]]\nname = \"g\"\nat = [0, 0, 0]\n",
         "gauge[1].name: \"g\" is the name of another gauge already");
}

}  // namespace
}  // namespace sherd::test
