// SPDX-License-Identifier: GPL-3.0-or-later
// A dense scan that is many edges thick has so many contact pairs that they would fill the memory until the
// system kills the program.
#include "app/scene/assemble/start/contact_pairs.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "app/scene/assemble/sheet/sheet.h"
#include "app/scene/read/scene.h"
#include "meshops/error.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

/// Message with which the scene is refused; empty if it is accepted.
std::string refusal(double thickness, const std::string& contact) {
    const TemporaryDirectory directory;
    const Scene scene = read_scene(directory.write(
        "scene.toml",
        fmt::format("duration = 0.1\n{}[sheet.scan]\nmesh = {{ generate = \"rectangle\", width = 0.2, "
                    "height = 0.2, edge_length = 0.001 }}\nmaterial = {{ preset = \"glass\", "
                    "thickness = {} }}\n",
                    contact, thickness)));
    std::vector<std::string> warnings;
    const std::vector<SheetInput> inputs{make_sheet(scene.sheets[0], scene, warnings)};
    try {
        require_few_pairs(scene, inputs);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(ContactPairs, FarShorterEdgesThanTheThicknessAreAnErrorThatSaysWhatToDo) {
    const std::string error = refusal(0.01, "");
    EXPECT_NE(error.find("scene.toml:3: sheet.scan.mesh: sheet.scan has edges of 0.001"), std::string::npos)
        << error;
    EXPECT_NE(error.find("`remesh = 0.01`"), std::string::npos) << error;
}

TEST(ContactPairs, WhatCanBeWatchedIsNotRefused) {
    EXPECT_EQ(refusal(0.002, ""), "");
    EXPECT_EQ(refusal(0.01, "contact.sheets = false\n"), "");
}

}  // namespace
}  // namespace sherd::test
