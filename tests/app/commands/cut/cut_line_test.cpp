// SPDX-License-Identifier: GPL-3.0-or-later
// `sherd cut --line`: if one of these tests failed, a mesh would not be cut where the line was drawn.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "meshops/face_groups.h"
#include "meshops/generate/generate.h"
#include "meshops/mesh_measures.h"
#include "meshops/read_write/read_mesh.h"
#include "meshops/read_write/write_mesh.h"
#include "tests/support/mesh/mesh_shapes.h"
#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

using Eigen::Vector3d;

class CutLine : public ::testing::Test {
  protected:
    void write(const std::string& name, const std::string& text) {
        std::ofstream(directory.path / name) << text;
    }
    nlohmann::json cut(const Mesh& mesh, const std::string& line, std::vector<std::string> more = {}) {
        write_mesh(triangle_sheet(mesh), directory.path / "mesh.ply");
        write("line.txt", line);
        std::vector<std::string> arguments{"cut", "mesh.ply", "--line",  "line.txt",
                                           "-o",  "out.ply",  "--force", "--json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const auto result = run_sherd(arguments, directory.path);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return result.exit_code == 0 ? nlohmann::json::parse(result.out) : nlohmann::json();
    }
    void expect_refusal(const Mesh& mesh, const std::string& line, const std::string& message) {
        write_mesh(triangle_sheet(mesh), directory.path / "mesh.ply");
        write("line.txt", line);
        const auto result =
            run_sherd({"cut", "mesh.ply", "--line", "line.txt", "-o", "out.ply"}, directory.path);
        EXPECT_EQ(result.exit_code, 2);
        EXPECT_NE(result.err.find(message), std::string::npos) << result.err;
        EXPECT_FALSE(std::filesystem::exists(directory.path / "out.ply"));
    }
    Mesh output(const std::string& name = "out.ply") {
        std::vector<std::string> warnings;
        return read_mesh(directory.path / name, {}, warnings);
    }
    TemporaryDirectory directory;
};

// A line from rim to rim must give two pieces, each with the area on its side of the line, with and without
// moving vertices.
TEST_F(CutLine, DividesARectangleWhereItIsDrawn) {
    const Mesh mesh = generate_rectangle(1, 1, {.edge_length = 0.06});
    for (const char* keep : {"", "--keep-vertices"}) {
        const auto json = cut(mesh, "0.1 0 0\n0.83 1 0\n",
                              *keep ? std::vector<std::string>{keep} : std::vector<std::string>{});
        EXPECT_EQ(json["fragments"], 2);
        EXPECT_NEAR(json["line_length"], std::hypot(0.73, 1), 1e-9);
        EXPECT_GT(json["smallest_angle_made"], *keep ? 0 : 15);
        EXPECT_EQ(json["vertices_moved"] == 0, *keep != 0);
        const Mesh halves = output();
        double left = 0, area = 0;
        for (const Face face : halves.faces()) {
            const Vector3d middle = centroid(halves, face);
            area += sherd::face_area(halves, face);
            if (middle.x() < 0.1 + 0.73 * middle.y()) left += sherd::face_area(halves, face);
        }
        EXPECT_NEAR(area, 1, 1e-9);
        EXPECT_NEAR(left, (0.1 + 0.83) / 2, 1e-6) << "the cut is straight";
    }
}

TEST_F(CutLine, CutsOutAClosedPolygonAndACircle) {
    const Mesh mesh = generate_rectangle(1, 1, {.edge_length = 0.06});
    const auto square = cut(mesh, "0.3 0.3 0\n0.7 0.31 0\n0.68 0.7 0\n0.3 0.69 0\n0.3 0.3 0\n");
    EXPECT_EQ(square["fragments"], 2);
    std::string circle;
    for (int i = 0; i <= 60; ++i) {
        const double angle = 2 * std::acos(-1.0) * (i % 60) / 60;
        circle += std::to_string(0.5 + 0.3 * std::cos(angle)) + " " +
                  std::to_string(0.5 + 0.3 * std::sin(angle)) + " 0\n";
    }
    const auto round = cut(mesh, circle);
    EXPECT_EQ(round["fragments"], 2);
    EXPECT_NEAR(round["line_length"], 2 * std::acos(-1.0) * 0.3, 0.02 * 2 * std::acos(-1.0) * 0.3);
}

TEST_F(CutLine, CrossesItselfAndOtherLines) {
    const Mesh mesh = generate_rectangle(1, 1, {.edge_length = 0.06});
    EXPECT_EQ(cut(mesh, "0 0.2 0\n1 0.7 0\n\n# another\n0.4 1 0\n0.61 0 0\n")["fragments"], 4);
}

// A coarse line on a curved sheet must follow the great circle, within 2 percent of its length. It opens the
// sheet, but does not separate it.
TEST_F(CutLine, FollowsACurvedSurface) {
    const Mesh mesh = generate_sphere(1, {.edge_length = 0.1});
    const auto json = cut(mesh, "1 0 0\n0 0.6 0.8\n");
    EXPECT_EQ(json["fragments"], 1);
    EXPECT_NEAR(json["line_length"], std::acos(0.0), 0.02 * std::acos(0.0));
    EXPECT_EQ(json["edges_opened"], json["edges_requested"]);
}

TEST_F(CutLine, KeepsTextureAndGroups) {
    write("mesh.obj",
          "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nvt 0 0\nvt 0.5 0\nvt 1 0\nvt 0 1\nvt 0.5 1\n"
          "vt 1 1\ng left\nf 1/1 2/2 5/5\nf 1/1 5/5 4/4\ng right\nf 2/2 3/3 6/6\nf 2/2 6/6 5/5\n");
    write("line.txt", "0 0.3 0\n2 0.6 0\n");
    const auto result = run_sherd({"cut", "mesh.obj", "--line", "line.txt", "-o", "out.obj"}, directory.path);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const TriangleSheet sheet = triangle_sheet(output("out.obj"));
    ASSERT_EQ(sheet.look.texture.size(), sheet.triangles.size());
    for (std::size_t f = 0; f < sheet.triangles.size(); ++f) {
        const std::string side = sheet.look.groups[f]->front();
        for (int i = 0; i < 3; ++i) {
            const Vector3d at = sheet.points[sheet.triangles[f][i]];
            EXPECT_LT((sheet.look.texture[f][i] - Eigen::Vector2d(at.x() / 2, at.y())).norm(), 1e-9);
            EXPECT_TRUE(side == "left" ? at.x() <= 1 : at.x() >= 1);
        }
    }
}

TEST_F(CutLine, SaysWhatIsWrongAndWhere) {
    const Mesh mesh = generate_rectangle(1, 1, {.edge_length = 0.1});
    expect_refusal(mesh, "0.1 0.1 0\n0.5 0.5 3\n", "line.txt:2: the point (0.5, 0.5, 3)");
    expect_refusal(mesh, "0.1 0.1 0\n", "line.txt:1: this point stands alone");
    expect_refusal(mesh, "0.1 0.1 0\n0.1 0.1 0\n", "line.txt:1: a line needs two different points");
    expect_refusal(mesh, "0.1 0.1\n0.5 0.5 0\n", "line.txt:1:");
    expect_refusal(mesh, "0.1 0.1 x\n0.5 0.5 0\n", "line.txt:1:");
    expect_refusal(mesh, "0.1 0.1 0 1\n0.5 0.5 0\n", "is one too many");
    expect_refusal(mesh, "# none\n", "holds no point");
    expect_refusal(mesh, "0 0 0\n1 0 0\n", "lies on the boundary");
    Polygon frame;
    frame.outline = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    frame.holes = {{{-0.4, -0.4}, {0.4, -0.4}, {0.4, 0.4}, {-0.4, 0.4}}};
    const Mesh ring = generate_polygon(frame, {.edge_length = 0.1});
    expect_refusal(ring, "-0.8 0.1 0\n0.8 0.05 0\n", "line.txt:2: the line leaves the mesh");
    const auto none = run_sherd({"cut", "mesh.ply", "-o", "out.ply"}, directory.path);
    EXPECT_NE(none.err.find("--edges FILE or --line FILE"), std::string::npos) << none.err;
}

}  // namespace
}  // namespace sherd::test
