// SPDX-License-Identifier: GPL-3.0-or-later
// Groups of a mesh file through the real program: otherwise a run would hold or load the wrong part of a
// mesh.
#include <gtest/gtest.h>

#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

// Two squares side by side, with a common edge, in two groups.
const std::string strip =
    "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\no strip\ng handle\nf 1 2 5 4\ng blade\nf 2 3 6 "
    "5\n";

/// Runs `command` on a scene of the strip. sheet: lines for the table of the sheet; behind: lines for the end
/// of the scene.
ProgramResult outcome(const std::string& command, const std::string& sheet, const std::string& behind = "",
                      const std::string& mesh = "\"strip.obj\"") {
    const TemporaryDirectory directory;
    directory.write("strip.obj", strip);
    directory.write("scene.toml", "duration = 2e-3\n[sheet.strip]\nmesh = " + mesh +
                                      "\nmaterial = { density = 1000, thickness = 0.01, young = 1e8 }\n" +
                                      sheet + "\n[solver]\nstep = 1e-3\n" + behind);
    std::vector<std::string> arguments{command, "scene.toml"};
    if (command == "run") arguments.insert(arguments.end(), {"-o", "out.h5"});
    return run_sherd(arguments, directory.path);
}

void expect_refused(const ProgramResult& result, const std::string& message) {
    EXPECT_EQ(result.exit_code, 2) << result.out;
    EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
}

TEST(SceneGroup, PinsHoldTheVerticesOfTheGroup) {
    for (const auto& [group, count] :
         {std::pair("handle", "4"), std::pair("blade", "4"), std::pair("strip", "6")}) {
        const ProgramResult result = outcome("check", "pin = { group = \"" + std::string(group) + "\" }");
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_NE(result.out.find("pinned vertices " + std::string(count) + "\n"), std::string::npos)
            << result.out;
    }
}

TEST(SceneGroup, ClampsAndLoadsTakeGroupsInARun) {
    const std::string clamp = "clamp = { group = \"handle\" }";
    for (const std::string load :
         {"pressure = 3", "line = [0, 0, 1]", "area = [0, 0, 1]", "point = [0, 0, 1]"}) {
        const ProgramResult result =
            outcome("run", clamp, "[[force.load]]\n" + load + "\ngroup = \"blade\"\n");
        EXPECT_EQ(result.exit_code, 0) << load << ": " << result.err;
    }
}

TEST(SceneGroup, AnUnknownGroupIsNamedWithTheNearest) {
    for (const std::string command : {"check", "run"}) {
        expect_refused(
            outcome(command, "pin = { group = \"handel\" }"),
            "scene.toml:5: sheet.strip.pin.group: the mesh has no group 'handel'; did you mean 'handle'?");
        expect_refused(outcome(command, "clamp = [{ group = \"zzzzz\" }]"), "it has blade, handle, strip");
        expect_refused(
            outcome(command, "", "[[force.load]]\npressure = 1\ngroup = \"blad\"\n"),
            "scene.toml:10: force.load[0].group: the mesh has no group 'blad'; did you mean 'blade'?");
    }
}

// Remeshing must not move the border between groups.
TEST(SceneGroup, RemeshingKeepsGroups) {
    const auto pinned = [](const std::string& group) {
        const ProgramResult result = outcome("check", "pin = { group = \"" + group + "\" }", "",
                                             "{ file = \"strip.obj\", remesh = { edge_length = 0.3 } }");
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return std::stoi(result.out.substr(result.out.find("pinned vertices ") + 16));
    };
    const int all = pinned("strip"), handle = pinned("handle"), blade = pinned("blade");
    EXPECT_GT(handle, 9);
    const int shared = handle + blade - all;
    EXPECT_GE(shared, 3) << "of the line between them";
    EXPECT_LE(shared, 6);
}

}  // namespace
}  // namespace sherd::test
