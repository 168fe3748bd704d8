// SPDX-License-Identifier: GPL-3.0-or-later
// Sums over patches of hinges must follow a change of triangles in all faces whose patches change. If they
// did not, a face would bend by removed hinges or by hinges of other faces, or a growing crack would cost a
// pass over all patches of the sheet.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/bending/coupled_bending.h"
#include "core/membrane/side_curvature.h"
#include "tests/support/shell/advanced_sheet.h"
#include "tests/support/shell/uneven_patch.h"

namespace sherd {
namespace {

/// All sums over patches, with a clamp at each side on the rim.
struct Summed {
    Summed(const Shell& shell, const std::vector<MirrorHinge>& mirrors)
        : folds(shell, mirrors), faces(shell, folds), sides(shell, folds) {}

    std::vector<Index> follow(const ShellChange& change) {
        folds.follow(change);
        sides.follow(change);
        return faces.follow(change);
    }
    /// Mirror hinges at present.
    std::vector<MirrorHinge> mirrors() const {
        std::vector<MirrorHinge> all;
        for (std::size_t i = 0; i < folds.all_mirrors().size(); ++i) all.push_back(folds.all_mirrors()[i]);
        return all;
    }

    Folds folds;
    FaceCurvature faces;
    SideCurvature sides;
};

std::vector<MirrorHinge> clamped_rim(const Shell& shell) {
    const std::vector<char> all(shell.rest.cols(), 1);
    std::vector<MirrorHinge> mirrors;
    for (const TriangleEdge& side : boundary_triangle_edges(shell, all))
        mirrors.push_back(clamp_hinge(shell, side, 1));
    return mirrors;
}

/// Sheet of drawn_sheet(), or a sheet so rough that some of its hinges, and not always the same, are
/// creases.
BreakableShell drawn_or_rough(unsigned shape, unsigned seed) {
    if (shape < test::sheet_shapes) return BreakableShell({test::directed_input(shape, seed)});
    SheetInput input = test::directed_input(0, seed);
    test::Random random(seed);
    for (const Vertex v : input.mesh.vertices()) {
        const Point& at = input.mesh.point(v);
        input.mesh.point(v) = Point(at.x(), at.y(), at.z() + random.uniform(-0.04, 0.04));
    }
    return BreakableShell({input});
}

template <class Shares>
bool same_shares(const Shares& some, const Shares& others) {
    return std::ranges::equal(some, others, [](const Patches::Share& one, const Patches::Share& other) {
        return one.fold == other.fold && one.weight == other.weight;
    });
}

void expect_same_patches(const Shell& shell, const Patches& followed, const Patches& anew) {
    for (Index face = 0; face < static_cast<Index>(shell.triangles.size()); ++face) {
        RC_ASSERT(followed.triangle(face).corners == anew.triangle(face).corners);
        RC_ASSERT(followed.triangle(face).area == anew.triangle(face).area);
        for (int side = 0; side < 3; ++side) {
            RC_ASSERT(followed.fold_at(face, side) == anew.fold_at(face, side));
            RC_ASSERT(followed.side_length({face, side}) == anew.side_length({face, side}));
            const Vector3d target(0.3, -1, 0.7);
            RC_ASSERT(same_shares(followed.shares({face, side}, target), anew.shares({face, side}, target)));
        }
    }
    for (Index edge = 0; edge < static_cast<Index>(shell.edge_hinge.size()); ++edge) {
        const auto one = followed.sides_of(edge), other = anew.sides_of(edge);
        RC_ASSERT(one.has_value() == other.has_value());
        for (const std::size_t i : {0, 1}) {
            if (!one) break;
            RC_ASSERT((*one)[i].triangle == (*other)[i].triangle);
            RC_ASSERT((*one)[i].corner == (*other)[i].corner);
        }
    }
}

void expect_same_sums(const Shell& shell, const Summed& followed) {
    const Summed anew(shell, followed.mirrors());
    expect_same_patches(shell, followed.faces.around(), anew.faces.around());
    for (std::size_t face = 0; face < shell.triangles.size(); ++face) {
        const auto same = [](const FaceCurvature::Term& one, const FaceCurvature::Term& other) {
            return one.fold == other.fold && one.per_angle == other.per_angle;
        };
        RC_ASSERT(std::ranges::equal(followed.faces.terms(face), anew.faces.terms(face), same));
        for (int side = 0; side < 3; ++side)
            RC_ASSERT(same_shares(followed.sides.shares(face, side), anew.sides.shares(face, side)));
    }
}

// Sums must depend on the present shell alone and not on its history, to the last bit: also beside clamps
// that are split, where hinges get other numbers, and where a hinge becomes a crease or ceases to be one.
RC_GTEST_PROP(AdvancedCurvature, IsThatOfTheShellAsItIs, ()) {
    const unsigned shape = *rc::gen::inRange(0u, test::sheet_shapes + 4),
                   seed = *rc::gen::inRange(0u, 1u << 30);
    BreakableShell sheet = drawn_or_rough(shape, seed);
    const Shell& shell = sheet.mechanics();
    Summed followed(shell, clamped_rim(shell));
    test::Advances advances(sheet, seed + 1);
    for (int i = 0; i < 12; ++i) {
        const auto advanced = advances.next();
        if (!advanced) continue;
        followed.follow(advanced->change.shell);
        if (i == 4) expect_same_sums(shell, followed);
        if (!advances.random_bool()) continue;
        if (const auto change = advances.fail(advanced->halfedge)) followed.follow(change->shell);
    }
    expect_same_sums(shell, followed);
}

// Energies keep the vertices on which each face depends, and update them near a change alone. A face that
// kept other vertices would add its stiffness to theirs, and steps would not converge.
RC_GTEST_PROP(AdvancedCurvature, GivesTheHessianOfTheShellAsItIs, ()) {
    const unsigned shape = *rc::gen::inRange(0u, test::sheet_shapes), seed = *rc::gen::inRange(0u, 1u << 30);
    BreakableShell sheet = drawn_or_rough(shape, seed);
    const Shell& shell = sheet.mechanics();
    CoupledBending followed(shell, clamped_rim(shell));
    test::Advances advances(sheet, seed + 1);
    const auto hessian = [&](const CoupledBending& bending) {
        return test::hessian_of(bending, shell.rest, Curvature::exact);
    };
    hessian(followed);  // so that there is something to update
    for (int i = 0; i < 6; ++i) {
        const auto advanced = advances.next();
        if (!advanced) continue;
        followed.topology_changed(advanced->change.shell, {});
        if (i % 2 == 1) hessian(followed);
        if (!advances.random_bool()) continue;
        if (const auto change = advances.fail(advanced->halfedge))
            followed.topology_changed(change->shell, {});
    }
    const Mirrors& mirrors = followed.all_folds().all_mirrors();
    std::vector<MirrorHinge> now;
    for (std::size_t i = 0; i < mirrors.size(); ++i) now.push_back(mirrors[i]);
    const Eigen::MatrixXd expected = hessian(CoupledBending(shell, now));
    RC_ASSERT((hessian(followed) - expected).norm() <= 1e-12 * expected.norm());
}

// follow() must return exactly the faces whose terms it computed again.
TEST(AdvancedCurvature, IsRebuiltAroundTheChangeAlone) {
    SheetInput input = test::directed_input(0, 3);
    input.mesh = generate_rectangle(1, 0.7, {.edge_length = 0.025, .seed = 3});
    input.axes.assign(input.mesh.number_of_faces(), Vector3d::UnitX());
    input.strength.factors.clear();
    input.thickness.clear();
    BreakableShell sheet({input});
    const Shell& shell = sheet.mechanics();
    Summed followed(shell, clamped_rim(shell));
    test::Advances advances(sheet, 4);
    std::size_t most = 0, reshaped = 0;
    for (int i = 0; i < 200; ++i) {
        const auto advanced = advances.next();
        if (!advanced || advanced->change.shell.reshaped.empty()) continue;
        const std::size_t mirrors = followed.folds.all_mirrors().size();
        std::vector<std::vector<FaceCurvature::Term>> before;
        for (std::size_t face = 0; face < shell.triangles.size() - advanced->change.shell.faces.size();
             ++face)
            before.emplace_back(followed.faces.terms(face).begin(), followed.faces.terms(face).end());
        const std::vector<Index> changed = followed.follow(advanced->change.shell);
        most = std::max(most, changed.size());
        reshaped = std::max(reshaped, advanced->change.shell.reshaped.size());
        if (followed.folds.all_mirrors().size() > mirrors) continue;
        for (std::size_t face = 0; face < before.size(); ++face) {
            if (std::ranges::binary_search(changed, static_cast<Index>(face))) continue;
            const auto now = followed.faces.terms(face);
            ASSERT_EQ(now.size(), before[face].size());
            for (std::size_t t = 0; t < now.size(); ++t) {
                EXPECT_EQ(now[t].fold, before[face][t].fold);
                EXPECT_EQ(now[t].per_angle, before[face][t].per_angle);
            }
        }
    }
    std::printf("of %zu faces at most %zu reshaped, %zu made anew\n", shell.triangles.size(), reshaped, most);
    EXPECT_GT(reshaped, 0u);
    EXPECT_LT(most, reshaped + 40);
}

}  // namespace
}  // namespace sherd
