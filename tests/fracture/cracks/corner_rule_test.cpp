// SPDX-License-Identifier: GPL-3.0-or-later
// Failures of random edges in random meshes are compared with the corner rule, a reference without common
// code. tests/CMakeLists.txt has the number of cases of each property.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <ostream>

#include "tests/support/mesh/crack_agreement.h"
#include "tests/support/mesh/crack_order.h"
#include "tests/support/mesh/random_edges.h"
#include "tests/support/mesh/random_mesh.h"

namespace sherd {
namespace test {

struct CrackCase {
    MeshRecipe mesh;
    EdgeRecipe edges;
};

void showValue(const CrackCase& drawn, std::ostream& out) {
    out << drawn.mesh << "; " << drawn.edges;
}

rc::Gen<CrackCase> crack_case() {
    using rc::gen::inRange;
    const auto mesh = rc::gen::build<MeshRecipe>(
        rc::gen::set(&MeshRecipe::shape, inRange(0, shape_count)),
        rc::gen::set(&MeshRecipe::columns, inRange(1, 6)), rc::gen::set(&MeshRecipe::rows, inRange(1, 5)),
        rc::gen::set(&MeshRecipe::centres, inRange(0, 5)), rc::gen::set(&MeshRecipe::flips, inRange(0, 20)),
        rc::gen::set(&MeshRecipe::holes, inRange(0, 4)),
        rc::gen::set(&MeshRecipe::seed, inRange(0u, 1u << 31)));
    const auto edges =
        rc::gen::build<EdgeRecipe>(rc::gen::set(&EdgeRecipe::pattern, inRange(0, pattern_count)),
                                   rc::gen::set(&EdgeRecipe::amount, inRange(0, 101)),
                                   rc::gen::set(&EdgeRecipe::seed, inRange(0u, 1u << 31)));
    // full size from the first case on: rapidcheck would keep every number small at first
    return rc::gen::resize(rc::kNominalSize,
                           rc::gen::build<CrackCase>(rc::gen::set(&CrackCase::mesh, mesh),
                                                     rc::gen::set(&CrackCase::edges, edges)));
}

}  // namespace test

namespace {

using test::CrackCase;
using test::Random;

/// Mesh of a case, and its edges that are to fail.
struct Drawn {
    explicit Drawn(const CrackCase& drawn)
        : mesh(test::random_mesh(drawn.mesh)),
          failed(test::random_edges(mesh, drawn.edges)),
          random(drawn.edges.seed + 1) {}
    Mesh mesh;
    std::vector<Edge> failed;
    Random random;
};

void expect_agreement(const Mesh& before, const std::vector<Edge>& failed, const CrackMesh& after) {
    RC_ASSERT(test::disagreement(before, failed, after) == std::string());
}

// The random meshes must be manifolds: otherwise the rule would say nothing about CrackMesh.
RC_GTEST_PROP(CornerRule, RandomMeshesAreManifolds, ()) {
    const Drawn drawn(*test::crack_case());
    RC_ASSERT(test::manifold_fault(drawn.mesh) == std::string());
    RC_ASSERT(!drawn.mesh.is_empty());
}

RC_GTEST_PROP(CornerRule, HoldsForABatch, ()) {
    const Drawn drawn(*test::crack_case());
    CrackMesh cracks(drawn.mesh);
    cracks.fail(drawn.failed);
    expect_agreement(drawn.mesh, drawn.failed, cracks);
}

RC_GTEST_PROP(CornerRule, HoldsEdgeByEdgeInAnyOrder, ()) {
    Drawn drawn(*test::crack_case());
    test::shuffle(drawn.failed, drawn.random);
    expect_agreement(drawn.mesh, drawn.failed, test::cracked_one_by_one(drawn.mesh, drawn.failed));
}

RC_GTEST_PROP(CornerRule, HoldsInRandomBatches, ()) {
    Drawn drawn(*test::crack_case());
    test::shuffle(drawn.failed, drawn.random);
    expect_agreement(drawn.mesh, drawn.failed,
                     test::cracked_in_batches(drawn.mesh, drawn.failed, drawn.random));
}

// The rule holds after each failure, not only at the end.
RC_GTEST_PROP(CornerRule, HoldsAfterEveryEdge, ()) {
    Drawn drawn(*test::crack_case());
    test::shuffle(drawn.failed, drawn.random);
    CrackMesh cracks(drawn.mesh);
    std::vector<Edge> so_far;
    for (const Edge edge : std::span(drawn.failed).first(std::min<std::size_t>(drawn.failed.size(), 6))) {
        cracks.fail(std::array{edge});
        so_far.push_back(edge);
        expect_agreement(drawn.mesh, so_far, cracks);
    }
}

// The reported changes must be complete: replaying the splits on the old faces gives the new ones.
RC_GTEST_PROP(CornerRule, ChangesAreReportedInFull, ()) {
    const Drawn drawn(*test::crack_case());
    CrackMesh cracks(drawn.mesh);
    const auto before = test::triangles_of(drawn.mesh);
    const CrackMesh::Change change = cracks.fail(drawn.failed);
    std::vector<int> origin(drawn.mesh.number_of_vertices());
    for (std::size_t v = 0; v < origin.size(); ++v) origin[v] = static_cast<int>(v);
    for (const WithParents<Vertex>& vertex : change.topology.vertices) {
        RC_ASSERT(vertex.element.idx() == origin.size());
        RC_ASSERT(vertex.is_copy());
        origin.push_back(origin[vertex.parent()]);
    }
    RC_ASSERT(origin.size() == cracks.mesh().number_of_vertices());
    std::size_t edges = drawn.mesh.number_of_edges();
    for (const auto& [edge, created] : change.topology.opened) {
        RC_ASSERT(created.idx() == edges++);
        RC_ASSERT(cracks.original(created).idx() == edge.idx());
    }
    const auto after = test::triangles_of(cracks.mesh());
    const auto& reported = change.topology.changed;
    for (std::size_t f = 0; f < after.size(); ++f) {
        if (after[f] == before[f]) continue;
        for (const int i : {0, 1, 2}) RC_ASSERT(origin[after[f][i]] == before[f][i]);
        RC_ASSERT(std::binary_search(reported.begin(), reported.end(), Face(static_cast<unsigned>(f))));
    }
}

}  // namespace
}  // namespace sherd
