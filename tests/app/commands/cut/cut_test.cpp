// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <random>

#include "meshops/face_groups.h"
#include "meshops/read_write/read_mesh.h"
#include "meshops/read_write/write_mesh.h"
#include "tests/support/mesh/corner_rule.h"
#include "tests/support/mesh/mesh_shapes.h"
#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd {
namespace {

using test::CornerRule;

class Cut : public ::testing::Test {
  protected:
    void write(const std::string& name, const std::string& text) {
        std::ofstream(directory.path / name) << text;
    }
    test::ProgramResult cut(std::vector<std::string> more = {}) {
        std::vector<std::string> arguments{"cut", "mesh.obj", "--edges", "edges.txt", "-o", "out.obj"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return test::run_sherd(arguments, directory.path);
    }
    void expect_refusal(const std::string& edges, const std::string& message) {
        write("edges.txt", edges);
        const auto result = cut();
        EXPECT_EQ(result.exit_code, 2);
        EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
        EXPECT_FALSE(std::filesystem::exists(directory.path / "out.obj"));
    }
    test::TemporaryDirectory directory;
};

Mesh read(const std::filesystem::path& file) {
    std::vector<std::string> warnings;
    return read_mesh(file, {.repair = Repair::all}, warnings);
}

/// Cuts random edges of `mesh` by the program and compares every corner of the result with the rule.
void expect_rule_on(const std::filesystem::path& mesh_file, unsigned percent,
                    const std::filesystem::path& folder) {
    const Mesh mesh = read(mesh_file);
    const auto number = find_property(mesh, attribute::file_vertex).first;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Edge>> edges;
    for (const Edge edge : mesh.edges())
        edges[std::minmax(number[mesh.vertex(edge, 0)], number[mesh.vertex(edge, 1)])].push_back(edge);
    std::mt19937 random(percent);
    std::vector<CornerRule::VertexPair> failed;
    std::ofstream list(folder / "random.txt");
    for (const auto& [ends, same] : edges) {
        if (same.size() > 1 || mesh.is_border(same[0]) || random() % 100 >= percent) continue;
        list << ends.second << ' ' << ends.first << '\n';
        failed.push_back(CornerRule::ordered(static_cast<int>(mesh.vertex(same[0], 0).idx()),
                                             static_cast<int>(mesh.vertex(same[0], 1).idx())));
    }
    list.close();
    const auto result = test::run_sherd({"cut", mesh_file.string(), "--edges", "random.txt", "-o",
                                         "random.ply", "--json", "--repair", "--force"},
                                        folder);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const auto json = nlohmann::json::parse(result.out);

    const TriangleSheet old = triangle_sheet(mesh), now = triangle_sheet(read(folder / "random.ply"));
    const auto &before = old.triangles, &after = now.triangles;
    CornerRule rule(before, failed);
    ASSERT_EQ(after.size(), before.size());
    std::map<int, int> vertex_of_root;
    for (std::size_t f = 0; f < after.size(); ++f)
        for (int i = 0; i < 3; ++i) {
            ASSERT_EQ(now.points[after[f][i]], old.points[before[f][i]]);
            ASSERT_EQ(vertex_of_root.emplace(rule.vertex(static_cast<int>(f), i), after[f][i]).first->second,
                      after[f][i]);
        }
    EXPECT_EQ(json["vertices_after"], rule.vertex_count());
    EXPECT_EQ(json["edges_requested"], failed.size());
    EXPECT_EQ(json["edges_opened"], rule.open_count());
    EXPECT_EQ(json["edges_closed"], failed.size() - rule.open_count());
}

TEST_F(Cut, CountsWhatItDid) {
    write_mesh(triangle_sheet(test::grid(3, 1)), directory.path / "mesh.obj");
    write("edges.txt", "# across the strip\n1 5\n\n6 2   # backwards\n");
    const auto result = cut({"--json"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const auto json = nlohmann::json::parse(result.out);
    const nlohmann::json expected{
        {"vertices_before", 8}, {"vertices_after", 12}, {"faces", 6},
        {"edges_requested", 2}, {"edges_opened", 2},    {"edges_closed", 0},
        {"vertices_split", 4},  {"fragments", 3},       {"euler_characteristic", 3}};
    EXPECT_EQ(json, expected);
}

// A tube and a torus, with few cracks that end inside up to a crack along every edge: a mesh that opened
// otherwise than by the rule would have other pieces.
TEST_F(Cut, FollowsTheCornerRuleOnAnySurface) {
    for (const bool wrap : {false, true})
        for (const unsigned percent : {5u, 30u, 70u, 100u}) {
            write_mesh(triangle_sheet(test::grid(9, 8, true, wrap)), directory.path / "mesh.obj");
            expect_rule_on(directory.path / "mesh.obj", percent, directory.path);
        }
}

/// Mesh with every triangle divided into four at the midpoints of its sides, again and again until it has at
/// least `faces` triangles.
TriangleSheet subdivided(const Mesh& mesh, std::size_t faces) {
    TriangleSheet sheet;
    sheet.points = triangle_sheet(mesh).points;
    sheet.triangles = triangle_sheet(mesh).triangles;
    while (sheet.triangles.size() < faces) {
        std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> middles;
        const auto middle = [&](std::int32_t a, std::int32_t b) {
            const auto [found, is_new] =
                middles.try_emplace(std::minmax(a, b), static_cast<std::int32_t>(sheet.points.size()));
            if (is_new) sheet.points.push_back((sheet.points[a] + sheet.points[b]) / 2);
            return found->second;
        };
        std::vector<std::array<std::int32_t, 3>> finer;
        for (const auto& [a, b, c] : sheet.triangles) {
            const std::int32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            for (const auto& triangle : {std::array{a, ab, ca}, std::array{ab, b, bc}, std::array{ca, bc, c},
                                         std::array{ab, bc, ca}})
                finer.push_back(triangle);
        }
        sheet.triangles = std::move(finer);
    }
    return sheet;
}

// Uses meshes from elsewhere, if they are present beside the project.
TEST_F(Cut, FollowsTheCornerRuleOnRealMeshes) {
    const std::filesystem::path folder = std::filesystem::path(SHERD_SCENES) / "../../shared/data";
    if (!std::filesystem::exists(folder)) {
        std::cout << "NOTE: no real meshes here (" << folder.lexically_normal()
                  << "); this test checked nothing\n";
        return;
    }
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".obj")
            for (const unsigned percent : {10u, 60u}) expect_rule_on(entry.path(), percent, directory.path);
    // Large meshes, with 94,000 to 248,000 faces, made from three real meshes, must take only seconds.
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".obj") continue;
        write_mesh(subdivided(read(entry.path()), 90'000), directory.path / "large.obj");
        expect_rule_on(directory.path / "large.obj", 40, directory.path);
    }
}

TEST_F(Cut, AnswersEveryBadList) {
    write_mesh(triangle_sheet(test::grid(2, 2)), directory.path / "mesh.obj");
    expect_refusal("", "holds no edge");
    expect_refusal("# nothing\n", "holds no edge");
    expect_refusal("1 4\n4 1\n", "edges.txt:2: edge 1 4 was given in line 1 already");
    expect_refusal("0 1\n", "edges.txt:1: edge 0 1 is on the boundary");
    expect_refusal("1 4\n0 8\n", "edges.txt:2: edge 0 8 is not in the mesh");
    expect_refusal("1 99\n", "edge 1 99 is not in the mesh");
    expect_refusal("1 x\n", "is not a vertex number");
    expect_refusal("1 4 5\n", "is one too many");
    expect_refusal("-1 4\n", "is not a vertex number");
    expect_refusal("1\n", "write two 0-based numbers a line");
    expect_refusal("1.0 4\n", "is not a vertex number");
    expect_refusal("4294967297 4\n", "is not a vertex number");
    expect_refusal("4 4\n", "edge 4 4 is not in the mesh");
}

TEST_F(Cut, TakesListsFromAnyEditor) {
    write_mesh(triangle_sheet(test::grid(3, 1)), directory.path / "mesh.obj");
    for (const char* list :
         {"\xEF\xBB\xBF# cracks\r\n\r\n  1\t5 \r\n6 2 # no line end", "# cracks\r1 5\r6 2\r"}) {
        write("edges.txt", list);
        const auto result = cut({"--json", "--force"});
        ASSERT_EQ(result.exit_code, 0) << result.err;
        EXPECT_EQ(nlohmann::json::parse(result.out)["edges_opened"], 2);
    }
}

// A missing file, or a path that is no file, must give another message than faults in its content.
TEST_F(Cut, NamesAFileThatItCannotRead) {
    const auto expect_named = [&](const std::string& name) {
        const auto result = cut();
        EXPECT_EQ(result.exit_code, 2);
        EXPECT_NE(result.err.find(name + ":"), std::string::npos) << result.err;
        EXPECT_FALSE(std::filesystem::exists(directory.path / "out.obj"));
    };
    expect_named("mesh.obj");
    write_mesh(triangle_sheet(test::grid(2, 2)), directory.path / "mesh.obj");
    expect_named("edges.txt");
    std::filesystem::create_directory(directory.path / "edges.txt");
    expect_named("edges.txt");
}

// Parts that an exporter has left a micrometre apart would be separate pieces without a listed edge.
TEST_F(Cut, JoinsWhatIsNearEnough) {
    write("mesh.obj",
          "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1.000001 0 0\nv 2 0 0\nv 2 1 0\nv 1.000001 1 0\n"
          "f 1 2 3\nf 1 3 4\nf 5 6 7\nf 5 7 8\n");
    write("edges.txt", "1 2\n");
    const auto apart = cut({"--join", "--json"});
    EXPECT_EQ(apart.exit_code, 2) << "on the boundary\n" << apart.out;
    const auto joined = cut({"--join-within", "1e-5", "--json"});
    ASSERT_EQ(joined.exit_code, 0) << joined.err;
    const auto json = nlohmann::json::parse(joined.out);
    EXPECT_EQ(json["vertices_before"], 6);
    EXPECT_EQ(json["fragments"], 2);
    EXPECT_EQ(cut({"--join-within", "nan"}).exit_code, 2);
}

// `sherd cut` reads no scene, so that advice to write a key into it would be useless.
TEST_F(Cut, AdvisesItsOwnOptions) {
    write("edges.txt", "0 1\n");
    write("mesh.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nf 1 2 3\nf 1 2 4\n");
    const test::ProgramResult result = cut();
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("at (1, 0, 0) has zero area; --repair drops such triangles"), std::string::npos)
        << result.err;
    EXPECT_EQ(result.err.find("repair = true"), std::string::npos);
}

// --force replaces old results, but must never replace the input of the command.
TEST_F(Cut, NeverReplacesWhatItReads) {
    write_mesh(triangle_sheet(test::grid(2, 2)), directory.path / "mesh.obj");
    write("edges.txt", "1 4\n");
    std::filesystem::create_symlink("edges.txt", directory.path / "link.ply");
    const auto before = directory.contents();
    for (const char* output : {"mesh.obj", "./mesh.obj", "link.ply"}) {
        const auto result = test::run_sherd(
            {"cut", "mesh.obj", "--edges", "edges.txt", "-o", output, "--force"}, directory.path);
        EXPECT_EQ(result.exit_code, 2);
        EXPECT_NE(result.err.find("is read by this command"), std::string::npos) << result.err;
    }
    EXPECT_EQ(directory.contents(), before);
}

/// Reads the result of a cut for the tests of preserved data.
Mesh read_cut(const std::filesystem::path& file) {
    std::vector<std::string> warnings;
    Mesh mesh = read_mesh(file, {.join_advice = ""}, warnings);
    EXPECT_TRUE(warnings.empty()) << warnings[0];
    return mesh;
}

// A mesh with a texture that has a seam, with named parts and with quads, must keep all of these: faces and
// their first corners in the same order, and each corner's point, texture coordinates and groups.
TEST_F(Cut, KeepsTextureGroupsAndOrder) {
    write("mesh.obj",
          "o left wing\nv 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0.1\nv 1 1 0\nv 2 1 0\n"
          "vt 0 0\nvt 0.5 0\nvt 1 0.25\nvt 0 1\nvt 0.5 1\nvt 1 0.75\nvt 0.625 0.125\n"
          "f 5/5 1/1 2/2\ng rim front\nf 1/1 5/5 4/4\no\ng\nf 2/7 3/3 6/6 5/5\n");
    write("edges.txt", "1 4\n4 0\n");
    ASSERT_EQ(cut({"--json"}).exit_code, 0);
    const Mesh before = read_cut(directory.path / "mesh.obj"), after = read_cut(directory.path / "out.obj");
    EXPECT_EQ(after.number_of_vertices(), 10U);
    const TriangleSheet old = triangle_sheet(before), now = triangle_sheet(after);
    ASSERT_EQ(old.look.texture.size(), 4U);
    EXPECT_EQ(now.look.texture, old.look.texture);
    ASSERT_EQ(now.triangles.size(), old.triangles.size());
    for (std::size_t f = 0; f < old.triangles.size(); ++f) {
        for (const int i : {0, 1, 2})
            EXPECT_EQ(now.points[now.triangles[f][i]], old.points[old.triangles[f][i]]);
        const auto groups = [f](const TriangleSheet& sheet) {
            return sheet.look.groups[f] ? *sheet.look.groups[f] : std::vector<std::string>();
        };
        EXPECT_EQ(groups(now), groups(old));
    }
    EXPECT_EQ(group_names(after), (std::vector<std::string>{"front", "left wing", "rim"}));
}

TEST_F(Cut, KeepsMaterialAxesInPly) {
    write("mesh.ply",
          "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
          "element face 2\nproperty list uchar int vertex_indices\nproperty double axis_x\n"
          "property double axis_y\nproperty double axis_z\nend_header\n"
          "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 1 0.5 0\n3 0 2 3 0 1 0\n");
    write("edges.txt", "0 2\n");
    const auto result =
        test::run_sherd({"cut", "mesh.ply", "--edges", "edges.txt", "-o", "out.ply"}, directory.path);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const TriangleSheet now = triangle_sheet(read_cut(directory.path / "out.ply"));
    EXPECT_EQ(now.points.size(), 6U);
    EXPECT_EQ(now.look.axis, (std::vector<Eigen::Vector3d>{{1, 0.5, 0}, {0, 1, 0}}));
}

TEST_F(Cut, WritesOffAndTakesEndingsInCapitals) {
    write_mesh(triangle_sheet(test::grid(3, 1)), directory.path / "mesh.obj");
    write("edges.txt", "1 5\n");
    for (const char* output : {"out.off", "OUT.PLY"}) {
        const auto result =
            test::run_sherd({"cut", "mesh.obj", "--edges", "edges.txt", "-o", output}, directory.path);
        ASSERT_EQ(result.exit_code, 0) << result.err;
        EXPECT_EQ(read_cut(directory.path / output).number_of_vertices(), 10U);
    }
}

TEST_F(Cut, KeepsAFileThatExists) {
    write_mesh(triangle_sheet(test::grid(2, 2)), directory.path / "mesh.obj");
    write("edges.txt", "1 4\n");
    write("out.obj", "mine");
    EXPECT_EQ(cut().exit_code, 2);
    EXPECT_EQ(std::filesystem::file_size(directory.path / "out.obj"), 4u);
    EXPECT_EQ(cut({"--force"}).exit_code, 0);
    EXPECT_EQ(test::run_sherd({"cut", "mesh.obj", "--edges", "edges.txt", "-o", "out.stl"}, directory.path)
                  .exit_code,
              2);
}

}  // namespace
}  // namespace sherd
