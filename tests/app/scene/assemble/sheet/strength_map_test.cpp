// SPDX-License-Identifier: GPL-3.0-or-later
// If one of these tests failed, a sheet would be weak in other places than its maps and scores say.
#include "app/scene/assemble/sheet/strength_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "app/recording/recording.h"
#include "app/scene/assemble/sheet/mesh.h"
#include "app/scene/assemble/sheet/score.h"
#include "app/scene/assemble/sheet/sheet.h"
#include "app/scene/read/scene.h"
#include "meshops/error.h"
#include "meshops/mesh_measures.h"
#include "meshops/read_write/read_mesh.h"
#include "meshops/read_write/write_mesh.h"
#include "tests/support/mesh/mesh_shapes.h"
#include "tests/support/mesh/vdb_file.h"
#include "tests/support/program/png_file.h"
#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr std::uint16_t full = 65535;
constexpr Colour16 black{0, 0, 0}, white{full, full, full}, blue{0, 0, full};

/// Writes a square of 4 x 4 squares, from (0, 0) to (1, 1), in which a vertex at p has the texture
/// coordinates texture(p).
template <class Texture>
void write_square(const std::filesystem::path& file, const Texture& texture) {
    TriangleSheet sheet = triangle_sheet(grid(4, 4));
    for (Vector3d& point : sheet.points) point /= 4;
    for (const auto& triangle : sheet.triangles) {
        FaceTexture corners;
        for (int i = 0; i < 3; ++i) corners[i] = texture(sheet.points[triangle[i]].head<2>());
        sheet.look.texture.push_back(corners);
    }
    write_mesh(sheet, file);
}

Vector3d middle(const Mesh& mesh, Edge e) {
    return (position(mesh, mesh.vertex(e, 0)) + position(mesh, mesh.vertex(e, 1))) / 2;
}

class StrengthMaps : public testing::Test {
  protected:
    StrengthMaps() {
        write_square(directory.path / "square.obj", [](const Vector2d& p) { return p; });
    }
    /// Returns the factors of the square with the keys `fracture` in its table [fracture], and sets `mesh` to
    /// its mesh as placed. more: lines of its sheet, with `mesh`, that replace the usual ones.
    std::vector<double> factors(const std::string& fracture, const std::string& more = "") {
        const Scene scene = read_scene(directory.write(
            "scene.toml",
            "duration = 1\n[sheet.square]\n" + (more.empty() ? std::string("mesh = \"square.obj\"") : more) +
                "\nmaterial = { preset = \"glass\" }\n[sheet.square.fracture]\nstrain = 1\n" + fracture));
        const SheetInput input = make_sheet(scene.sheets[0], scene, warnings);
        std::erase_if(warnings, [](const std::string& w) { return w.find("fracture") == std::string::npos; });
        mesh = input.mesh;
        EXPECT_EQ(input.strength.factors.size(), mesh.number_of_edges());
        return input.strength.factors;
    }
    std::string message_of(const std::string& fracture) {
        try {
            factors(fracture);
        } catch (const Error& error) {
            return error.what();
        }
        return "no error";
    }
    TemporaryDirectory directory;
    Mesh mesh;
    std::vector<std::string> warnings;
};

// The image is black on the left, and on the right blue, which counts as a third of white. Between the
// centres of the two texels, at u = 1/4 and 3/4, values must be linear.
TEST_F(StrengthMaps, TextureIsLookedUpAtTheMiddleOfEdges) {
    write_png(directory.path / "a.png", 2, 1, {black, blue});
    const auto grey = [](double u) { return std::clamp((u - 0.25) / 0.5, 0.0, 1.0) / 3; };
    const auto in_reach = [](double u) { return u > 0.2 && u < 0.8; };  // beyond, the image repeats
    const std::vector<double> plain = factors("map = { texture = \"a.png\" }");
    const std::vector<double> ranged = factors("map = { texture = \"a.png\", range = [0.8, 0.2] }");
    for (const Edge e : mesh.edges())
        if (const double u = middle(mesh, e).x(); in_reach(u)) {
            EXPECT_NEAR(plain[e], grey(u), 1e-7);
            EXPECT_NEAR(ranged[e], 0.8 - 0.6 * grey(u), 1e-7);
        }
    EXPECT_TRUE(warnings.empty()) << warnings.front();
}

TEST_F(StrengthMaps, TextureHasItsTopAtTheTop) {
    write_png(directory.path / "a.png", 1, 2, {white, black});
    const std::vector<double> found = factors("map = { texture = \"a.png\" }");
    for (const Edge e : mesh.edges())
        if (const double v = middle(mesh, e).y(); v > 0.2 && v < 0.8) {
            EXPECT_NEAR(found[e], std::clamp((v - 0.25) / 0.5, 0.0, 1.0), 1e-7);
        }
}

// The texture coordinates of the two faces at a seam are on islands far apart; texels between the islands
// must not count.
TEST_F(StrengthMaps, ASeamIsTheMeanOfWhatItsFacesSee) {
    directory.write("square.obj",
                    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0.1 0.5\nvt 0.125 0.5\nvt 0.875 0.5\nvt 0.9 0.5\n"
                    "f 1/1 2/1 3/1\nf 1/4 3/4 4/4\n");
    write_png(directory.path / "a.png", 4, 1, {black, white, white, blue});
    const std::vector<double> found = factors("map = { texture = \"a.png\" }");
    const double left = (1.0 / 3) * 0.1, right = 1.0 / 3 * 0.9;  // at u = 0.1 and 0.9 of the repeated image
    for (const Edge e : mesh.edges()) {
        const bool seam = !mesh.is_border(e);
        const bool lower = middle(mesh, e).x() > middle(mesh, e).y();
        EXPECT_NEAR(found[e], seam ? (left + right) / 2 : lower ? left : right, 1e-6);
    }
}

TEST_F(StrengthMaps, RefusesCoordinatesThatAreNoNumbers) {
    write_square(directory.path / "square.obj", [](const Vector2d& p) { return p / p.x(); });
    write_png(directory.path / "a.png", 1, 1, white);
    const std::string message = message_of("map = { texture = \"a.png\" }");
    for (const char* part : {"the texture coordinates of face 0 at (", ") m are NaN or infinite"})
        EXPECT_NE(message.find(part), std::string::npos) << message;
}

TEST_F(StrengthMaps, MultipliesTheScatter) {
    write_png(directory.path / "a.png", 1, 1, white);
    const std::vector<double> scatter = factors("weibull = 8");
    const std::vector<double> found = factors("weibull = 8\nmap = { texture = \"a.png\", range = [0, 0.5] }");
    for (std::size_t e = 0; e < found.size(); ++e) EXPECT_NEAR(found[e], 0.5 * scatter[e], 1e-12);
}

// Unbreakable edges must stay so where another map or the scatter gives strength zero.
TEST_F(StrengthMaps, NeverKeepsWhatIsWhiteWhole) {
    write_png(directory.path / "a.png", 2, 1, {black, white});
    write_png(directory.path / "b.png", 1, 1, black);
    const auto is_whole = [](double u) { return u > 0.51 && u < 0.99; };  // beyond, the image repeats
    const auto found = factors(
        "weibull = 8\nmap = [{ texture = \"b.png\", range = [0, 1] }, "
        "{ texture = \"a.png\", value = \"never\" }]");
    const auto other = factors("map = [{ texture = \"a.png\", value = \"never\" }, { texture = \"b.png\" }]");
    int whole = 0;
    for (const Edge e : mesh.edges()) {
        if (const double u = middle(mesh, e).x(); is_whole(u)) {
            EXPECT_TRUE(std::isinf(found[e]) && std::isinf(other[e]));
            ++whole;
        } else if (u > 0.01 && u < 0.49) {
            EXPECT_EQ(found[e], 0);
            EXPECT_EQ(other[e], 0);
        }
    }
    EXPECT_GT(whole, 10);
}

// A map or a score of the toughness must not change the strength, nor a map of the strength the toughness.
TEST_F(StrengthMaps, ChangeTheLawThatTheySay) {
    write_png(directory.path / "a.png", 1, 1, white);
    const std::string text =
        "duration = 1\n[sheet.square]\nmesh = \"square.obj\"\nmaterial = { preset = \"glass\" }\n"
        "[sheet.square.fracture]\nstrength = 1e7\ntoughness = 1e6\n"
        "map = [{ texture = \"a.png\", range = [1, 0.5], of = \"toughness\" }, { texture = \"a.png\", range "
        "= "
        "[1, 0.2] }]\nscore = { line = [[0, 0.5, 0], [1, 0.5, 0]], factor = 0.1, of = \"toughness\" }\n";
    const Scene scene = read_scene(directory.write("scene.toml", text));
    const SheetInput input = make_sheet(scene.sheets[0], scene, warnings);
    ASSERT_EQ(input.toughness.factors.size(), input.mesh.number_of_edges());
    for (const Edge e : input.mesh.edges()) {
        const bool scored = position(input.mesh, input.mesh.vertex(e, 0)).y() == 0.5 &&
                            position(input.mesh, input.mesh.vertex(e, 1)).y() == 0.5;
        EXPECT_NEAR(input.strength.factors[e], 0.2, 1e-6);
        EXPECT_NEAR(input.toughness.factors[e], scored ? 0.05 : 0.5, 1e-6);
    }
    const auto told = run_sherd({"check", "scene.toml"}, directory.path);
    EXPECT_NE(told.out.find("cracks propagate above 1e+06 Pa m^0.5, at"), std::string::npos)
        << told.out << told.err;
    EXPECT_NE(told.out.find("times 0.05 to 0.5, edge by edge"), std::string::npos) << told.out;
}

// A grid that was exported together with the mesh must move with the mesh when the scene scales and places
// it.
TEST_F(StrengthMaps, GridMovesWithTheMesh) {
    const auto value = [](double x, double y, double z) { return 1 + x - 0.5 * y + z; };
    write_vdb(directory.path / "a.vdb", {vdb_grid("s", 0.1, {{-2, -2, -2}, {12, 12, 2}}, 1.0f, value)});
    const std::vector<double> own = factors("map = { vdb = \"a.vdb\" }");
    for (const Edge e : mesh.edges())
        EXPECT_NEAR(own[e], value(middle(mesh, e).x(), middle(mesh, e).y(), 0), 1e-6);
    const std::vector<double> moved =
        factors("map = { vdb = \"a.vdb\", grid = \"s\" }",
                "mesh = { file = \"square.obj\", scale = 0.7 }\n"
                "place = { translate = [3, 4, 5], rotate = { axis = [1, 2, 3], degrees = 77 } }");
    for (std::size_t e = 0; e < own.size(); ++e) EXPECT_NEAR(moved[e], own[e], 1e-5);
    EXPECT_GT(middle(mesh, Edge(0)).norm(), 3);
    const std::vector<double> fitted = factors("map = { vdb = \"a.vdb\", range = [0.2, 0.6] }");
    for (std::size_t e = 0; e < own.size(); ++e)
        EXPECT_NEAR(fitted[e], 0.2 + 0.4 * std::min(own[e], 1.0), 1e-6);
    EXPECT_TRUE(warnings.empty()) << warnings.front();
}

TEST_F(StrengthMaps, EdgesOutsideTheGridTakeItsBackgroundAndAreCounted) {
    const auto half = [](double, double, double) { return 0.5f; };
    write_vdb(directory.path / "a.vdb", {vdb_grid("s", 0.01, {{-5, -5, -5}, {50, 120, 5}}, 0.25f, half)});
    const std::vector<double> found = factors("map = { vdb = \"a.vdb\" }");
    std::size_t outside = 0;
    for (const Edge e : mesh.edges())
        if (const double x = middle(mesh, e).x(); x < 0.499) {
            EXPECT_EQ(found[e], 0.5);
        } else if (x > 0.511) {
            EXPECT_EQ(found[e], 0.25);
            ++outside;
        }
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(
        warnings[0].find("scene.toml:7: sheet.square.fracture.map.vdb: " + std::to_string(outside) + " of " +
                         std::to_string(found.size()) + " edges lie outside the active region"),
        std::string::npos)
        << warnings[0];
    EXPECT_TRUE(warnings[0].ends_with("background value, 0.25")) << warnings[0];
}

TEST_F(StrengthMaps, NegativeAndMissingValuesAreNamedWithTheirPlace) {
    for (const double bad : {-2.0, std::nan("")}) {
        const auto value = [&](double x, double, double) { return x > 0.85 ? bad : 1.0; };
        write_vdb(directory.path / "a.vdb", {vdb_grid("s", 0.1, {{-2, -2, -2}, {12, 12, 2}}, 1.0f, value)});
        const std::string message = message_of("map = { vdb = \"a.vdb\" }");
        EXPECT_NE(message.find("scene.toml:7: sheet.square.fracture.map.vdb: "), std::string::npos)
            << message;
        EXPECT_NE(message.find("a.vdb is " + std::string(bad < 0 ? "-1.25" : "nan") + " at ("),
                  std::string::npos)
            << message;
    }
}

TEST_F(StrengthMaps, ScoresMultiplyWhereTheyMeet) {
    directory.write("edges.txt", "6 7\n7 8 # the middle row begins\n");
    const std::string scores =
        "score = [{ line = [[0.25, 0.25, 0], [0.75, 0.25, 0]], factor = 0.5 }, { edges = \"edges.txt\", "
        "factor = 0.4 }]";
    const std::vector<double> found =
        factors(scores,
                "mesh = \"square.obj\"\nplace = { translate = [0, 0, 7], rotate = { axis = [1, 0, 0], "
                "degrees = 90 } }");
    std::map<double, int> count;
    for (const double factor : found) ++count[factor];
    EXPECT_EQ(count, (std::map<double, int>{{0.5 * 0.4, 2}, {1, static_cast<int>(found.size()) - 2}}))
        << "vertices 6, 7 and 8 are those of the line";
    const std::vector<double> weak = factors("score = { line = [[0, 0.5, 0], [1, 0.5, 0]], factor = 0.3 }");
    for (const Edge e : mesh.edges()) {
        const bool on_line =
            position(mesh, mesh.vertex(e, 0)).y() == 0.5 && position(mesh, mesh.vertex(e, 1)).y() == 0.5;
        EXPECT_EQ(weak[e], on_line ? 0.3 : 1);
    }
}

// A disc held at two opposite sides and pressed down between them must break along the score across it, and
// nowhere else.
TEST(BreakingScore, ADiscBreaksAlongItAndNowhereElse) {
    const TemporaryDirectory directory;
    const std::filesystem::path file = directory.write("scene.toml", R"(duration = 0.004
[sheet.disc]
mesh = { generate = "disc", radius = 0.1, edge_length = 0.012 }
place = { translate = [0, 0, 1], rotate = { axis = [0, 0, 1], degrees = 30 } }
material = { preset = "glass" }
[[sheet.disc.pin]]
box = [[-0.2, -0.2, 0.9], [-0.06, 0.2, 1.1]]
[[sheet.disc.pin]]
box = [[0.06, -0.2, 0.9], [0.2, 0.2, 1.1]]
[sheet.disc.fracture]
strength = 2e7
score = { line = [[-0.05, -0.0866, 0], [0.05, 0.0866, 0]], factor = 0.05 }
[[force.load]]
area = [0, 0, -1e4]
ramp = 0.002
)");
    const auto result = run_sherd({"run", "scene.toml", "-o", "run.h5"}, directory.path);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const Scene scene = read_scene(file);
    std::vector<std::string> warnings;
    const Mesh disc = make_mesh(scene.sheets[0], scene, warnings);
    std::set<Index> score, broken;
    for (const Edge e : scored_edges(scene.sheets[0].fracture->scores[0], disc, scene.sheets[0].place)) {
        score.insert(static_cast<Index>(e));
        EXPECT_LT(std::abs(middle(disc, e).x()), 0.012) << "placed, the score runs along the y axis";
    }
    const Recording recording(directory.path / "run.h5");
    for (const EdgeFailure& failure : recording.events().failures) broken.insert(failure.edge);
    EXPECT_EQ(broken, score) << result.out;
    const std::vector<Index> fragments = recording.frame(recording.frame_count() - 1).face_fragment;
    EXPECT_EQ(std::set<Index>(fragments.begin(), fragments.end()).size(), 2u);
}

struct BadMap {
    std::string name, fracture, message;
    std::string mesh = "\"square.obj\"";
};

void PrintTo(const BadMap& input, std::ostream* stream) {
    *stream << input.name;
}

const std::string disc = "{ generate = \"disc\", radius = 0.1, edge_length = 0.03 }",
                  remeshed = "{ file = \"square.obj\", remesh = 0.2 }";

class BadStrengthMap : public testing::TestWithParam<BadMap> {};

TEST_P(BadStrengthMap, IsAnErrorThatNamesLineAndKey) {
    const TemporaryDirectory directory;
    write_square(directory.path / "square.obj", [](const Vector2d& p) { return p; });
    write_png(directory.path / "good.png", 2, 2, white);
    write_png(directory.path / "half.png", 200, 200, white);
    std::filesystem::resize_file(directory.path / "half.png",
                                 std::filesystem::file_size(directory.path / "half.png") / 2);
    const auto one = [](double, double, double) { return 1; };
    const openvdb::CoordBBox block({0, 0, 0}, {9, 9, 9});
    write_vdb(directory.path / "two.vdb",
              {vdb_grid("first", 1, block, 1.0f, one), vdb_grid("second", 1, block, 1.0f, one)});
    write_vdb(directory.path / "half.vdb", {vdb_grid("first", 1, block, 1.0f, one)});
    std::filesystem::resize_file(directory.path / "half.vdb",
                                 std::filesystem::file_size(directory.path / "half.vdb") / 2);
    const auto doubles = openvdb::GridBase::createGrid(openvdb::DoubleGrid::gridType());
    doubles->setName("first");
    write_vdb(directory.path / "double.vdb", {doubles});
    directory.write("edges.txt", "6 7\n7 7\n");
    directory.write("scene.toml",
                    "duration = 1\n[sheet.square]\nmesh = " + GetParam().mesh +
                        "\nmaterial = { preset = \"glass\" }\n[sheet.square.fracture]\nstrain = 1\n" +
                        GetParam().fracture + "\n");
    const ProgramResult result = run_sherd({"check", "scene.toml"}, directory.path);
    EXPECT_EQ(result.exit_code, 2) << result.out << result.err;
    const std::string place = "scene.toml:7: sheet.square.fracture.";
    EXPECT_NE(result.err.find(place + GetParam().message), std::string::npos) << result.err;
}

INSTANTIATE_TEST_SUITE_P(
    Scene, BadStrengthMap,
    testing::Values(
        BadMap{"no_png", "map = { texture = \"no.png\" }",
               "map.texture: no.png: cannot read the image: No such"},
        BadMap{"damaged_png", "map = { texture = \"half.png\" }", "map.texture: half.png: damaged PNG file"},
        BadMap{"png_is_vdb", "map = { texture = \"two.vdb\" }", "map.texture: two.vdb: is not a PNG file"},
        BadMap{"no_coordinates", "map = { texture = \"good.png\" }",
               "map.texture: the mesh has no texture coordinates", disc},
        BadMap{"no_vdb", "map = { vdb = \"no.vdb\" }", "map.vdb: no.vdb: cannot read the grids: No such"},
        BadMap{"damaged_vdb", "map = { vdb = \"half.vdb\" }", "map.vdb: half.vdb: damaged OpenVDB file"},
        BadMap{"vdb_is_png", "map = { vdb = \"good.png\" }",
               "map.vdb: good.png: damaged OpenVDB file, or not OpenVDB at all"},
        BadMap{"two_grids", "map = { vdb = \"two.vdb\" }",
               "map.vdb: two.vdb: holds several float grids: name one of 'first', 'second'"},
        BadMap{"unknown_grid", "map = { vdb = \"two.vdb\", grid = \"third\" }",
               "map.vdb: two.vdb: has no float grid 'third'; it has 'first', 'second'"},
        BadMap{"no_float_grid", "map = { vdb = \"double.vdb\" }", "map.vdb: double.vdb: holds no float grid"},
        BadMap{"neither", "map = { range = [0, 1] }", "map: needs one of texture, vdb and property"},
        BadMap{"both", "map = { texture = \"good.png\", vdb = \"two.vdb\" }",
               "map.texture: conflicts with vdb: give one of them"},
        BadMap{"grid_of_texture", "map = { texture = \"good.png\", grid = \"a\" }",
               "map.grid: needs vdb, the file that has the grid"},
        BadMap{"one_number", "map = { texture = \"good.png\", range = 0.5 }",
               "map.range: must be an array of 2, each a number of 0 or more"},
        BadMap{"negative_range", "map = { texture = \"good.png\", range = [-1, 1] }",
               "map.range: must be an array"},
        BadMap{"misspelt", "map = { texture = \"good.png\", rnage = [0, 1] }",
               "map.rnage: unknown key; did you mean"},
        BadMap{"type", "map = \"good.png\"", "map: must be a table"},
        BadMap{"no_factor", "score = { line = [[0, 0, 0], [1, 0, 0]] }", "score.factor: is missing"},
        BadMap{"zero_factor", "score = { line = [[0, 0, 0], [1, 0, 0]], factor = 0 }",
               "score.factor: must be a positive number"},
        BadMap{"edges_and_line",
               "score = { line = [[0, 0, 0], [1, 0, 0]], edges = \"edges.txt\", factor = 1 }",
               "score.line: conflicts with edges"},
        BadMap{"nothing_scored", "score = { factor = 0.5 }", "score: needs one of edges and line"},
        BadMap{"short_line", "score = { line = [[0, 0, 0]], factor = 0.5 }",
               "score.line: must be an array of at least 2"},
        BadMap{"second_score",
               "score = [{ line = [[0, 0, 0], [1, 0, 0]], factor = 1 }, { lien = 3, factor = 1 }]",
               "score[1].lien: unknown key; did you mean 'line'?"},
        BadMap{"off_the_sheet", "score = { line = [[0, 0, 0], [1, 3, 0]], factor = 0.5 }",
               "score.line: point 1 of the line (counted from 0) is off the sheet"},
        BadMap{"no_list", "score = { edges = \"no.txt\", factor = 0.5 }", "score.edges: no.txt: cannot read"},
        BadMap{"bad_edge", "score = { edges = \"edges.txt\", factor = 0.5 }",
               "score.edges: edges.txt:2: edge 7 7 is not in the mesh"},
        BadMap{"edges_of_generated", "score = { edges = \"edges.txt\", factor = 0.5 }",
               "score.edges: a list of edges needs a mesh from a file, without remesh", disc},
        BadMap{"edges_of_remeshed", "score = { edges = \"edges.txt\", factor = 0.5 }",
               "score.edges: a list of edges needs a mesh from a file, without remesh", remeshed}),
    [](const auto& input) { return input.param.name; });

}  // namespace
}  // namespace sherd::test
