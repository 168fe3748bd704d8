// SPDX-License-Identifier: GPL-3.0-or-later
// The surface may depend on which edges failed, never on their order.
#include "tests/support/mesh/crack_order.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <iostream>
#include <string>

#include "meshops/generate/generate.h"
#include "meshops/read_write/read_mesh.h"
#include "meshops/topology/components.h"
#include "tests/support/mesh/crack_agreement.h"
#include "tests/support/mesh/random_edges.h"
#include "tests/support/mesh/random_mesh.h"

namespace sherd {
namespace {

using test::Random;

/// Cracked mesh in a form that does not depend on the numbers of its vertices and edges.
struct Surface {
    std::vector<std::size_t> vertex_of_corner;  ///< [3 F] first corner with the same vertex
    std::vector<EdgeState> state_of_side;       ///< [3 F] state of each side's edge
    std::vector<std::size_t> opposite_of_side;  ///< [3 F] side of the other face; its own on the boundary
    std::vector<Vertex> original_of_corner;     ///< [3 F] vertex of the unfractured mesh
    std::array<std::size_t, 4> counts;          ///< numbers of vertices, edges, faces, components
    bool operator==(const Surface&) const = default;
};

Surface surface_of(const CrackMesh& cracks) {
    const Mesh& mesh = cracks.mesh();
    Surface surface;
    std::vector<std::size_t> first(mesh.number_of_vertices(), SIZE_MAX), side(mesh.number_of_halfedges());
    std::size_t corner = 0;
    for (const Face face : mesh.faces())
        for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(face))) {
            first[mesh.target(h)] = std::min(first[mesh.target(h)], corner);
            side[h] = corner++;
        }
    for (const Face face : mesh.faces())
        for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(face))) {
            surface.vertex_of_corner.push_back(first[mesh.target(h)]);
            surface.state_of_side.push_back(cracks.state(mesh.edge(h)));
            const Halfedge other = mesh.opposite(h);
            surface.opposite_of_side.push_back(side[mesh.is_border(other) ? h : other]);
            surface.original_of_corner.push_back(cracks.original(mesh.target(h)));
        }
    surface.counts = {mesh.number_of_vertices(), mesh.number_of_edges(), mesh.number_of_faces(),
                      static_cast<std::size_t>(connected_components(mesh).count)};
    return surface;
}

/// Lets the same edges fail in 20 random orders, alternately one by one and in random batches.
void expect_one_surface(const Mesh& mesh, std::vector<Edge> failed, unsigned seed) {
    Random random(seed);
    CrackMesh at_once(mesh);
    at_once.fail(failed);
    ASSERT_EQ(test::disagreement(mesh, failed, at_once), "");
    const Surface expected = surface_of(at_once);
    for (int order = 0; order < 20; ++order) {
        test::shuffle(failed, random);
        const CrackMesh cracks = order % 2 == 0 ? test::cracked_one_by_one(mesh, failed)
                                                : test::cracked_in_batches(mesh, failed, random);
        ASSERT_TRUE(surface_of(cracks) == expected) << "order " << order;
        ASSERT_EQ(test::disagreement(mesh, failed, cracks), "") << "order " << order;
    }
}

void expect_one_surface_for_all_patterns(const Mesh& mesh) {
    for (int pattern = 0; pattern < test::pattern_count; ++pattern)
        for (const int amount : {10, 60}) {
            const test::EdgeRecipe recipe{pattern, amount, 7};
            SCOPED_TRACE(testing::Message() << recipe);
            expect_one_surface(mesh, test::random_edges(mesh, recipe), 3);
        }
}

TEST(CrackOrder, DoesNotMatterOnRandomMeshes) {
    Random random(11);
    for (unsigned seed = 0; seed < 400; ++seed) {
        const test::MeshRecipe mesh{static_cast<int>(seed) % test::shape_count,
                                    1 + static_cast<int>(random.below(8)),
                                    1 + static_cast<int>(random.below(8)),
                                    static_cast<int>(random.below(8)),
                                    static_cast<int>(random.below(60)),
                                    static_cast<int>(random.below(8)),
                                    seed};
        const test::EdgeRecipe edges{static_cast<int>(random.below(test::pattern_count)),
                                     static_cast<int>(random.below(101)), seed};
        SCOPED_TRACE(testing::Message() << mesh << "; " << edges);
        const Mesh drawn = test::random_mesh(mesh);
        expect_one_surface(drawn, test::random_edges(drawn, edges), seed);
    }
}

TEST(CrackOrder, DoesNotMatterOnGeneratedMeshes) {
    for (const Layout layout : {Layout::delaunay, Layout::structured}) {
        const GenerateOptions options{0.05, layout, 4};
        expect_one_surface_for_all_patterns(generate_rectangle(0.6, 0.4, options));
        expect_one_surface_for_all_patterns(generate_cylinder(0.1, 0.4, options));
    }
    const GenerateOptions options{.edge_length = 0.05};
    expect_one_surface_for_all_patterns(generate_disc(0.3, options));
    expect_one_surface_for_all_patterns(generate_sphere(0.2, options));
    const std::array profile{Eigen::Vector2d(0, 0), Eigen::Vector2d(0.15, 0.02), Eigen::Vector2d(0.25, 0.2)};
    expect_one_surface_for_all_patterns(generate_revolution(profile, options));
}

// Real meshes are not part of the project: they are used if they are present beside it.
TEST(CrackOrder, DoesNotMatterOnRealMeshes) {
    const auto folder = std::filesystem::path(__FILE__).parent_path() / "../../../shared/data";
    if (!std::filesystem::is_directory(folder)) {
        std::cout << "NOTE: no real meshes here (" << folder.lexically_normal()
                  << "); this test checked nothing\n";
        return;
    }
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".obj") continue;
        SCOPED_TRACE(entry.path().filename());
        std::vector<std::string> warnings;
        expect_one_surface_for_all_patterns(read_mesh(entry.path(), {.repair = Repair::all}, warnings));
    }
}

}  // namespace
}  // namespace sherd
