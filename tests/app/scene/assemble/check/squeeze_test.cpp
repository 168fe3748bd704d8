// SPDX-License-Identifier: GPL-3.0-or-later
// When the gap between rigid tools became smaller than the thickness of a foil of 1 g between them, they once
// did 200 J of work on it, without a message.
#include "app/scene/assemble/check/squeeze.h"

#include <gtest/gtest.h>

#include "app/scene/assemble/built_scene.h"
#include "app/scene/read/scene.h"
#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

/// Scene of a sheet, 1 mm thick, at z = 0, which is held at its rim.
const std::string held = R"(duration = 0.1
[sheet.foil]
mesh = { generate = "rectangle", width = 0.1, height = 0.1, edge_length = 0.02 }
place = { translate = [-0.05, -0.05, 0] }
material = { preset = "paper", thickness = 0.001 }
pin = { boundary = true }
)";

/// Keys of a motion by `way`, m, until 0.05 s, and back until 0.1 s.
std::string keys(const std::string& way) {
    return "motion = \"linear\"\nkeys = [{ time = 0 }, { time = 0.05, translate = " + way +
           " }, { time = 0.1 }]\n";
}

std::string upper(const std::string& shape, const std::string& way) {
    return "[obstacle.upper]\n" + shape + "\n" + keys(way);
}

std::string lower(const std::string& shape, const std::string& way = "") {
    return "[obstacle.lower]\n" + shape + "\n" + (way.empty() ? "" : keys(way));
}

SqueezedSheets squeezed(const std::string& text, const std::filesystem::path& folder = {}) {
    const TemporaryDirectory directory;
    const Scene scene =
        read_scene(folder.empty() ? directory.write("scene.toml", text) : folder / "scene.toml");
    std::vector<std::string> ignored;
    const BuiltScene built = build_scene(scene, ignored);
    return squeezed_sheets(scene, built.inputs, built.options.stepper.contact.obstacles);
}

void expect_squeeze(const std::string& text, const std::string& gap) {
    const SqueezedSheets found = squeezed(text);
    ASSERT_EQ(found.certain.size(), 1U) << text;
    EXPECT_TRUE(found.possible.empty());
    const std::string& words = found.certain.front();
    for (const std::string& part : {std::string("obstacle.upper"), std::string("obstacle.lower"),
                                    "and to " + gap + " m at 0.05 s; sheet.foil, which is between them"})
        EXPECT_NE(words.find(part), std::string::npos) << part << "\n" << words;
}

void expect_room(const std::string& text) {
    const SqueezedSheets found = squeezed(text);
    for (const auto* all : {&found.certain, &found.possible})
        for (const std::string& words : *all) ADD_FAILURE() << text << "\n" << words;
}

const std::string ball_above = "sphere = { radius = 0.01, centre = [0.003, 0.002, 0.02] }",
                  ball_below = "sphere = { radius = 0.01, centre = [0.003, 0.002, -0.02] }",
                  floor_below = "plane = { point = [0, 0, -0.01] }";

TEST(Squeeze, ToolsOfEachKindAreNamedWithTheirGap) {
    expect_squeeze(held + upper(ball_above, "[0, 0, -0.0098]") + lower(ball_below, "[0, 0, 0.0098]"),
                   "0.0004");
    expect_squeeze(held + upper(ball_above, "[0, 0, -0.0195]") + lower(floor_below), "0.0005");
    expect_squeeze(
        held + upper("box = { size = [0.02, 0.02, 0.02], centre = [0, 0, 0.02] }", "[0, 0, -0.0195]") +
            lower(floor_below),
        "0.0005");
    expect_squeeze(
        held + upper("box = { size = [0.2, 0.005, 0.02], centre = [0, 0, 0.02] }", "[0, 0, -0.0097]") +
            lower("box = { size = [0.005, 0.2, 0.02], centre = [0, 0, -0.02] }", "[0, 0, 0.0097]"),
        "0.0006");
    expect_squeeze(held + upper("plane = { point = [0, 0, 0.01], normal = [0, 0, -1] }", "[0, 0, -0.012]") +
                       lower(floor_below, "[0, 0, 0.0075]"),
                   "0.0005");
    expect_squeeze(
        held +
            upper("cylinder = { radius = 0.01, length = 0.05, axis = [1, 0, 0], centre = [0, 0, 0.02] }",
                  "[0, 0, -0.025]") +
            lower(floor_below),
        "-0.005");
}

TEST(Squeeze, AMeshIsATool) {
    const TemporaryDirectory directory;
    directory.write("wedge.obj",
                    "v 0 -0.02 0\nv 0 0.02 0\nv 0.01 -0.02 0.02\nv 0.01 0.02 0.02\n"
                    "v -0.01 -0.02 0.02\nv -0.01 0.02 0.02\n"
                    "f 1 2 4\nf 1 4 3\nf 1 5 6\nf 1 6 2\nf 3 4 6\nf 3 6 5\nf 1 3 5\nf 2 6 4\n");
    directory.write("scene.toml",
                    held + upper("mesh = \"wedge.obj\"\nplace.translate = [0, 0, 0.01]", "[0, 0, -0.0196]") +
                        lower(floor_below));
    const SqueezedSheets found = squeezed("", directory.path);
    ASSERT_EQ(found.certain.size(), 1U);
    EXPECT_NE(found.certain.front().find("obstacle.upper and obstacle.lower"), std::string::npos);
}

TEST(Squeeze, WithRoomOrNothingBetweenNothingIsSaid) {
    expect_room(held + upper(ball_above, "[0, 0, -0.019]") + lower(floor_below));
    const std::string aside = "sphere = { radius = 0.01, centre = [0.09, 0.2, 0.02] }";
    expect_room(held + upper(aside, "[0, 0, -0.025]") + lower(floor_below));
    // Two parts of one tool stay together.
    expect_room(held + upper("box = { size = [0.02, 0.02, 0.02], centre = [0, 0, 0.03] }", "[0, 0, -0.01]") +
                lower("box = { size = [0.01, 0.01, 0.1], centre = [0, 0, 0.09] }", "[0, 0, -0.01]"));
    // Both tools are on one side of the sheet.
    expect_room(held + upper("sphere = { radius = 0.01, centre = [0, 0, 0.06] }", "[0, 0, -0.019]") +
                lower("sphere = { radius = 0.01, centre = [0, 0, 0.02] }"));
}

// The press comes from the side after the sheet has fallen to the floor, so that the sheet may be between
// them, but need not be.
TEST(Squeeze, WhatTheSheetMayGetBetweenIsAWarning) {
    std::string falling = held;
    falling.replace(falling.find("pin = "), std::string("pin = { boundary = true }").size(),
                    "velocity = [0, 0, -3]");
    falling.replace(falling.find("-0.05, 0]"), 9, "-0.05, 0.1]");
    const std::string press =
        "[obstacle.press]\nbox = { size = [0.05, 0.05, 0.02], centre = [0.5, 0, 0.03] }\nkeys = [{ time = 0 "
        "}, "
        "{ time = 0.05 }, { time = 0.08, translate = [-0.5, 0, 0] }, { time = 0.1, translate = [-0.5, 0, "
        "-0.0296] }]\n[obstacle.floor]\nplane = { point = [0, 0, -0.01] }\n";
    const SqueezedSheets found = squeezed(falling + press);
    EXPECT_TRUE(found.certain.empty());
    ASSERT_EQ(found.possible.size(), 1U);
    EXPECT_NE(found.possible.front().find("if it gets between them, sheet.foil"), std::string::npos);
}

TEST(Squeeze, IsAnErrorOfCheckAndAWarningOfARun) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", held + upper(ball_above, "[0, 0, -0.0195]") + lower(floor_below) +
                                      "[solver]\nstep = 1e-3\n");
    const ProgramResult check = run_sherd({"check", "scene.toml"}, directory.path);
    EXPECT_EQ(check.exit_code, 2);
    EXPECT_NE(check.err.find("error: scene.toml:8: obstacle.upper.sphere: by their keys the gap"),
              std::string::npos)
        << check.err;
    const ProgramResult run = run_sherd({"run", "scene.toml", "--until", "1e-3"}, directory.path);
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_NE(run.err.find("warning: scene.toml:8: obstacle.upper.sphere: by their keys the gap"),
              std::string::npos)
        << run.err;
}

}  // namespace
}  // namespace sherd::test
