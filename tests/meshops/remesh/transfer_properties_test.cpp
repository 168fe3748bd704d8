// SPDX-License-Identifier: GPL-3.0-or-later
// If properties were transferred wrongly, pins, textures and fibres would be at wrong places on a remeshed
// mesh.
#include <gtest/gtest.h>

#include <fstream>

#include "meshops/attributes.h"
#include "meshops/face_groups.h"
#include "meshops/mesh_measures.h"
#include "meshops/read_write/read_mesh.h"
#include "meshops/remesh/remesh.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Square of 20 x 20 cells of 1 m, half of it in group `left`. Texture coordinates are the places over 20 m,
/// and are shifted by 5 from x = 10 m on, where the texture has a seam.
Mesh two_halves(const std::string& name) {
    const test::TemporaryDirectory directory;
    std::ofstream file(directory.path / name);
    constexpr int n = 20;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) file << "v " << i << " " << j << " 0\n";
    for (const int aside : {0, 5})
        for (int j = 0; j <= n; ++j)
            for (int i = 0; i <= n; ++i) file << "vt " << i / 20.0 + aside << " " << j / 20.0 << "\n";
    for (int i = 0; i < n; ++i) {
        file << "g " << (i < n / 2 ? "left" : "right") << "\n";
        const int island = i < n / 2 ? 0 : (n + 1) * (n + 1);
        for (int j = 0; j < n; ++j) {
            const int a = j * (n + 1) + i + 1, b = a + 1, c = b + n + 1, d = a + n + 1;
            file << "f " << a << "/" << a + island << " " << b << "/" << b + island << " " << c << "/"
                 << c + island << " " << d << "/" << d + island << "\n";
        }
    }
    file.close();
    std::vector<std::string> warnings;
    return read_mesh(directory.path / name, {}, warnings);
}

TEST(TransferProperties, TextureAndGroupsChangeAtTheSameLine) {
    for (const double edge_length : {0.7, 2.3}) {
        const Remeshed result = remesh(two_halves("halves.obj"), {edge_length});
        EXPECT_FALSE(result.texture_lost);
        const auto [texture, has_texture] = find_property(result.mesh, attribute::texture);
        const auto [groups, has_groups] = find_property(result.mesh, attribute::groups);
        ASSERT_TRUE(has_texture && has_groups);
        for (const Face face : result.mesh.faces()) {
            const bool is_left = centroid(result.mesh, face).x() < 10;
            EXPECT_EQ(groups[face]->front(), is_left ? "left" : "right");
            const auto corners = face_points(result.mesh, face);
            for (std::size_t i = 0; i < 3; ++i) {
                const Vector2d expected = corners[i].head<2>() / 20 + Vector2d(is_left ? 0 : 5, 0);
                EXPECT_LT((texture[face][i] - expected).norm(), 1e-9) << corners[i].transpose();
                EXPECT_TRUE(is_left ? corners[i].x() < 10 + 1e-9 : corners[i].x() > 10 - 1e-9)
                    << "the line moved";
            }
        }
    }
}

TEST(TransferProperties, AxesAreThoseBelow) {
    Mesh mesh = two_halves("halves.obj");
    auto axis = add_property(mesh, attribute::axis);
    for (const Face face : mesh.faces())
        axis[face] = centroid(mesh, face).y() < 10 ? Vector3d::UnitX() : Vector3d::UnitY();
    const Mesh result = remesh(mesh, {1.3}).mesh;
    const auto [carried, exists] = find_property(result, attribute::axis);
    ASSERT_TRUE(exists);
    for (const Face face : result.faces())
        if (const double y = centroid(result, face).y(); std::abs(y - 10) > 0.5) {
            EXPECT_EQ(carried[face], y < 10 ? Vector3d::UnitX() : Vector3d::UnitY());
        }
}

// A remeshed painted scan must neither lose its paint nor get it at wrong places.
TEST(TransferProperties, ColoursAreThoseBelow) {
    Mesh mesh = two_halves("halves.obj");
    auto at_vertex = add_property(mesh, attribute::vertex_colour);
    for (const Vertex v : mesh.vertices()) {
        const auto ramp = static_cast<std::uint8_t>(10 * position(mesh, v).x());
        at_vertex[v] = {ramp, 7, 0, 255};
    }
    auto of_face = add_property(mesh, attribute::face_colour);
    for (const Face face : mesh.faces())
        of_face[face] = centroid(mesh, face).x() < 10 ? Colour{1, 2, 3, 255} : Colour{4, 5, 6, 255};
    const Mesh result = remesh(mesh, {1.3}).mesh;
    const auto [vertex, has_vertex] = find_property(result, attribute::vertex_colour);
    const auto [face_colour, has_face] = find_property(result, attribute::face_colour);
    ASSERT_TRUE(has_vertex && has_face);
    for (const Vertex v : result.vertices()) {
        EXPECT_NEAR(vertex[v][0], 10 * position(result, v).x(), 0.5 + 1e-9);
        EXPECT_EQ(vertex[v][1], 7);
    }
    for (const Face face : result.faces())
        EXPECT_EQ(face_colour[face][0], centroid(result, face).x() < 10 ? 1 : 4);
}

// If all seams of a texture in shreds were kept, nothing could be remeshed.
TEST(TransferProperties, ATextureInShredsIsLostAndItSaysSo) {
    Mesh mesh = two_halves("halves.obj");
    auto texture = find_property(mesh, attribute::texture).first;
    for (const Face face : mesh.faces())
        for (Vector2d& at : texture[face]) at.x() += 2.0 * face.idx();
    const Remeshed result = remesh(mesh, {2.3});
    EXPECT_TRUE(result.texture_lost);
    EXPECT_LT(result.mesh.number_of_faces(), 300u);
    EXPECT_FALSE((find_property(result.mesh, attribute::texture).second));
}

}  // namespace
}  // namespace sherd
