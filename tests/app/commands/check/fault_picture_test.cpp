// SPDX-License-Identifier: GPL-3.0-or-later
// `sherd check -o faults.ply` writes a mesh that shows faults in MeshLab or Blender: without it a user has to
// search for faces by number.
#include <gtest/gtest.h>

#include <map>
#include <regex>

#include "meshops/soup/polygon_soup.h"
#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

std::string sheet(const std::string& name, const std::string& place,
                  const std::string& mesh = R"({ generate = "disc", radius = 0.1, edge_length = 0.03 })") {
    return "[sheet." + name + "]\nmesh = " + mesh + "\nplace = { " + place +
           " }\nmaterial = { preset = \"stoneware\" }\n";
}

const std::string upright = "rotate = { axis = [0, 1, 0], degrees = 80 }";

using Rgb = std::array<int, 3>;
constexpr Rgb grey{190, 190, 190}, red{220, 20, 20}, orange{255, 140, 0}, blue{0, 70, 220},
    violet{140, 40, 190}, yellow{240, 220, 0}, cyan{0, 170, 220};

/// Colour of each face as MeshLab reads it from the file. Expects that its corners have the same colour.
std::vector<Rgb> face_colours(const TemporaryDirectory& directory, const std::string& name = "faults.ply") {
    const std::string bytes = directory.contents().at((directory.path / name).string());
    const PolygonSoup soup = parse_ply(name, bytes);
    const std::string vertex =
        "property double z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n";
    EXPECT_NE(bytes.find(vertex), std::string::npos);
    EXPECT_NE(
        bytes.find(
            "vertex_indices\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n"),
        std::string::npos);
    const std::size_t points = bytes.find("end_header\n") + 11, faces = points + 27 * soup.points.size();
    const auto colour_at = [&](std::size_t at) {
        return Rgb{static_cast<unsigned char>(bytes[at]), static_cast<unsigned char>(bytes[at + 1]),
                   static_cast<unsigned char>(bytes[at + 2])};
    };
    std::vector<Rgb> colours;
    for (std::size_t f = 0; f < soup.polygons.size(); ++f) {
        colours.push_back(colour_at(faces + 16 * f + 13));
        for (const std::size_t corner : soup.polygons[f])
            EXPECT_EQ(colour_at(points + 27 * corner + 24), colours[f]);
    }
    return colours;
}

std::map<Rgb, int> count(const std::vector<Rgb>& colours) {
    std::map<Rgb, int> counts;
    for (const Rgb& colour : colours) ++counts[colour];
    return counts;
}

ProgramResult check(const TemporaryDirectory& directory, const std::string& scene,
                    const std::vector<std::string>& more = {}) {
    directory.write("scene.toml", "duration = 0.001\n" + scene);
    std::vector<std::string> arguments{"check", "scene.toml", "-o", "faults.ply"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_sherd(arguments, directory.path);
}

const std::string strict = "contact.start = \"error\"\n";

// "no face crosses another" was once printed beside the error about a missing mesh.
TEST(FaultPicture, SaysNothingOfTheFacesOfAMeshThatIsMissing) {
    const TemporaryDirectory directory;
    const ProgramResult result = check(directory, sheet("lost", "", "\"missing.obj\""));
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_EQ(result.out.find("no face crosses"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("the faces of sheet.lost are unknown"), std::string::npos) << result.out;
}

TEST(FaultPicture, FacesThatTheMessageNamesAreRedAndWhereItSays) {
    const TemporaryDirectory directory;
    const ProgramResult result = check(directory, strict + sheet("low", "") + sheet("high", upright));
    EXPECT_EQ(result.exit_code, 2) << result.err;
    const std::regex pair(
        R"(face (\d+) of sheet\.low at \(([-0-9.e]+), ([-0-9.e]+), ([-0-9.e]+)\) m and face (\d+) of )"
        R"(sheet\.high at \(.*\) m cross or touch)");
    std::smatch named;
    ASSERT_TRUE(std::regex_search(result.err, named, pair)) << result.err;
    const std::vector<Rgb> colours = face_colours(directory);
    const std::size_t face = std::stoul(named[1]), other = colours.size() / 2 + std::stoul(named[5]);
    EXPECT_EQ(colours[face], red);
    EXPECT_EQ(colours[other], red);
    EXPECT_GT(count(colours)[grey], 0);
    EXPECT_NE(result.out.find("red: crosses or touches another face"), std::string::npos) << result.out;
    const PolygonSoup soup = parse_ply("", directory.contents().at((directory.path / "faults.ply").string()));
    double x = 0;
    for (const std::size_t corner : soup.polygons[face]) x += soup.points[corner].x() / 3;
    EXPECT_NEAR(x, std::stod(named[2]), 1e-5);
}

TEST(FaultPicture, EachKindHasItsColour) {
    const TemporaryDirectory directory;
    const auto colours_of = [&](const std::string& scene) {
        const ProgramResult result = check(directory, strict + scene, {"--force"});
        EXPECT_EQ(result.exit_code, 2) << scene << result.err;
        return count(face_colours(directory));
    };
    EXPECT_GT(colours_of(sheet("a", "") + sheet("b", "translate = [0, 0, 0.003]"))[orange], 0);
    auto inside = colours_of(sheet("a", "") + "[obstacle.ball]\nsphere = { radius = 0.02 }\n");
    EXPECT_GT(inside[blue], 0);
    EXPECT_GT(inside[grey], inside[blue]);
    // A needle goes between the sheet's vertices, so that no vertex is inside: only its surface meets the
    // sheet.
    EXPECT_GT(
        colours_of(sheet("a", "") + "[obstacle.needle]\ncylinder = { radius = 0.001, length = 1, centre = "
                                    "[0.0137, 0.0071, 0], axis = [0, 0, 1] }\n")[violet],
        0);
    // A box is just below the sheet, between its vertices.
    auto near = colours_of(sheet("a", "") +
                           "[obstacle.post]\nbox = { size = [1e-3, 1e-3, 0.1], centre = "
                           "[0.012, 0.01, -0.0508] }\n");
    EXPECT_GT(near[yellow], 0);
    EXPECT_GT(near[grey], near[yellow]);
    directory.write("book.obj",
                    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 1\nf 1 2 3\nf 1 3 4\nf 1 3 5\n");
    const auto book = colours_of(
        sheet("a", "translate = [5, 0, 0]", "{ file = \"book.obj\", repair = false }") + sheet("b", ""));
    EXPECT_EQ(book.at(cyan), 3);
    EXPECT_GT(book.at(grey), 0) << "the other sheet is missing";
}

// Pairs of faces that are exempt from contact do not keep a scene from starting, but the author of the mesh
// needs their places.
TEST(FaultPicture, WhatIsExemptIsDrawnToo) {
    const TemporaryDirectory directory;
    const ProgramResult result = check(directory, sheet("low", "") + sheet("high", upright));
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_GT(count(face_colours(directory))[red], 0);
}

TEST(FaultPicture, WithoutFaultsNothingIsWritten) {
    const TemporaryDirectory directory;
    const ProgramResult good = check(directory, sheet("a", ""));
    EXPECT_EQ(good.exit_code, 0) << good.err;
    EXPECT_NE(good.out.find("faults.ply is not written"), std::string::npos) << good.out;
    EXPECT_EQ(directory.contents().size(), 1u);
}

TEST(FaultPicture, AnExistingFileIsKeptAndVariantsHaveOneEach) {
    const TemporaryDirectory directory;
    directory.write("faults.ply", "the only copy");
    const ProgramResult kept = check(directory, sheet("a", ""));
    EXPECT_EQ(kept.exit_code, 2);
    EXPECT_NE(kept.err.find("'faults.ply' exists"), std::string::npos) << kept.err;
    const ProgramResult two = check(directory, strict + sheet("a", "") + sheet("b", "translate = [0, 0, 1]") +
                                                   "[[variant]]\nname = \"near\"\n"
                                                   "sheet.b.place = { translate = [0, 0, 0.003] }\n"
                                                   "[[variant]]\nname = \"far\"\n");
    EXPECT_EQ(two.exit_code, 2) << two.err;
    EXPECT_GT(count(face_colours(directory, "faults-near.ply"))[orange], 0);
    EXPECT_EQ(directory.contents().count((directory.path / "faults-far.ply").string()), 0u);
    EXPECT_EQ(directory.contents().at((directory.path / "faults.ply").string()), "the only copy");
    EXPECT_EQ(run_sherd({"check", "scene.toml", "-o", "faults.obj"}, directory.path).exit_code, 2);
    const std::string mesh = "ply\nformat ascii 1.0\nelement vertex 0\nend_header\n";
    directory.write("mine.ply", mesh);
    directory.write("scene.toml", "duration = 1\n" + sheet("a", "", "\"mine.ply\""));
    const ProgramResult own = run_sherd({"check", "scene.toml", "-o", "mine.ply", "--force"}, directory.path);
    EXPECT_NE(own.err.find("is read by this command"), std::string::npos) << own.err;
    EXPECT_EQ(directory.contents().at((directory.path / "mine.ply").string()), mesh);
}

}  // namespace
}  // namespace sherd::test
