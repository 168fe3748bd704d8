// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/detection/near_pairs.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/support/contact/obstacles.h"
#include "tests/support/contact/surface_pairs.h"
#include "tests/support/shell/materials.h"
#include "tests/support/shell/plates.h"

namespace sherd {
namespace {

using test::Random;

std::vector<std::pair<Index, Index>> upcoming_blocks(const NearPairs& near, const Positions& x) {
    std::vector<std::pair<Index, Index>> blocks;
    near.add_contacts(x, true, blocks);
    std::ranges::sort(blocks);
    return blocks;
}

/// Asserts that the answers of `walker` at x, with two threads, are those of an unused object with one
/// thread, and that its active pairs are those of a brute-force search.
void expect_same(const NearPairs& walker, const Positions& x, const Positions& motion) {
    const NearPairs anew(walker.surface());
    const std::vector<ContactPair>&pairs = walker.active_pairs(x), &expected = anew.active_pairs(x);
    RC_ASSERT(test::names_of(pairs) == test::pairs_nearer_than(1, walker.surface(), x));
    RC_ASSERT(pairs.size() == expected.size());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        RC_ASSERT(pairs[i].stiffness == expected[i].stiffness);
        RC_ASSERT(pairs[i].activation_distance == expected[i].activation_distance);
        RC_ASSERT(pairs[i].mollifier.threshold == expected[i].mollifier.threshold);
    }
    RC_ASSERT(walker.safe_fraction(x, motion) == anew.safe_fraction(x, motion));
    RC_ASSERT(upcoming_blocks(walker, x) == upcoming_blocks(anew, x));
}

/// Random displacements, m: if `first` is 0, a common translation; for each of up to five parts of the
/// vertices from `first` on, a translation and a turn of about 10^`size` m; and noise. Vertices before
/// `first` stay.
Positions stride(Random& random, const Positions& x, Index first, double size) {
    const double scale = std::pow(10, size + random.uniform(-1, 0.5));
    const Index parts = 1 + random.below(5), count = static_cast<Index>(x.cols());
    std::vector<Vector3d> way, turn;
    for (Index part = 0; part < parts; ++part) {
        way.push_back(random.matrix<Vector3d>(scale));
        turn.push_back(random.matrix<Vector3d>(10 * scale));
    }
    const Vector3d together = random.matrix<Vector3d>(first == 0 && random.below(2) == 0 ? 0.1 : 0);
    Positions motion = Positions::Zero(3, count);
    for (Index v = first; v < count; ++v) {
        const Index part = (v - first) * parts / (count - first);
        motion.col(v) = together + way[part] + turn[part].cross(Vector3d(x.col(v))) +
                        random.matrix<Vector3d>(0.2 * scale);
    }
    return motion;
}

/// Moves about from x by random displacements, which no contact stops, and compares the answers at each
/// place.
void walk(const ContactSurface& surface, Positions x, unsigned seed) {
    Random random(seed);
    const NearPairs walker(surface, Threads(2));
    const double size = random.uniform(-5.5, -3);
    for (int i = 0; i < 12; ++i) {
        const Positions motion = stride(random, x, surface.collider_vertices(), size);
        expect_same(walker, x, motion);
        x += random.uniform(0, 1) * motion;
    }
}

// Pairs that have not moved by their distance are not measured again. With too small a bound on their
// motion, a pair or a passage would be missed, which nothing finds later. In a sheet with edges shorter than
// its thickness (2 mm), most pairs are within its thickness at rest.
RC_GTEST_PROP(NearPairs, AnswerAsIfNeverAskedBefore, ()) {
    const int count = *rc::gen::element(3, 3, 3, 8);  // the large plates take most of the time
    const Material& material = count == 8 ? test::thick_foam : test::ceramic;
    const Shell shell = test::stacked_plates(2, count, 0.97 * material.thickness, material);
    walk(ContactSurface(shell), shell.position, *rc::gen::inRange(0u, 1u << 30));
}

RC_GTEST_PROP(NearPairs, AnswerAsIfNeverAskedBeforeOnSolids, ()) {
    const Shell shell = test::stacked_plates(1, 4, 0, test::ceramic);
    const auto ball = test::sphere_surface(0.02, 1);
    std::vector<ContactCollider> colliders(1);
    colliders[0].surface = ball.get();
    const ContactSurface surface(shell, colliders);
    Positions x(3, surface.vertices());
    x << ball->points.colwise() + Vector3d(0.01, 0.01, 0.0204), shell.position;
    walk(surface, x, *rc::gen::inRange(0u, 1u << 30));
}

// A diverging minimiser proposes motions of kilometres. A search for all pairs within reach of these motions
// took 24 GB in a flag of 6,400 vertices; and obstructions must stop even the longest motions.
TEST(NearPairs, LongMotionsEndWhereTheyMeetSomething) {
    const double apart = 0.1;
    const Shell shell = test::stacked_plates(2, 8, apart, test::ceramic);
    const NearPairs near{ContactSurface(shell)};
    const auto count = static_cast<Eigen::Index>(shell.position.cols());
    const auto freedom = [&](double up) {  // m, displacement until the plates meet
        Positions motion = Positions::Zero(3, count);
        motion.rightCols(count / 2).row(2).setConstant(up);
        return near.safe_fraction(shell.position, motion) * std::abs(up);
    };
    for (const double down : {0.5 * apart, 2 * apart, 0.3, 1e3, 1e9}) {
        EXPECT_LE(freedom(-down), std::min(down, apart)) << down;
        EXPECT_GE(freedom(-down), std::min(down, apart - test::ceramic.thickness)) << down;
    }
    for (const double up : {0.05, 0.3}) EXPECT_EQ(freedom(up), up);
    EXPECT_GT(freedom(1e9), 1) << "128 widths of 11 mm, each plate its half";
}

// An obstacle with 36,672 edges, far larger than the sheet, once took all memory when it moved by five
// widths of the sheet in a step: all pairs within reach of the whole path were kept. Pairs on the path must
// still be found.
TEST(NearPairs, OnALongWayWhatIsPassedIsNearby) {
    const double apart = 0.1;
    const Shell shell = test::stacked_plates(2, 8, apart, test::ceramic);
    const NearPairs near{ContactSurface(shell)};
    const auto half = shell.position.cols() / 2;
    const auto upper_by = [&](double up) {
        Positions motion = Positions::Zero(3, 2 * half);
        motion.rightCols(half).row(2).setConstant(up);
        return motion;
    };
    const auto nearby = [&](double up) {
        std::vector<ContactPair> seen;
        near.each_nearby(shell.position, upper_by(up),
                         [&](const ContactPair& pair) { seen.push_back(pair); });
        std::vector<test::PairName> names = test::names_of(seen);
        std::ranges::sort(names);
        names.erase(std::unique(names.begin(), names.end()), names.end());
        return names;
    };
    const std::vector<test::PairName> at_rest = nearby(0);
    EXPECT_EQ(nearby(-0.5 * apart), at_rest);
    EXPECT_EQ(nearby(10 * apart), at_rest);
    EXPECT_TRUE(nearby(-1e9).empty()) << "farther than a motion is looked at";
    const Positions when_they_meet = shell.position + upper_by(-apart);
    const auto met = test::pairs_nearer_than(1, near.surface(), when_they_meet);
    const std::size_t edges = near.surface().edges().size();
    for (const double down : {1.1, 2.0, 10.0}) {
        const std::vector<test::PairName> seen = nearby(-down * apart);
        EXPECT_TRUE(std::ranges::includes(seen, met)) << down;
        EXPECT_LT(seen.size(), edges * edges / 8) << down << ": not all pairs of edges";
    }
}

// A step in which two plates change places is a passage, although they are apart before and after it; a step
// in which they slide along each other, or come nearer than their thickness, is no passage.
TEST(NearPairs, WhatChangesPlacesPasses) {
    const double apart = 0.01;
    const Shell shell = test::stacked_plates(2, 8, apart, test::ceramic);
    const NearPairs near{ContactSurface(shell)};
    const auto count = static_cast<Eigen::Index>(shell.position.cols());
    const auto passes = [&](const Vector3d& of_upper) {
        Positions motion = Positions::Zero(3, count);
        motion.rightCols(count / 2).colwise() += of_upper;
        return near.passes(shell.position, motion);
    };
    EXPECT_TRUE(passes({0, 0, -2 * apart}));
    EXPECT_TRUE(passes({0.01, 0.02, -2 * apart}));
    EXPECT_FALSE(passes({0, 0, -0.95 * apart})) << "within the thickness";
    EXPECT_FALSE(passes({0.05, 0, 0}));
    EXPECT_FALSE(passes({0, 0, 2 * apart}));
    EXPECT_FALSE(passes({0.5, 0, -1e-3}));
}

}  // namespace
}  // namespace sherd
