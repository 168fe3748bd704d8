// SPDX-License-Identifier: GPL-3.0-or-later
// Invalid input through the real program: exit code 2, a message with the place and the fault, and nothing
// written. Otherwise a user would lose a run or a file, or not find the mistake.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

const std::string good_scene = R"(duration = 0.002
seed = 3
[sheet.plate]
mesh = { generate = "disc", radius = 0.1, edge_length = 0.03 }
place = { translate = [0, 0, 1] }
[sheet.plate.material]
preset = "stoneware"
[obstacle.floor]
plane = { normal = [0, 0, 1] }
[solver]
step = 1e-4
)";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    if (at == std::string::npos) throw std::runtime_error("the good scene has no " + from);
    return text.replace(at, from.size(), to);
}

std::string with_mesh(const std::string& mesh) {
    return replaced(good_scene, R"({ generate = "disc", radius = 0.1, edge_length = 0.03 })", mesh);
}

/// Invalid scene, or a scene with an invalid mesh file, and the parts that the error message must have.
struct BadInput {
    std::string name;
    std::string scene;
    std::vector<std::string> message;
    std::string mesh = {};  ///< content of mesh.obj
};

void PrintTo(const BadInput& input, std::ostream* stream) {
    *stream << input.name;
}

BadInput change(const std::string& name, const std::string& from, const std::string& to,
                const std::vector<std::string>& message) {
    return {name, replaced(good_scene, from, to), message};
}

const std::string step_line = "step = 1e-4", radius = "radius = 0.1", stoneware = "preset = \"stoneware\"";
const std::string normal = "normal = [0, 0, 1]", seed = "seed = 3", duration = "duration = 0.002";
const std::string place = "place = { translate = [0, 0, 1] }";

const std::vector<BadInput> bad_scenes{
    change("syntax", seed, "seed = = 3", {"scene.toml:2:", "TOML syntax"}),
    change("syntax_unclosed", "[sheet.plate]", "[sheet.plate", {"scene.toml:3:", "TOML syntax"}),
    change("twice", seed, "duration = 1", {"scene.toml:2:", "TOML syntax"}),
    {"empty", "", {"scene.toml:1: duration: is missing", "sheet: the scene has no sheet"}},
    change("no_sheet", "[sheet.plate]", "[sheets.plate]", {"unknown key; did you mean 'sheet'?"}),
    change("unknown_root_key", seed, "seeed = 3", {"scene.toml:2: seeed: unknown key; did you mean 'seed'?"}),
    change("unknown_mesh_key", radius, "radius = 0.1, raduis = 0.1",
           {"scene.toml:4: sheet.plate.mesh.raduis: unknown key; did you mean 'radius'?"}),
    change("unknown_material_key", stoneware, stoneware + "\nyuong = 7e10",
           {"scene.toml:8: sheet.plate.material.yuong: unknown key; did you mean 'young'?"}),
    change("unknown_solver_key", step_line, "stpe = 1",
           {"scene.toml:11: solver.stpe", "did you mean 'step'?"}),
    change("unknown_bending", step_line, "bending = \"nonliner\"",
           {"scene.toml:11: solver.bending", "\"cubic-2007\"", "did you mean \"nonlinear\"?"}),
    change("unknown_jacobian", step_line, "jacobian = \"exact\"",
           {"scene.toml:11: solver.jacobian", "\"constant\""}),
    change("unpaired_jacobian", step_line, "bending = \"cubic\"\njacobian = \"nonlinear\"",
           {"scene.toml:12: solver.jacobian: \"nonlinear\" needs bending = \"nonlinear\""}),
    change("unpaired_default", step_line, "jacobian = \"nonlinear\"", {"scene.toml:11: solver.jacobian:"}),
    change("unknown_shape", "\"disc\"", "\"disk\"",
           {"scene.toml:4: sheet.plate.mesh.generate", "\"revolution\"", "did you mean \"disc\"?"}),
    change("unknown_preset", "\"stoneware\"", "\"stonewear\"",
           {"scene.toml:7: sheet.plate.material.preset", "did you mean \"stoneware\"?"}),
    change("unknown_obstacle", "plane = { normal = [0, 0, 1] }", "cube = 1",
           {"scene.toml:8: obstacle.floor: needs one of plane,", "obstacle.floor.cube: unknown key"}),
    change("key_of_another_shape", radius, "radius = 0.1, width = 2",
           {"scene.toml:4: sheet.plate.mesh.width: unknown key"}),
    change("two_meshes", radius, "radius = 0.1, file = \"a.obj\"", {"mesh.file: conflicts with generate"}),
    change("no_mesh", "generate = \"disc\", ", "", {"scene.toml:4: sheet.plate.mesh: needs one of"}),
    change("no_material", "[sheet.plate.material]\npreset = \"stoneware\"", "", {"material: is missing"}),
    change("no_thickness", stoneware, "density = 2400\nyoung = 7e10", {"material.thickness: is missing"}),
    change("type_of_duration", duration, "duration = \"long\"",
           {"scene.toml:1: duration: must be a positive number (s), not the string \"long\""}),
    change("type_of_sheet", "[sheet.plate]", "[sheet]\nother = 3\n[sheet.plate]",
           {"scene.toml:4: sheet.other: must be a table"}),
    change("type_of_seed", seed, "seed = 3.5", {"scene.toml:2: seed: must be an integer"}),
    change("negative_seed", seed, "seed = -3", {"scene.toml:2: seed: must be an integer from 0"}),
    change("type_of_flag", step_line, "arc_length = 1",
           {"scene.toml:11: solver.arc_length: must be true or false, not 1"}),
    change("seed_with_point", seed, "seed = 1.0",
           {"scene.toml:2: seed: must be an integer from 0 to 4294967295, not 1.0"}),
    change("seed_as_flag", seed, "seed = true", {"4294967295, not true"}),
    change("no_grid_on_a_disc", radius, "radius = 0.1, structured = true",
           {"scene.toml:4: sheet.plate.mesh.structured: is for a rectangle, a cylinder or a sector"}),
    change("zero_duration", duration, "duration = 0", {"scene.toml:1: duration: must be a positive"}),
    change("negative_duration", duration, "duration = -1", {"scene.toml:1: duration: must be a positive"}),
    change("zero_step", step_line, "step = 0",
           {"scene.toml:11: solver.step: must be a positive number (s), not 0"}),
    change("negative_step", step_line, "step = -1e-4", {"scene.toml:11: solver.step: must be a positive"}),
    change("countless_steps", step_line, "step = 1e-20", {"scene.toml:11: solver.step: would take"}),
    {"endless", "duration = 1e20\n", {"scene.toml:1: duration: would take 1e+24 steps"}},
    change("step_past_duration", step_line, "step = 1",
           {"scene.toml:11: solver.step: is longer than duration"}),
    change("zero_thickness", stoneware, stoneware + "\nthickness = 0", {"thickness: must be a positive"}),
    change("negative_thickness", stoneware, stoneware + "\nthickness = -1",
           {"must be a positive number (m)"}),
    change("zero_density", stoneware, stoneware + "\ndensity = 0",
           {"scene.toml:8: sheet.plate.material.density"}),
    change("negative_density", stoneware, stoneware + "\ndensity = -1",
           {"must be a positive number (kg/m^3)"}),
    change("zero_young", stoneware, stoneware + "\nyoung = 0", {"material.young: must be a positive"}),
    change("poisson_half", stoneware, stoneware + "\npoisson = 0.5",
           {"poisson: must be a number between -1"}),
    change("negative_strain", "[obstacle.floor]", "[sheet.plate.fracture]\nstrain = -2\n[obstacle.floor]",
           {"scene.toml:9: sheet.plate.fracture.strain: must be a positive number (1/m)"}),
    change("nan", radius, "radius = nan", {"scene.toml:4: sheet.plate.mesh.radius", "not nan"}),
    change("vast_number", radius, "radius = 1e300",
           {"scene.toml:4: sheet.plate.mesh.radius: must be a positive number (m), not 1e+300; numbers other "
            "than 0 are from 1e-30 to 1e+30"}),
    change("vast_vector", place, "velocity = [0, 0, 1e300]", {"sheet.plate.velocity", "from 1e-30 to 1e+30"}),
    change("vanishing_number", stoneware, stoneware + "\nthickness = 1e-200",
           {"sheet.plate.material.thickness", "from 1e-30 to 1e+30"}),
    change("far_away", place, "place = { translate = [0, 1e15, 0] }",
           {"scene.toml:4: sheet.plate.mesh: place:", "1e+15 m from the origin"}),
    change("infinite", place, "velocity = [0, 0, inf]", {"scene.toml:5: sheet.plate.velocity", "3 finite"}),
    change("negative_radius", radius, "radius = -0.1", {"mesh.radius: must be a positive number (m)"}),
    change("short_vector", place, "velocity = [0, 1]", {"must be an array of 3 finite numbers (m/s)"}),
    change("long_vector", normal, "normal = [0, 0, 1, 0]", {"plane.normal: must be an array of 3"}),
    change("zero_normal", normal, "normal = [0, 0, 0]", {"scene.toml:9: obstacle.floor.plane.normal"}),
    change("negative_friction", "[solver]", "friction = -0.1\n[solver]",
           {"obstacle.floor.friction: must be"}),
    change("sheets_too_near", "[obstacle.floor]",
           "[contact]\nstart = \"error\"\n[sheet.other]\nmesh = { generate = \"disc\", radius = 0.1, "
           "edge_length = 0.03 }\n"
           "place = { translate = [0, 0, 1.003] }\nmaterial = { preset = \"stoneware\" }\n[obstacle.floor]",
           {" of sheet.plate at (", " of sheet.other at (", ") m are 0.003 m apart, less than 0.004 m",
            "pairs more"}),
    change("sheets_that_cross", "[obstacle.floor]",
           "[contact]\nstart = \"error\"\n[sheet.other]\nmesh = { generate = \"disc\", radius = 0.1, "
           "edge_length = 0.03 }\n"
           "place = { translate = [0, 0, 1], rotate = { axis = [0, 1, 0], degrees = 80 } }\n"
           "material = { preset = \"stoneware\" }\n[obstacle.floor]",
           {" of sheet.plate at (", " of sheet.other at (", ") m cross or touch"}),
    change("negative_sheet_friction", "[solver]", "[contact]\nfriction = -0.1\n[solver]",
           {"contact.friction: must be"}),
    change("contact_of_a_word", "[solver]", "[contact]\nsheets = \"yes\"\n[solver]",
           {"contact.sheets: must be"}),
    change("contact_start", "[solver]", "[contact]\nstart = \"apart\"\n[solver]", {"contact.start: must be"}),
    change("zero_axis", place, "place = { rotate = { axis = [0, 0, 0], degrees = 3 } }",
           {"must not be zero"}),
    change("zero_interval", step_line, step_line + "\n[output]\nevery = 0",
           {"scene.toml:13: output.every: must be"}),
    change("interval_below_step", step_line, step_line + "\n[output]\nevery = 1e-5",
           {"shorter than solver.step"}),
    change("coarse_edges", "edge_length = 0.03", "edge_length = 3", {"edge_length: is larger than the disc"}),
    change("fine_edges", "edge_length = 0.03", "edge_length = 1e-7", {"edge_length: would make about"}),
    change("pin_of_nothing", place, "pin = {}", {"scene.toml:5: sheet.plate.pin: holds nothing"}),
    change("pin_of_both", place, "pin = { boundary = true, box = [[0, 0, 0], [1, 1, 1]] }",
           {"pin.boundary: conflicts with box"}),
    change("pin_of_group_and_box", place, "pin = { group = \"rim\", box = [[0, 0, 0], [1, 1, 1]] }",
           {"scene.toml:5: sheet.plate.pin.group: conflicts with box"}),
    change("pin_of_group_and_boundary", place, "pin = { group = \"rim\", boundary = true }",
           {"pin.boundary: conflicts with group"}),
    change("nameless_group", place, "pin = { group = \"\" }", {"pin.group: must be the name of a group"}),
    change("group_of_generated", place, "clamp = { group = \"rim\" }",
           {"scene.toml:5: sheet.plate.clamp.group: the mesh has no groups"}),
    change("pin_upside_down", place, "pin = [{ box = [[0, 0, 1], [1, 1, 0]] }]", {"pin[0].box: has a lower"}),
    change("pin_off_the_sheet", place, "pin = [{ box = [[5, 5, 5], [6, 6, 6]] }]",
           {"scene.toml:5: sheet.plate.pin[0]: holds no vertex"}),
    {"profile_behind_axis",
     with_mesh("{ generate = \"revolution\", profile = [[0, 0], [-1, 0]], edge_length = 0.1 }"),
     {"scene.toml:4: sheet.plate.mesh.profile", "r must be positive"}},
    {"bowl_by_two",
     with_mesh("{ generate = \"bowl\", radius = 1, height = 1, cap_degrees = 9, edge_length = 0.1 }"),
     {"mesh.height: conflicts with cap_degrees"}},
    {"plate_foot",
     with_mesh("{ generate = \"plate\", radius = 0.1, foot = 0.1, edge_length = 0.01 }"),
     {"mesh.foot: must be less than radius"}},
};

const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", mesh_file = "\"mesh.obj\"";

const std::vector<BadInput> bad_meshes{
    {"missing", with_mesh("\"nowhere.obj\""), {"scene.toml:4: sheet.plate.mesh", "nowhere.obj"}},
    {"folder", with_mesh("\".\""), {"scene.toml:4: sheet.plate.mesh", "folder"}},
    {"extension",
     with_mesh("\"scene.toml\""),
     {"scene.toml:4: sheet.plate.mesh", "unknown kind of mesh file"}},
    {"no_faces", with_mesh(mesh_file), {"mesh.obj", "no faces"}, "v 0 0 0\nv 1 0 0\nv 0 1 0\n"},
    {"nan",
     with_mesh(mesh_file),
     {"mesh.obj:2", "NaN or infinite"},
     "v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n"},
    {"infinite", with_mesh(mesh_file), {"mesh.obj:3", "infinite"}, "v 0 0 0\nv 1 0 0\nv 0 inf 0\nf 1 2 3\n"},
    {"index", with_mesh(mesh_file), {"mesh.obj:4", "out of range"}, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"},
    {"text", with_mesh(mesh_file), {"mesh.obj:1"}, "v 0 zero 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
    {"zero_area",
     with_mesh("{ file = \"mesh.obj\", repair = false }"),
     {"mesh.obj:6", "zero area", "repair"},
     "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nf 1 2 3\nf 1 2 4\n"},
    {"non_manifold_edge",
     with_mesh("{ file = \"mesh.obj\", repair = false }"),
     {"mesh.obj:8", "non-manifold edge", "repair"},
     "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\n"},
    {"zero_scale",
     with_mesh("{ file = \"mesh.obj\", scale = 0 }"),
     {"mesh.scale: must be a positive"},
     triangle},
    {"negative_join", with_mesh("{ file = \"mesh.obj\", join = -1 }"), {"mesh.join: must be"}, triangle},
    {"join_of_words", with_mesh("{ file = \"mesh.obj\", join = \"all\" }"), {"mesh.join: must be"}, triangle},
    {"wide_join", with_mesh("{ file = \"mesh.obj\", join = 5 }"), {"give a smaller distance"}, triangle},
    {"negative_remesh",
     with_mesh("{ file = \"mesh.obj\", remesh = -1 }"),
     {"mesh.remesh: must be"},
     triangle},
    {"fine_remesh", with_mesh("{ file = \"mesh.obj\", remesh = 1e-6 }"), {"remesh", "faces"}, triangle},
    {"vast_scale",
     with_mesh("{ file = \"mesh.obj\", scale = 1e20 }"),
     {"scene.toml:4: sheet.plate.mesh: the mesh is 1e+20 m large", "scale"},
     triangle},
    {"vanishing_scale",
     with_mesh("{ file = \"mesh.obj\", scale = 1e-20 }"),
     {"scene.toml:4: sheet.plate.mesh: the mesh is 1e-20 m large", "scale"},
     triangle},
    {"unknown_key",
     with_mesh("{ file = \"mesh.obj\", repiar = true }"),
     {"did you mean 'repair'?"},
     triangle},
};

class BadInputTest : public testing::TestWithParam<std::tuple<std::string, BadInput>> {};

TEST_P(BadInputTest, IsAClearErrorAndNothingIsWritten) {
    const auto& [command, input] = GetParam();
    const TemporaryDirectory directory;
    directory.write("scene.toml", input.scene);
    if (!input.mesh.empty()) directory.write("mesh.obj", input.mesh);
    const auto before = directory.contents();
    std::vector<std::string> arguments{command, "scene.toml"};
    if (command == "run") arguments.insert(arguments.end(), {"-o", "out.h5"});
    const ProgramResult result = run_sherd(arguments, directory.path);
    EXPECT_EQ(result.exit_code, 2) << result.out << result.err;
    EXPECT_TRUE(result.err.starts_with("sherd: error: ")) << result.err;
    for (const std::string& part : input.message)
        EXPECT_NE(result.err.find(part), std::string::npos) << "no '" << part << "' in: " << result.err;
    EXPECT_EQ(directory.contents(), before);
}

std::string test_name(const testing::TestParamInfo<std::tuple<std::string, BadInput>>& info) {
    return std::get<0>(info.param) + "_" + std::get<1>(info.param).name;
}

const auto both_commands = testing::Values("check", "run");
INSTANTIATE_TEST_SUITE_P(Scene, BadInputTest, testing::Combine(both_commands, testing::ValuesIn(bad_scenes)),
                         test_name);
INSTANTIATE_TEST_SUITE_P(Mesh, BadInputTest, testing::Combine(both_commands, testing::ValuesIn(bad_meshes)),
                         test_name);

class BadOverrideTest : public testing::TestWithParam<std::pair<std::string, std::string>> {};

TEST_P(BadOverrideTest, NamesTheOverride) {
    const auto& [assignment, message] = GetParam();
    const TemporaryDirectory directory;
    directory.write("scene.toml", good_scene);
    const ProgramResult result = run_sherd({"check", "scene.toml", "--set", assignment}, directory.path);
    EXPECT_EQ(result.exit_code, 2) << result.out << result.err;
    EXPECT_NE(result.err.find("--set " + assignment + ": "), std::string::npos) << result.err;
    EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
}

INSTANTIATE_TEST_SUITE_P(
    Override, BadOverrideTest,
    testing::Values(std::pair("duration", "write KEY=VALUE"), std::pair("a b=3", "not a dotted key"),
                    std::pair("=3", "not a dotted key"), std::pair("duration=", "not a TOML value"),
                    std::pair("duration=[1", "not a TOML value"),
                    std::pair("duration=fast", "duration: must be a positive number (s), not the string"),
                    std::pair("solver.stepp=1", "solver.stepp: unknown key; did you mean 'step'?"),
                    std::pair("sheet.plate.material.density=-1", "density: must be a positive number")));

TEST(Usage, GoodSceneOfTheseTestsIsGood) {
    // If this scene were refused, every changed scene above could be refused for the same fault instead of
    // its own.
    const TemporaryDirectory directory;
    directory.write("scene.toml", good_scene);
    const ProgramResult result = run_sherd({"check", "scene.toml"}, directory.path);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err, "");
    EXPECT_NE(result.out.find("sheet plate"), std::string::npos) << result.out;
}

TEST(Usage, SceneThatIsMissingAFolderOrUnreadable) {
    const TemporaryDirectory directory;
    // /proc/self/mem can be opened, but not read from its start.
    for (const std::string command : {"check", "run"})
        for (const std::string scene : {"nowhere.toml", ".", "/proc/self/mem"}) {
            const ProgramResult result = run_sherd({command, scene}, directory.path);
            EXPECT_EQ(result.exit_code, 2) << command << result.err;
            EXPECT_TRUE(result.err.starts_with("sherd: error: " + scene + ": cannot read the scene"))
                << result.err;
        }
    EXPECT_TRUE(directory.contents().empty());
}

TEST(Usage, EveryMistakeIsToldAtOnceInTheOrderOfTheFile) {
    const TemporaryDirectory directory;
    directory.write("scene.toml",
                    replaced(replaced(good_scene, duration, "duration = 0"), normal, "nomral = 1"));
    const ProgramResult result = run_sherd({"check", "scene.toml"}, directory.path);
    const std::size_t first = result.err.find("scene.toml:1:"), second = result.err.find("scene.toml:9:");
    ASSERT_NE(first, std::string::npos) << result.err;
    ASSERT_NE(second, std::string::npos) << result.err;
    EXPECT_LT(first, second);
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 2) << result.err;
}

TEST(Usage, NoCommandPrintsTheHelpAndFails) {
    const TemporaryDirectory directory;
    const ProgramResult result = run_sherd({}, directory.path);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out, "");
    for (const std::string command : {"run", "check", "info", "export", "probe"})
        EXPECT_NE(result.err.find("\n  " + command), std::string::npos) << result.err;
}

TEST(Usage, WrongOptionsExitWithTwo) {
    const TemporaryDirectory directory;
    const std::vector<std::vector<std::string>> command_lines{{"brake"},
                                                              {"check"},
                                                              {"run"},
                                                              {"info"},
                                                              {"export"},
                                                              {"probe"},
                                                              {"check", "scene.toml", "--sett", "a=1"},
                                                              {"--bad"}};
    for (const auto& arguments : command_lines) {
        const ProgramResult result = run_sherd(arguments, directory.path);
        EXPECT_EQ(result.exit_code, 2) << arguments[0];
        EXPECT_NE(result.err, "") << arguments[0];
    }
}

TEST(Usage, HelpHasALineToCopy) {
    const TemporaryDirectory directory;
    for (const std::string command : {"run", "check", "info", "export", "probe"}) {
        const ProgramResult result = run_sherd({command, "--help"}, directory.path);
        EXPECT_EQ(result.exit_code, 0) << command;
        EXPECT_NE(result.out.find("\n  sherd " + command + " "), std::string::npos) << result.out;
    }
    EXPECT_EQ(run_sherd({"--version"}, directory.path).out.substr(0, 6), "sherd ");
}

TEST(Usage, WhatIsRepairedOrDroppedIsSaid) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", with_mesh("\"mesh.obj\""));
    directory.write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nv 9 9 9\nf 1 2 3\nf 1 2 4\n");
    const ProgramResult result = run_sherd({"check", "scene.toml"}, directory.path);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.out.find("zero area"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("that no face uses"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("vertices 3, faces 1"), std::string::npos) << result.out;

    directory.write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nf 1 2 3\nf 2 1 4\nf 1 2 5\n");
    const ProgramResult separated = run_sherd({"check", "scene.toml"}, directory.path);
    EXPECT_EQ(separated.exit_code, 0) << separated.err;
    EXPECT_NE(separated.out.find("non-manifold"), std::string::npos) << separated.out;
}

}  // namespace
}  // namespace sherd::test
