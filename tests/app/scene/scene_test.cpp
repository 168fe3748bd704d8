// SPDX-License-Identifier: GPL-3.0-or-later
// Values of a scene file must arrive in the simulation as written: a value that is read wrongly, or a default
// that changes, falsifies all numbers of a run without notice.
#include "app/scene/read/scene.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "app/messages/nearest_name.h"
#include "app/scene/assemble/built_scene.h"
#include "app/scene/assemble/sheet/mesh.h"
#include "app/scene/assemble/sheet/supports.h"
#include "app/scene/read/parts/profile.h"
#include "app/scene/toml/toml_table.h"
#include "meshops/error.h"
#include "meshops/mesh_measures.h"
#include "tests/support/program/message_thrown_by.h"
#include "tests/support/program/scene_of.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

using std::numbers::pi;

const std::string small_scene = R"(duration = 0.5
[sheet.plate]
mesh = { generate = "rectangle", width = 2, height = 1, edge_length = 0.25 }
material = { preset = "glass" }
)";

TEST(Scene, EveryKeyArrives) {
    const Scene scene = scene_of(R"(duration = 2
seed = 7
[sheet.late]
mesh = { file = "a/bowl.obj", scale = 0.01, remesh = 0.02, repair = true, join = true }
velocity = [1, 2, 3]
spin = [4, 5, 6]
material = { preset = "glass", thickness = 0.01, poisson = 0.1 }
fracture.strain = 12.5
pin = [{ boundary = true }, { box = [[0, 1, 2], [3, 4, 5]] }]
[sheet.early]
mesh = { generate = "cylinder", radius = 1, height = 2, edge_length = 0.5, structured = true }
material = { density = 1000, thickness = 0.5, young = 1e6 }
[obstacle.wall]
plane = { point = [1, 0, 0], normal = [2, 0, 0] }
friction = 0.4
young = 2e9
[contact]
sheets = false
friction = 0.3
[force]
gravity = [0, 1, 0]
[solver]
step = 1e-3
max_iterations = 9
tolerance = 1e-5
max_stages = 8
[output]
every = 0.25
)");
    EXPECT_EQ(scene.duration, 2);
    EXPECT_EQ(scene.seed, 7);
    ASSERT_EQ(scene.sheets.size(), 2u);
    const SheetSpec& sheet = scene.sheets[0];
    EXPECT_EQ(sheet.name, "late") << "sheets stand in the order of the file";
    const auto& file = std::get<MeshFile>(sheet.mesh);
    EXPECT_EQ(file.path, scene.file.parent_path() / "a/bowl.obj");
    EXPECT_EQ(file.scale, 0.01);
    ASSERT_TRUE(file.remesh.has_value());
    EXPECT_EQ(file.remesh->edge_length, 0.02);
    EXPECT_TRUE(file.repair && file.join);
    EXPECT_EQ(sheet.velocity, Vector3d(1, 2, 3));
    EXPECT_EQ(sheet.spin, Vector3d(4, 5, 6));
    EXPECT_EQ(sheet.material.density, 2500) << "of the preset";
    EXPECT_EQ(sheet.material.thickness, 0.01) << "given keys win over the preset";
    EXPECT_EQ(sheet.material.poisson, 0.1);
    EXPECT_EQ(sheet.fracture->strength.along, 12.5);
    EXPECT_EQ(sheet.fracture->strength.across, 12.5);
    ASSERT_EQ(sheet.pins.size(), 2u);
    EXPECT_TRUE(sheet.pins[0].on.boundary);
    EXPECT_EQ(sheet.pins[1].on.box->first, Vector3d(0, 1, 2));
    EXPECT_EQ(sheet.pins[1].on.box->second, Vector3d(3, 4, 5));
    const auto& cylinder = std::get<GeneratedMesh>(scene.sheets[1].mesh);
    EXPECT_EQ(cylinder.shape, "cylinder");
    EXPECT_EQ(cylinder.height, 2);
    EXPECT_TRUE(cylinder.structured);
    EXPECT_FALSE(scene.sheets[1].fracture) << "without [fracture] a sheet does not break";
    ASSERT_EQ(scene.obstacles.size(), 1u);
    EXPECT_EQ(scene.obstacles[0].name, "wall");
    const PlaneShape& plane = std::get<PlaneShape>(scene.obstacles[0].shape);
    EXPECT_EQ(plane.point, Vector3d(1, 0, 0));
    EXPECT_EQ(plane.normal, Vector3d(1, 0, 0)) << "made a unit vector";
    EXPECT_EQ(scene.obstacles[0].friction, 0.4);
    EXPECT_EQ(scene.obstacles[0].young, 2e9);
    EXPECT_FALSE(scene.simulation.stepper.contact.sheets);
    EXPECT_EQ(scene.simulation.stepper.contact.friction, 0.3);
    EXPECT_EQ(scene.simulation.stepper.gravity, Vector3d(0, 1, 0));
    EXPECT_EQ(scene.simulation.stepper.step, 1e-3);
    EXPECT_EQ(scene.simulation.max_iterations, 9);
    EXPECT_EQ(scene.simulation.tolerance, 1e-5);
    EXPECT_EQ(scene.simulation.max_stages, 8);
    EXPECT_EQ(scene.frame_interval, 0.25);
}

TEST(Scene, DefaultsAreThoseOfTheReference) {
    const Scene scene = scene_of(small_scene);
    EXPECT_EQ(scene.seed, 1);
    EXPECT_EQ(scene.simulation.stepper.gravity, Vector3d(0, 0, -9.81));
    EXPECT_EQ(scene.simulation.stepper.step, 1e-4);
    EXPECT_DOUBLE_EQ(scene.frame_interval, 0.005);
    EXPECT_TRUE(scene.obstacles.empty());
    EXPECT_TRUE(scene.simulation.stepper.contact.sheets);
    EXPECT_EQ(scene.simulation.stepper.contact.friction, 0);
    EXPECT_EQ(scene.sheets[0].velocity, Vector3d(0, 0, 0));
    EXPECT_TRUE(scene.sheets[0].place.isApprox(Eigen::Isometry3d::Identity()));
}

TEST(Scene, EveryPairOfForceAndJacobianCanBeChosen) {
    const auto chosen = [](const std::vector<std::string>& keys) {
        const BendingOptions bending = scene_of(small_scene, {keys, ""}).simulation.stepper.shell.bending;
        return std::pair(bending.model, bending.jacobian);
    };
    const std::string cubic = "solver.bending=cubic", cubic_2007 = "solver.bending=cubic-2007",
                      nonlinear = "solver.bending=nonlinear";
    EXPECT_EQ(chosen({}).first, BendingModel::coupled);
    EXPECT_EQ(chosen({"solver.bending=coupled"}).first, BendingModel::coupled);
    EXPECT_EQ(chosen({cubic}), std::pair(BendingModel::cubic, BendingJacobian::cubic));
    EXPECT_EQ(chosen({cubic, "solver.jacobian=constant"}),
              std::pair(BendingModel::cubic, BendingJacobian::constant));
    EXPECT_EQ(chosen({cubic_2007}), std::pair(BendingModel::cubic_2007, BendingJacobian::cubic));
    EXPECT_EQ(chosen({nonlinear}), std::pair(BendingModel::nonlinear, BendingJacobian::nonlinear));
    EXPECT_EQ(chosen({nonlinear, "solver.jacobian=cubic"}),
              std::pair(BendingModel::nonlinear, BendingJacobian::cubic));
    EXPECT_EQ(chosen({nonlinear, "solver.jacobian=constant"}),
              std::pair(BendingModel::nonlinear, BendingJacobian::constant));
    EXPECT_EQ(chosen({nonlinear, "solver.jacobian=nonlinear"}),
              std::pair(BendingModel::nonlinear, BendingJacobian::nonlinear));
}

TEST(Scene, MembraneIsChosenAndKeptFromWrongNames) {
    const auto chosen = [](const std::vector<std::string>& keys) {
        const Scene scene = scene_of(small_scene, {keys, ""});
        std::vector<std::string> warnings;
        const MembraneModel built = build_scene(scene, warnings).options.stepper.shell.membrane;
        EXPECT_EQ(scene.simulation.stepper.shell.membrane, built);
        return built;
    };
    EXPECT_EQ(chosen({}), MembraneModel::constant_strain);
    EXPECT_EQ(chosen({"solver.membrane=constant-strain"}), MembraneModel::constant_strain);
    EXPECT_EQ(chosen({"solver.membrane=arc"}), MembraneModel::arc);
    const std::string error = message_thrown_by([] {
        scene_of(small_scene, {{"solver.membrane=arcs"}, ""});
    });
    EXPECT_NE(error.find("membrane"), std::string::npos) << error;
    EXPECT_NE(error.find("constant-strain"), std::string::npos) << error;
}

// If an unknown word chose no valid entry, memory beyond the list of schemes would be read before the error
// is reported.
TEST(Scene, AWordThatIsNoneOfThoseKnownChoosesTheFirst) {
    Problems problems;
    toml::table table = toml::parse("known = \"b\"\nwrong = \"c\"\nother = 3");
    TomlTable root(table, "", problems);
    constexpr std::array<std::string_view, 2> names{"a", "b"};
    EXPECT_EQ(root.choice_number("known", names), 1u);
    EXPECT_EQ(root.choice_number("wrong", names), 0u);
    EXPECT_EQ(root.choice_number("other", names), 0u);
    for (const std::string key : {"solver.scheme", "solver.method"}) {
        const std::string error = message_thrown_by([&] { scene_of(small_scene, {{key + "=unknown"}, ""}); });
        EXPECT_NE(error.find(key + ": must be one of"), std::string::npos) << error;
    }
}

// With coupled hinges neither a Jacobian nor a calibration would have an effect, so that both are refused.
TEST(Scene, CoupledHingesTakeNeitherAJacobianNorACalibration) {
    const auto error_with = [](const std::string& key) {
        return message_thrown_by([&] { scene_of(small_scene, {{"solver.bending=coupled", key}, ""}); });
    };
    EXPECT_NE(error_with("solver.jacobian=cubic").find("coupled hinges have one matrix of their own"),
              std::string::npos);
    EXPECT_NE(error_with("sheet.plate.material.calibration=paper").find("calibration = \"paper\" is for"),
              std::string::npos);
    EXPECT_EQ(error_with("seed=3"), "no error");
}

TEST(Scene, StepsCoverTheDurationWithoutOneForRoundOff) {
    EXPECT_EQ(step_count(scene_of(small_scene, {{"duration=0.3", "solver.step=0.1"}, ""})), 3);
    EXPECT_EQ(step_count(scene_of(small_scene, {{"duration=0.35", "solver.step=0.1"}, ""})), 4);
    EXPECT_EQ(scene_of(small_scene, {{"duration=0.001", "solver.step=1e-4"}, ""}).frame_interval, 1e-4)
        << "a frame a step at most";
}

// Frames are recorded at the ends of steps: a short frame interval must shorten the default step.
TEST(Scene, AStepThatIsNotGivenIsNoLongerThanTheTimeBetweenFrames) {
    const Scene scene = scene_of(
        "duration = 1e-3\noutput.every = 2e-5\nsheet.a.mesh = \"a.obj\"\n"
        "sheet.a.material.preset = \"glass\"\n");
    EXPECT_EQ(scene.simulation.stepper.step, 2e-5);
    EXPECT_EQ(scene.frame_interval, 2e-5);
}

TEST(Scene, RotationsComeFirstAndInOrderThenTheTranslation) {
    const Scene scene = scene_of(small_scene + R"(
[sheet.plate.place]
translate = [0, 0, 10]
rotate = [{ axis = [0, 0, 2], degrees = 90 }, { axis = [1, 0, 0], degrees = 90 }]
)");
    // The first rotation turns x to y, and the second turns y to z.
    EXPECT_TRUE((scene.sheets[0].place * Vector3d(1, 0, 0)).isApprox(Vector3d(0, 0, 11)));
    EXPECT_TRUE((scene.sheets[0].place * Vector3d(0, 0, 1)).isApprox(Vector3d(0, -1, 10)));
}

TEST(Scene, OverridesReplaceValuesAndStandInTheText) {
    const Scene scene = scene_of(
        small_scene, {{"duration=3", "sheet.plate.material.preset=steel", "sheet.plate.mesh={file=\"x.obj\"}",
                       "solver.step=1e-3", "sheet.other.mesh=y.obj", "sheet.other.material.preset=paper"},
                      ""});
    EXPECT_EQ(scene.duration, 3);
    EXPECT_EQ(scene.sheets[0].material.density, 7850);
    EXPECT_EQ(std::get<MeshFile>(scene.sheets[0].mesh).path.filename(), "x.obj");
    EXPECT_EQ(scene.simulation.stepper.step, 1e-3);
    ASSERT_EQ(scene.sheets.size(), 2u);
    EXPECT_EQ(scene.sheets[1].name, "other") << "sheets of overrides come last";
    EXPECT_TRUE(scene.text.starts_with(small_scene));
    EXPECT_NE(scene.text.find("\n# --set duration=3\n"), std::string::npos);
}

TEST(Scene, TheTextReadBackIsTheSameScene) {
    // A recording keeps the text: comments about overrides must not break it.
    const Scene scene = scene_of(small_scene, {{"duration=0.25"}, ""});
    EXPECT_EQ(scene_of(scene.text).sheets.size(), 1u);
}

// A key under a misspelt name makes a new sheet or obstacle. If only the lack of its mesh were reported, a
// user would not see the misspelt name.
TEST(Scene, AMisspeltNameOfASheetOrAnObstacleIsToldTheNearestOne) {
    const auto error_with = [](const std::string& setting) {
        return message_thrown_by([&] {
            scene_of(small_scene + "[obstacle.floor]\nplane = {}\n", {{setting}, ""});
        });
    };
    EXPECT_EQ(error_with("sheet.plat.velocity=[0,0,1]"),
              "--set sheet.plat.velocity=[0,0,1]: sheet.plat: has no mesh and no material; did you mean "
              "'plate'?");
    EXPECT_EQ(error_with("obstacle.flor.friction=1"),
              "--set obstacle.flor.friction=1: obstacle.flor: has no shape; did you mean 'floor'?");
    EXPECT_NE(error_with("sheet.other.velocity=[0,0,1]").find("sheet.other.mesh: is missing"),
              std::string::npos);
    EXPECT_EQ(error_with("obstacle.floor.friction=1"), "no error");
    EXPECT_NE(error_with("obstacle.floor2.spher={radius=1}").find("did you mean 'sphere'?"),
              std::string::npos)
        << "a shape may be misspelt instead of the name";
}

TEST(Scene, AMistakeIsToldOnce) {
    const std::string error = message_thrown_by([] { scene_of(small_scene, {{"solver=3"}, ""}); });
    EXPECT_EQ(error, "--set solver=3: solver: must be a table, not 3");
}

TEST(Scene, ABoxHasTwoCorners) {
    const std::string error = message_thrown_by([] {
        scene_of(small_scene, {{"sheet.plate.pin={box=[[0,0,0],[1,1,1],[2,2,2]]}"}, ""});
    });
    EXPECT_NE(error.find("pin.box: must be an array of 2 arrays of 3 finite numbers (m), not an array of 3"),
              std::string::npos)
        << error;
}

// Only a part of the shapes has a structured mesh; `false` is what all of them have.
TEST(Scene, StructuredIsForShapesThatHaveAGrid) {
    const auto error_with = [](const std::string& mesh) {
        return message_thrown_by([&] {
            scene_of(small_scene, {{"sheet.plate.mesh={edge_length=0.1, " + mesh + "}"}, ""});
        });
    };
    const std::string ring = "generate=\"revolution\", profile=[[1, 0], [1, 1]], structured=true";
    EXPECT_EQ(error_with("generate=\"disc\", radius=1, structured=false"), "no error");
    EXPECT_NE(error_with("generate=\"disc\", radius=1, structured=true").find("no regular grid on a disc"),
              std::string::npos);
    EXPECT_EQ(error_with(ring + ", angle=90"), "no error");
    EXPECT_NE(error_with(ring).find("structured: is for a sector"), std::string::npos);
}

TEST(Scene, NearestNameIsOneTypingMistakeAway) {
    const std::vector<std::string> names{"density", "thickness", "young", "poisson"};
    EXPECT_EQ(nearest_name("thicknes", names), "thickness");
    EXPECT_EQ(nearest_name("yuong", names), "young");
    EXPECT_EQ(nearest_name("poisson_ratio", names), "poisson");
    EXPECT_EQ(nearest_name("colour", names), "");
}

TEST(SceneMesh, IsPlacedAndHasTheSizesOfTheScene) {
    const Scene scene = scene_of(small_scene + "place.translate = [0, 0, 5]\n");
    std::vector<std::string> warnings;
    const MeshMeasures m = measure(make_mesh(scene.sheets[0], scene, warnings));
    EXPECT_TRUE(warnings.empty());
    EXPECT_NEAR(m.area, 2, 1e-12);
    EXPECT_TRUE(m.lower.isApprox(Vector3d(0, 0, 5)));
    EXPECT_TRUE(m.upper.isApprox(Vector3d(2, 1, 5)));
    EXPECT_EQ(m.boundary_loops, 1);
}

TEST(SceneMesh, FilesAreScaledAndPlaced) {
    const TemporaryDirectory directory;
    directory.write("tri.obj", "v 0 0 0\nv 100 0 0\nv 0 100 0\nf 1 2 3\n");
    const Scene scene =
        read_scene(directory.write("scene.toml",
                                   "duration = 1\n[sheet.a]\nmesh = { file = \"tri.obj\", scale = 0.01 }\n"
                                   "place.translate = [1, 0, 0]\nmaterial.preset = \"paper\"\n"));
    std::vector<std::string> warnings;
    const Mesh mesh = make_mesh(scene.sheets[0], scene, warnings);
    EXPECT_TRUE(position(mesh, Vertex(1)).isApprox(Vector3d(2, 0, 0)));
    EXPECT_NEAR(measure(mesh).area, 0.5, 1e-15);
}

// A scene can give the size of a mesh whose unit in the file is unknown. Points that no face uses must not
// count for it.
TEST(SceneMesh, FilesAreAsLargeAsTheSceneSays) {
    const TemporaryDirectory directory;
    directory.write("tri.obj", "v -300 0 0\nv 100 0 0\nv 0 -40 0\nv 999 0 0\nf 1 2 3\n");
    const auto mesh_of = [&](const std::string& more, std::vector<std::string>& warnings) {
        const Scene scene =
            read_scene(directory.write("scene.toml", "duration = 1\n[sheet.a]\nmesh = { file = \"tri.obj\"" +
                                                         more + " }\nmaterial.preset = \"paper\"\n"));
        return measure(make_mesh(scene.sheets[0], scene, warnings));
    };
    std::vector<std::string> warnings;
    const MeshMeasures sized = mesh_of(", size = 0.2", warnings);
    EXPECT_NEAR(sized.upper.x() - sized.lower.x(), 0.2, 1e-15);
    EXPECT_NEAR(sized.upper.y() - sized.lower.y(), 0.02, 1e-15);
    ASSERT_EQ(warnings.size(), 1u) << "only of the point";
    const MeshMeasures unsized = mesh_of("", warnings);
    EXPECT_NEAR(unsized.upper.x() - unsized.lower.x(), 400, 1e-12);
    EXPECT_NE(warnings.back().find("the mesh is 400 m large"), std::string::npos) << warnings.back();
    EXPECT_THROW(mesh_of(", size = 0.2, scale = 0.001", warnings), Error);
    EXPECT_THROW(mesh_of(", size = 0", warnings), Error);
}

std::string error_of(const std::string& text) {
    try {
        scene_of(text);
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(SceneMesh, PolygonsAreMeshedWithTheirHolesAndSlits) {
    const std::string square = "outline = [[0, 0], [1, 0], [1, 1], [0, 1]]";
    const auto text = [](const std::string& keys) {
        return "duration = 1\n[sheet.a]\nmaterial.preset = \"paper\"\nmesh = { generate = \"polygon\", "
               "edge_length = 0.1, " +
               keys + " }\n";
    };
    const Scene scene = scene_of(
        text(square + R"(, holes = [[[0.2, 0.2], [0.4, 0.2], [0.2, 0.4]]], slits = [[[0.5, 0.6], [0.8, 0.6]],
[[0, 0.8], [0.2, 0.8]]])"));
    std::vector<std::string> warnings;
    const MeshMeasures found = measure(make_mesh(scene.sheets[0], scene, warnings));
    EXPECT_NEAR(found.area, 0.98, 1e-12);
    EXPECT_EQ(found.boundary_loops, 3) << "outline with a slit, hole, slit inside";

    const auto says = [&](const std::string& keys, const std::string& wanted) {
        const std::string message = error_of(text(keys));
        EXPECT_NE(message.find(wanted), std::string::npos) << message;
    };
    says("outline = [[0, 0], [1, 0]]", "mesh.outline: must be an array of at least 3 arrays of 2");
    says("outline = [[0, 0], [1, 1], [1, 0], [0, 1]]", "mesh.outline: crosses or touches itself");
    says(square + ", holes = [[[2, 2], [3, 2], [3, 3]]]", "mesh.holes: hole 1 is outside of the outline");
    says(square + ", holes = [[0.2, 0.2], [0.4, 0.2]]",
         "mesh.holes: must be an array of arrays of at least 3");
    says(square + ", slits = [[[0.5, 0.5], [2, 0.5]]]", "mesh.slits: slit 1 crosses or touches");
    says(square + ", slit = []", "mesh.slit: unknown key; did you mean 'slits'?");
    says(square + ", radius = 1", "mesh.radius: unknown key");
}

TEST(SceneMesh, PinsHoldTheVerticesOfTheirBoxAndTheBoundary) {
    const Scene scene = scene_of(small_scene + R"(place.translate = [10, 0, 0]
pin = [{ box = [[9.9, -1, -1], [10.001, 2, 1]] }]
)");
    std::vector<std::string> warnings;
    const Mesh mesh = make_mesh(scene.sheets[0], scene, warnings);
    const std::vector<std::int32_t> pinned = pinned_vertices(scene.sheets[0], mesh);
    std::vector<std::int32_t> expected;
    for (const Vertex v : mesh.vertices())
        if (position(mesh, v).x() < 10.001) expected.push_back(static_cast<std::int32_t>(v.idx()));
    EXPECT_GE(expected.size(), 4u);
    EXPECT_EQ(pinned, expected);

    SheetSpec all = scene.sheets[0];
    all.pins = {{.on = {.box = {}, .boundary = true, .group = "", .where = ""}, .motion = {}, .centre = {}}};
    std::size_t border = 0;
    for (const Vertex v : mesh.vertices()) border += mesh.is_border(v);
    EXPECT_EQ(pinned_vertices(all, mesh).size(), border);
    all.pins[0].on = {.box = std::pair(Vector3d(0, 0, 0), Vector3d(1, 1, 1)),
                      .boundary = false,
                      .group = "",
                      .where = "here"};
    EXPECT_THROW(pinned_vertices(all, mesh), Error);
}

RC_GTEST_PROP(Profile, PlatesAreFlatThenRiseToTheRim, ()) {
    const double radius = *rc::gen::inRange(1, 1000) * 1e-3, height = *rc::gen::inRange(1, 500) * 1e-3;
    const double foot = radius * *rc::gen::inRange(1, 99) / 100;
    const Profile profile = plate_profile(radius, height, foot);
    RC_ASSERT(profile.front() == Eigen::Vector2d(0, 0));
    RC_ASSERT(profile[1] == Eigen::Vector2d(foot, 0));
    RC_ASSERT(profile.back() == Eigen::Vector2d(radius, height));
    for (std::size_t i = 1; i < profile.size(); ++i) {
        RC_ASSERT(profile[i].x() > profile[i - 1].x());
        RC_ASSERT(profile[i].y() >= profile[i - 1].y());
    }
}

RC_GTEST_PROP(Profile, BowlsLieOnASphereUpToTheirRim, ()) {
    const double radius = *rc::gen::inRange(1, 1000) * 1e-3, cap = *rc::gen::inRange(1, 179) * pi / 180;
    const Profile profile = bowl_profile(radius, cap);
    const double sphere = radius / std::sin(cap);
    RC_ASSERT(std::abs(profile.back().x() - radius) < 1e-12 * sphere);
    for (const Eigen::Vector2d& p : profile)
        RC_ASSERT(std::abs((p - Eigen::Vector2d(0, sphere)).norm() - sphere) < 1e-12 * sphere);
}

TEST(Profile, AreasAreThoseOfTheConeAndTheSphere) {
    const Profile cone{{0, 0}, {3, 4}};
    EXPECT_NEAR(revolved_area(cone), pi * 3 * 5, 1e-12);
    EXPECT_NEAR(revolved_area(bowl_profile(1, pi / 2)), 2 * pi, 1e-2);
}

}  // namespace
}  // namespace sherd::test
