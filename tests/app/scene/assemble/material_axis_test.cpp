// SPDX-License-Identifier: GPL-3.0-or-later
// If one of these tests failed, an orthotropic sheet would be stiff in another direction than the scene says.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "app/scene/assemble/sheet/axis_texture.h"
#include "app/scene/assemble/sheet/material_axes.h"
#include "meshops/error.h"
#include "meshops/generate/generate.h"
#include "meshops/mesh_measures.h"
#include "meshops/read_write/read_mesh.h"
#include "tests/support/mesh/ply_square.h"
#include "tests/support/program/png_file.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

constexpr double degree = pi / 180;

Mesh placed(Mesh mesh, const Eigen::Isometry3d& place) {
    for (const Vertex v : mesh.vertices()) {
        const Vector3d p = place * position(mesh, v);
        mesh.point(v) = Point(p.x(), p.y(), p.z());
    }
    return mesh;
}

std::vector<Vector3d> axes_of(const MaterialAxis& axis, const Mesh& mesh,
                              const Eigen::Isometry3d& place = Eigen::Isometry3d::Identity()) {
    std::vector<std::string> warnings;
    std::vector<Vector3d> axes = material_axes(axis, mesh, place, warnings);
    EXPECT_TRUE(warnings.empty()) << warnings.front();
    EXPECT_EQ(axes.size(), mesh.number_of_faces());
    return axes;
}

TEST(MaterialAxis, DegreesCountFromTheMeshsOwnXAxisAndTurnWithThePlace) {
    const Eigen::Isometry3d place =
        Eigen::Translation3d(1, 2, 3) * Eigen::AngleAxisd(0.7, Vector3d(1, 2, -1).normalized());
    const Mesh mesh = placed(generate_rectangle(1, 0.5, {.edge_length = 0.2}), place);
    const Vector3d expected = place.linear() * Vector3d(std::cos(30 * degree), std::sin(30 * degree), 0);
    for (const Vector3d& axis : axes_of({AxisDirection{Vector3d::UnitX(), 30}, "here"}, mesh, place))
        EXPECT_LT((axis - expected).norm(), 1e-14);
}

TEST(MaterialAxis, DirectionIsProjectedToEachFace) {
    const Mesh tube = generate_cylinder(0.1, 0.3, {.edge_length = 0.03});
    std::size_t face = 0;
    for (const Vector3d& axis : axes_of({AxisDirection{Vector3d(0, 0.01, 1)}, "here"}, tube)) {
        const Face f(static_cast<Face::size_type>(face++));
        const Vector3d a = position(tube, tube.source(tube.halfedge(f))),
                       b = position(tube, tube.target(tube.halfedge(f))),
                       c = position(tube, tube.target(tube.next(tube.halfedge(f))));
        EXPECT_NEAR(axis.dot((b - a).cross(c - a).normalized()), 0, 1e-13) << "in the face's plane";
        EXPECT_GT(axis.z(), 0.99);
        EXPECT_NEAR(axis.norm(), 1, 1e-14);
    }
}

TEST(MaterialAxis, DirectionIsTurnedInEachFace) {
    const Mesh tube = generate_cylinder(0.1, 0.3, {.edge_length = 0.03});
    const auto along = axes_of({AxisDirection{Vector3d::UnitZ()}, "here"}, tube),
               around = axes_of({AxisDirection{Vector3d::UnitZ(), 90}, "here"}, tube);
    for (std::size_t face = 0; face < along.size(); ++face) {
        EXPECT_NEAR(along[face].dot(around[face]), 0, 1e-14);
        EXPECT_LT(std::abs(around[face].z()), 0.1) << "around the tube";
    }
}

TEST(MaterialAxis, PerpendicularFacesTakeTheNextAxisAndSaySo) {
    const Mesh mesh = generate_rectangle(1, 0.5, {.edge_length = 0.2});
    std::vector<std::string> warnings;
    const auto axes = material_axes({AxisDirection{Vector3d::UnitZ()}, "here"}, mesh,
                                    Eigen::Isometry3d::Identity(), warnings);
    for (const Vector3d& axis : axes) EXPECT_LT((axis - Vector3d::UnitY()).norm(), 1e-14);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(
        warnings[0].find("here: the axis is perpendicular to " + std::to_string(axes.size()) + " faces"),
        std::string::npos)
        << warnings[0];
}

/// Texture of one row of texels for axes at these angles (degrees), in the encoding `vector`.
Image row_of(const std::vector<double>& angles) {
    Image image;
    image.width = static_cast<int>(angles.size());
    image.height = 1;
    image.colours.resize(3, image.width);
    for (int i = 0; i < image.width; ++i)
        image.colours.col(i) = Eigen::Vector3d(0.5 + 0.5 * std::cos(2 * angles[i] * degree),
                                               0.5 + 0.5 * std::sin(2 * angles[i] * degree), 0)
                                   .cast<float>();
    return image;
}

double angle_of(const Vector2d& doubled) {
    return std::atan2(doubled.y(), doubled.x()) / 2 / degree;
}

TEST(AxisTexture, MeanOf175And5DegreesIsNotUpright) {
    const Image image = row_of({175, 5});
    const auto angle = [&](double u) {
        return angle_of(doubled_direction(image, AxisEncoding::vector, Vector2d(u, 0.3)));
    };
    EXPECT_NEAR(angle(0.25), -5, 1e-4) << "the first texel's centre";
    EXPECT_NEAR(angle(0.75), 5, 1e-4);
    EXPECT_NEAR(angle(0.5), 0, 1e-4) << "half-way between them: not 90 degrees";
    EXPECT_NEAR(angle(1.0), 0, 1e-4) << "the image repeats";
    EXPECT_NEAR(angle(-3.25), 5, 1e-4);
    EXPECT_NEAR(angle(7.25), -5, 1e-4);
}

TEST(AxisTexture, VGrowsUpwards) {
    Image image;
    image.width = 1;
    image.height = 2;
    image.colours.resize(3, 2);
    image.colours << 1, 0, 0.5, 0.5, 0, 0;  // upper texel: 0 degrees, lower: 90 degrees
    EXPECT_NEAR(angle_of(doubled_direction(image, AxisEncoding::vector, Vector2d(0.1, 0.75))), 0, 1e-6);
    EXPECT_NEAR(std::abs(angle_of(doubled_direction(image, AxisEncoding::vector, Vector2d(0.1, 0.25)))), 90,
                1e-6);
}

TEST(AxisTexture, HueIsTwiceTheAngleWhateverBrightnessAndGreyIsNoDirection) {
    const std::vector<std::pair<Eigen::Vector3f, double>> hues{
        {{1, 0, 0}, 0},   {{1, 1, 0}, 30},           {{0, 0.5, 0}, 60},  {{0.2f, 1, 1}, 90},
        {{0, 0, 1}, 120}, {{0.4f, 0.2f, 0.4f}, 150}, {{1, 0.5f, 0}, 15}, {{1, 0, 0.5f}, 165}};
    Image image;
    image.width = image.height = 1;
    image.colours.resize(3, 1);
    for (const auto& [colour, degrees] : hues) {
        image.colours.col(0) = colour;
        const Vector2d doubled = doubled_direction(image, AxisEncoding::hue, Vector2d(0.5, 0.5));
        EXPECT_NEAR(std::remainder(angle_of(doubled) - degrees, 180), 0, 1e-4) << colour.transpose();
    }
    image.colours.setConstant(0.3f);
    EXPECT_EQ(doubled_direction(image, AxisEncoding::hue, Vector2d(0.5, 0.5)).norm(), 0);
}

// Two triangles in the xy plane, whose texture is first turned by 90 degrees and stretched, then mirrored
// instead.
TEST(MaterialAxis, TextureAnglesCountFromTheDirectionOfUTowardsThatOfV) {
    const TemporaryDirectory directory;
    std::vector<std::string> warnings;
    const auto mesh_with = [&](const std::string& texture) {
        return read_mesh(directory.write("square.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n" + texture +
                                                           "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n"),
                         {}, warnings);
    };
    const double angle = 20 * degree;
    const auto value = [](double x) {
        return static_cast<std::uint16_t>(std::lround((0.5 + 0.5 * x) * 65535));
    };
    const std::filesystem::path png = directory.path / "axis.png";
    write_png(png, 2, 2, {value(std::cos(2 * angle)), value(std::sin(2 * angle)), 0});
    const MaterialAxis axis{AxisTexture{png, AxisEncoding::vector}, "here"};

    const Mesh turned = mesh_with("vt 0 0\nvt 0 -1\nvt 3 -1\nvt 3 0\n");  // u along y, v along -x
    const Vector3d expected(-std::sin(angle), std::cos(angle), 0);
    for (const Vector3d& found : axes_of(axis, turned)) EXPECT_LT((found - expected).norm(), 1e-4);

    const Mesh mirrored = mesh_with("vt 0 0\nvt 1 0\nvt 1 -1\nvt 0 -1\n");  // u along x, v along -y
    const Vector3d reflected(std::cos(angle), -std::sin(angle), 0);
    for (const Vector3d& found : axes_of(axis, mirrored)) EXPECT_LT((found - reflected).norm(), 1e-4);
}

TEST(MaterialAxis, FieldOfAPlyFileIsProjectedAndTurnsWithThePlace) {
    const TemporaryDirectory directory;
    std::vector<std::string> warnings;
    const Eigen::Isometry3d place(Eigen::AngleAxisd(0.7, Vector3d(1, 2, -1).normalized()));
    const Mesh mesh =
        placed(read_mesh(directory.write("a.ply", ply_square("3 4 7", "0 -2e3 0")), {}, warnings), place);
    const auto axes = axes_of({AxisField{}, "here"}, mesh, place);
    EXPECT_LT((axes[0] - place.linear() * Vector3d(0.6, 0.8, 0)).norm(), 1e-14);
    EXPECT_LT((axes[1] - place.linear() * Vector3d(0, -1, 0)).norm(), 1e-14);
}

TEST(ReadPng, KeepsSixteenBitsAndRefusesWhatIsNoPng) {
    const TemporaryDirectory directory;
    const std::filesystem::path file = directory.path / "a.png";
    write_png(file, 5, 3, {257, 65535, 1000});
    const Image image = read_png(file);
    EXPECT_EQ(image.width, 5);
    EXPECT_EQ(image.height, 3);
    EXPECT_EQ(image.colour(4, 2), Eigen::Vector3f(257.0f / 65535, 1, 1000.0f / 65535));
    std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
    const auto message = [](const std::filesystem::path& path) -> std::string {
        try {
            read_png(path);
        } catch (const Error& error) {
            return error.what();
        }
        return "no error";
    };
    EXPECT_NE(message(file).find("a.png: damaged PNG file: "), std::string::npos) << message(file);
    // The header claims 256 million pixels, which libpng would allocate
    std::string promising = directory.contents().at(file.string());
    promising.replace(16, 8, "\0\0\x3e\x80\0\0\x3e\x80", 8);
    EXPECT_NE(message(directory.write("d.png", promising)).find("ends before all its pixels"),
              std::string::npos);
    EXPECT_NE(message(directory.write("b.png", "no image")).find("is not a PNG file"), std::string::npos);
    EXPECT_NE(message(directory.path / "c.png").find("No such file"), std::string::npos);
    EXPECT_NE(message(directory.path).find("is a folder"), std::string::npos);
}

}  // namespace
}  // namespace sherd::test
