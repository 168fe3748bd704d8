// SPDX-License-Identifier: GPL-3.0-or-later
// Sheets that touch, except for the rounding of a modelling program, must run, but must not be moved visibly.
#include "app/scene/assemble/start/sheet_separation.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/scene/assemble/sheet/sheet.h"
#include "app/scene/read/scene.h"
#include "fracture/shell/start_overlaps.h"
#include "meshops/error.h"
#include "meshops/mesh_measures.h"
#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

constexpr double thickness = 0.01;  // m

/// Scene text of a square sheet with sides of 1 m, 1 cm thick, at `place`.
std::string square(const std::string& name, const std::string& place, const std::string& more = "") {
    return fmt::format(
        "[sheet.{}]\nmesh = {{ generate = \"rectangle\", width = 1, height = 1, edge_length = 0.25 }}\n"
        "place = {{ {} }}\nmaterial = {{ density = 1000, thickness = {}, young = 1e8, poisson = 0 }}\n{}\n",
        name, place, thickness, more);
}

std::string at_height(double z) {
    return fmt::format("translate = [0.1, 0.05, {}]", z);
}

struct Parted {
    std::vector<double> moved;  ///< displacement of each sheet, upwards, m
    std::vector<std::string> warnings;
    std::string error;
    bool apart = false;
};

const std::string strict = "contact.start = \"error\"\n";

Parted parted(const std::string& sheets, const std::string& head = "", const std::string& contact = strict) {
    const TemporaryDirectory directory;
    const Scene scene =
        read_scene(directory.write("scene.toml", "duration = 0.1\n" + head + contact + sheets));
    Parted result;
    std::vector<SheetInput> inputs;
    for (const SheetSpec& sheet : scene.sheets) inputs.push_back(make_sheet(sheet, scene, result.warnings));
    const std::vector<SheetInput> before = inputs;
    result.warnings.clear();
    BreakableShell all(inputs);
    try {
        separate_overlapping_sheets(scene, inputs, all, result.warnings);
    } catch (const Error& error) {
        result.error = error.what();
    }
    for (std::size_t s = 0; s < inputs.size(); ++s) {
        const Vector3d way = position(inputs[s].mesh, Vertex(0)) - position(before[s].mesh, Vertex(0));
        for (const Vertex v : inputs[s].mesh.vertices())
            EXPECT_LT((position(inputs[s].mesh, v) - position(before[s].mesh, v) - way).norm(), 1e-15)
                << "not moved as a whole";
        EXPECT_LT(way.head<2>().norm(), 1e-12);
        result.moved.push_back(way.z());
    }
    result.apart = start_overlaps(all).empty();
    EXPECT_TRUE(all.mechanics().rest == BreakableShell(inputs).mechanics().rest) << "not made anew";
    return result;
}

TEST(SheetParting, TouchingSheetsAreLeftAlone) {
    const Parted two = parted(square("a", at_height(0)) + square("b", at_height(0.995 * thickness)));
    EXPECT_EQ(two.error, "");
    EXPECT_TRUE(two.warnings.empty());
    EXPECT_EQ(two.moved, (std::vector<double>{0, 0}));
}

TEST(SheetParting, TheUpperOneIsLiftedWithAWarning) {
    for (const bool first_is_above : {false, true}) {
        const double other = (first_is_above ? -1 : 1) * 0.97 * thickness;
        const Parted two = parted(square("a", at_height(0)) + square("b", at_height(other)));
        EXPECT_EQ(two.error, "");
        EXPECT_TRUE(two.apart);
        EXPECT_NEAR(two.moved[first_is_above ? 0 : 1], 0.03 * thickness, 1e-9);
        EXPECT_EQ(two.moved[first_is_above ? 1 : 0], 0);
        ASSERT_EQ(two.warnings.size(), 1u);
        EXPECT_NE(two.warnings[0].find(first_is_above ? "sheet.a is moved" : "sheet.b is moved"),
                  std::string::npos)
            << two.warnings[0];
    }
}

// If only one sheet of a stack were lifted, it would be pressed into the next.
TEST(SheetParting, AStackIsPartedFromBelow) {
    const Parted three = parted(square("a", at_height(0)) + square("b", at_height(0.98 * thickness)) +
                                square("c", at_height(1.96 * thickness)));
    EXPECT_EQ(three.error, "");
    EXPECT_TRUE(three.apart);
    EXPECT_NEAR(three.moved[1], 0.02 * thickness, 1e-9);
    EXPECT_NEAR(three.moved[2], 0.04 * thickness, 1e-9);
    EXPECT_EQ(three.warnings.size(), 2u);
}

// A pinned sheet stays in its place; without gravity no sheet is the upper one.
TEST(SheetParting, WhatIsHeldStays) {
    const std::string pin = "pin = { boundary = true }";
    const double z = 0.97 * thickness;
    EXPECT_NEAR(parted(square("a", at_height(0)) + square("b", at_height(z), pin)).moved[0],
                -0.03 * thickness, 1e-9);
    EXPECT_NE(parted(square("a", at_height(0), pin) + square("b", at_height(z), pin)).error, "");
    EXPECT_NEAR(
        parted(square("a", at_height(z)) + square("b", at_height(0)), "force.gravity = [0, 0, 0]\n").moved[1],
        -0.03 * thickness, 1e-9);
}

// Sheets that would have to move visibly must be refused with the message about their distance, and stay in
// place.
TEST(SheetParting, MoreThanATwentiethOfTheThicknessIsRefused) {
    const Parted two = parted(square("a", at_height(0)) + square("b", at_height(0.94 * thickness)));
    EXPECT_NE(two.error.find(") m are 0.0094 m apart, less than 0.01 m"), std::string::npos) << two.error;
    EXPECT_EQ(two.moved, (std::vector<double>{0, 0}));
    const Parted crossing =
        parted(square("a", at_height(0)) +
               square("b", "translate = [0, 0.3, -0.5], rotate = { axis = [1, 0, 0], degrees = 90 }"));
    EXPECT_NE(crossing.error.find("cross or touch"), std::string::npos) << crossing.error;
}

// A sheet between two sheets that are held cannot be moved apart from both.
TEST(SheetParting, AWedgedSheetIsRefused) {
    const std::string pin = "pin = { boundary = true }";
    const Parted three = parted(square("a", at_height(0), pin) + square("b", at_height(0.98 * thickness)) +
                                square("c", at_height(1.96 * thickness), pin));
    EXPECT_NE(three.error.find("sheets overlap at the start"), std::string::npos) << three.error;
    EXPECT_EQ(three.moved, (std::vector<double>{0, 0, 0}));
}

// Without contact.start = "error" these sheets must run, with a warning that says what does not collide.
TEST(SheetParting, WhatCannotBePartedIsExemptByDefault) {
    const Parted crossing =
        parted(square("a", at_height(0)) +
                   square("b", "translate = [0, 0.3, -0.5], rotate = { axis = [1, 0, 0], degrees = 90 }"),
               "", "");
    EXPECT_EQ(crossing.error, "");
    EXPECT_TRUE(crossing.apart) << "what is exempt still overlaps";
    EXPECT_EQ(crossing.moved, (std::vector<double>{0, 0}));
    ASSERT_EQ(crossing.warnings.size(), 1u);
    EXPECT_NE(crossing.warnings[0].find("the former do not collide"), std::string::npos)
        << crossing.warnings[0];
    EXPECT_NE(crossing.warnings[0].find("cross or touch"), std::string::npos);
}

// For pictures the axes are made again from the scene, in which the sheets have not been moved.
TEST(SheetParting, AxesOfWhatWasMovedCanStillBeDrawn) {
    const TemporaryDirectory directory;
    const auto orthotropic = [](const std::string& name, double z) {
        std::string text = square(name, at_height(z));
        return text.replace(text.find("young = 1e8"), 11, "young = [1e8, 1e7]");
    };
    directory.write("scene.toml",
                    "duration = 1e-4\n" + orthotropic("a", 0) + orthotropic("b", 0.98 * thickness));
    const ProgramResult run = run_sherd({"run", "scene.toml", "-o", "run.h5"}, directory.path);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    ASSERT_NE(run.err.find("is moved"), std::string::npos) << run.err;
    const ProgramResult drawn = run_sherd(
        {"render", "run.h5", "-o", "axis.png", "--color", "axis", "--size", "32x24", "--samples", "1"},
        directory.path);
    EXPECT_EQ(drawn.exit_code, 0) << drawn.err;
}

}  // namespace
}  // namespace sherd::test
