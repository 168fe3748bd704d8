// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "meshops/read_mesh.h"
#include "meshops/write_mesh.h"
#include "tests/support/corner_rule.h"
#include "tests/support/mesh_shapes.h"
#include "tests/support/program.h"
#include "tests/support/temporary_directory.h"

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
    return read_mesh(file, {.repair = true}, warnings);
}

/// Cuts random edges of `mesh` by the program and holds every corner of the outcome against the rule.
void expect_rule_on(const std::filesystem::path& mesh_file, unsigned percent,
                    const std::filesystem::path& folder) {
    const Mesh mesh = read(mesh_file);
    const auto number = mesh.property_map<Vertex, std::uint32_t>(property::file_vertex).first;
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

    const auto before = test::triangles_of(mesh), after = test::triangles_of(read(folder / "random.ply"));
    CornerRule rule(before, failed);
    ASSERT_EQ(after.size(), before.size());
    std::map<int, int> vertex_of_root;
    for (std::size_t f = 0; f < after.size(); ++f)
        for (int i = 0; i < 3; ++i)
            ASSERT_EQ(vertex_of_root.emplace(rule.vertex(static_cast<int>(f), i), after[f][i]).first->second,
                      after[f][i]);
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

// Closed, with a hole, of genus one; few cracks that end inside, and nearly everything broken.
TEST_F(Cut, FollowsTheCornerRuleOnAnySurface) {
    for (const bool wrap : {false, true})
        for (const unsigned percent : {5u, 30u, 70u, 100u}) {
            write_mesh(triangle_sheet(test::grid(9, 8, true, wrap)), directory.path / "mesh.obj");
            expect_rule_on(directory.path / "mesh.obj", percent, directory.path);
        }
}

// Meshes that nobody here made: they stand beside the project where there are any.
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
