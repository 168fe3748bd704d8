// SPDX-License-Identifier: GPL-3.0-or-later
// Users would trust the values of a gauge that is at a wrong place.
#include <gtest/gtest.h>

#include "meshops/error.h"
#include "tests/support/program/built_text.h"
#include "tests/support/program/message_thrown_by.h"

namespace sherd::test {
namespace {

// Scene of two squares with sides of 1 m, one above the other.
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

TEST(SceneGauge, RecordsWhatItIsAskedFor) {
    const BuiltText prepared = built_from(squares + R"(
[[gauge]]
name = "all"
at = [0.3, 0.4, 0]
record = ["displacement", "stress", "curvature", "membrane_strain"]
[[gauge]]
name = "stress"
at = [0.3, 0.4, 0]
record = ["stress"]
[[gauge]]
name = "plain"
at = [0.3, 0.4, 0]
)");
    const std::vector<Gauge>& gauges = prepared.built.options.gauges;
    EXPECT_TRUE(gauges[0].displacement);
    EXPECT_EQ(gauges[0].fields, (FaceFieldChoice{true, true, true}));
    EXPECT_FALSE(gauges[1].displacement);
    EXPECT_EQ(gauges[1].fields, FaceFieldChoice{.stress = true});
    EXPECT_TRUE(gauges[2].displacement);
    EXPECT_FALSE(gauges[2].fields.any());
}

TEST(SceneFields, AreNoneUnlessTheSceneWantsThem) {
    const auto fields = [](const std::string& value) {
        return built_from(squares + (value.empty() ? "" : "[output]\nfields = " + value))
            .built.options.fields;
    };
    EXPECT_FALSE(fields("").any());
    EXPECT_FALSE(fields("false").any());
    EXPECT_EQ(fields("true"), (FaceFieldChoice{true, true, true}));
    EXPECT_EQ(fields("[\"curvature\", \"stress\"]"), (FaceFieldChoice{.stress = true, .curvature = true}));
    for (const std::string wrong : {"\"stress\"", "[\"stres\"]", "3"}) {
        const std::string message = message_thrown_by([&] { fields(wrong); });
        EXPECT_NE(message.find("output.fields: must be"), std::string::npos) << message;
    }
}

// The message must name the wrong word, since the list of fields may be long, and all that is allowed.
TEST(SceneFields, AWrongWordIsNamedWithTheNearestOne) {
    const auto says = [](const std::string& fields, const std::string& wanted) {
        const std::string message =
            message_thrown_by([&] { built_from(squares + "[output]\nfields = " + fields); });
        EXPECT_NE(message.find("output.fields: must be an array of one or more of \"stress\""),
                  std::string::npos)
            << message;
        EXPECT_NE(message.find("each once, or true or false, not " + wanted), std::string::npos) << message;
    };
    says("\"stress\"", "the string \"stress\"; did you mean [\"stress\"]?");
    says("\"stres\"", "the string \"stres\"; did you mean [\"stress\"]?");
    says("[\"stres\"]", "an array with the string \"stres\"; did you mean \"stress\"?");
    says("[\"stress\", \"stress\"]", "an array with the string \"stress\" twice");
    says("[\"stress\", 3]", "an array with 3");
    says("[]", "an array of 0");
    says("3", "3");
}

TEST(SceneGauge, WhatCannotBeIsRefused) {
    const auto says = [](const std::string& keys, const std::string& wanted) {
        const std::string message = message_thrown_by([&] { built_from(squares + "[[gauge]]\n" + keys); });
        EXPECT_NE(message.find(wanted), std::string::npos) << message;
    };
    says("name = \"g\"\nat = [0, 0, 0.5]\n", "gauge[0].at: is 0.5 m from the nearest point of any sheet");
    says("name = \"g\"\nat = [0, 0, 0]\nsheet = \"b\"\n", "is 1 m from the nearest point of sheet.b");
    says("name = \"g\"\nat = [0, 0, 0]\nsheet = \"c\"\n", "gauge[0].sheet: names no sheet");
    says("name = \"a/b\"\nat = [0, 0, 0]\n", "gauge[0].name: names a group of the recording");
    says("at = [0, 0, 0]\n", "gauge[0].name: is missing");
    says("name = \"g\"\n", "gauge[0].at: is missing");
    says("name = \"g\"\nat = [0, 0, 0]\nrecord = [\"strain\"]\n",
         "gauge[0].record: must be an array of one or more of \"displacement\", \"stress\"");
    says("name = \"g\"\nat = [0, 0, 0]\nrecord = [\"stress\", \"stress\"]\n",
         "with the string \"stress\" twice");
    says("name = \"g\"\nat = [0, 0, 0]\n[[gauge]]\nname = \"g\"\nat = [0, 0, 0]\n",
         "gauge[1].name: \"g\" is the name of another gauge already");
}

}  // namespace
}  // namespace sherd::test
