// SPDX-License-Identifier: GPL-3.0-or-later
// Where a crack changes triangles, candidate pairs are searched around the crack alone. A missed pair would
// let a sheet pass through itself; a stale pair would push removed triangles.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/contact/detection/contact_candidates.h"
#include "tests/support/contact/obstacles.h"
#include "tests/support/shell/advanced_sheet.h"

namespace sherd {
namespace {

/// Positions folded in the middle, so that the halves lie on each other nearer than the thickness.
Positions folded(const Positions& rest) {
    Positions x = rest;
    for (auto at : x.colwise()) at = Vector3d(std::abs(at[0] - 0.5), at[1], at[0] < 0.5 ? 0 : 0.008);
    return x;
}

void expect_same_pairs(const std::vector<ContactPair>& followed, const std::vector<ContactPair>& anew) {
    RC_ASSERT(followed.size() == anew.size());
    for (std::size_t i = 0; i < anew.size(); ++i) {
        RC_ASSERT(followed[i].kind == anew[i].kind);
        RC_ASSERT(followed[i].vertices == anew[i].vertices);
        RC_ASSERT(followed[i].stiffness == anew[i].stiffness);
        RC_ASSERT(followed[i].activation_distance == anew[i].activation_distance);
    }
}

RC_GTEST_PROP(AdvancedContact, HasThePairsThatANewSearchFinds, ()) {
    const unsigned seed = *rc::gen::inRange(0u, 1u << 30);
    BreakableShell sheet({test::directed_input(0, seed)});
    Shell& shell = sheet.mechanics();
    shell.position = folded(shell.rest);
    const auto ball = test::sphere_surface(0.02, 1);
    std::vector<ContactCollider> colliders(1);
    colliders[0].surface = ball.get();
    const auto positions = [&] {
        Positions all(3, ball->size() + shell.position.cols());
        all << ball->points.colwise() + Vector3d(0.2, 0.3, 0.03), shell.position;
        return all;
    };
    const auto here = [&](double margin) {
        return Neighbourhood(positions(), Positions::Zero(3, positions().cols()), margin, ball->size());
    };
    ContactSurface surface(shell, colliders);
    CachedTrees trees;
    ContactCandidates candidates(surface, here(1e-3), trees);
    const auto follow = [&](const ShellChange& change) {
        const ContactSurface before = std::exchange(surface, ContactSurface(shell, colliders));
        candidates.follow(change, before, surface, trees);
        RC_ASSERT(candidates.neighbourhood().contains(here(1e-4)));
        ContactCandidates anew(surface, here(1e-4), trees);
        const std::vector<ContactPair> pairs = anew.pick(surface, here(1e-4));
        RC_ASSERT(pairs.size() > 100u);
        expect_same_pairs(candidates.pick(surface, here(1e-4)), pairs);
    };
    test::Advances advances(sheet, seed + 1);
    for (int i = 0; i < 12; ++i) {
        const auto advanced = advances.next();
        if (!advanced) continue;
        follow(advanced->change.shell);
        if (!advances.random_bool()) continue;
        if (const auto change = advances.fail(advanced->halfedge)) follow(change->shell);
    }
}

}  // namespace
}  // namespace sherd
