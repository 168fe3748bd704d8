// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/detection/contact_candidates.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/contact/contact_pairs.h"
#include "tests/support/contact/obstacles.h"
#include "tests/support/contact/surface_pairs.h"
#include "tests/support/shell/materials.h"
#include "tests/support/shell/plates.h"

namespace sherd {
namespace {

using test::Random;

std::vector<test::PairName> near_pairs(const ContactSurface& surface, const Positions& x) {
    return test::pairs_nearer_than(ContactCandidates::nearness, surface, x);
}

void expect_all_near(const ContactSurface& surface, const std::vector<ContactPair>& picked,
                     const Positions& x) {
    const std::vector<test::PairName> names = test::names_of(picked), near = near_pairs(surface, x);
    EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
    EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
    EXPECT_TRUE(std::includes(names.begin(), names.end(), near.begin(), near.end()));
}

/// Random displacements, m, of up to `amplitude` in every coordinate.
Positions noise(Random& random, Index vertices, double amplitude) {
    Positions moved(3, vertices);
    for (double& entry : moved.reshaped()) entry = random.uniform(-amplitude, amplitude);
    return moved;
}

/// Displacements of bodies that fly apart and turn, each with a velocity and a spin of its own.
Positions flight(Random& random, const Shell& shell, double speed, double spin) {
    Positions motion(3, shell.position.cols());
    std::vector<Vector3d> velocity, rotation;
    for (int body = 0; body < 4; ++body) {
        velocity.push_back(random.matrix<Vector3d>(speed));
        rotation.push_back(random.matrix<Vector3d>(spin));
    }
    for (Index v = 0; v < motion.cols(); ++v) {
        const Index body = shell.vertex_sheet[v];
        motion.col(v) = velocity[body] + rotation[body].cross(Vector3d(shell.position.col(v)));
    }
    return motion;
}

void expect_no_pair_missed(const Shell& shell) {
    const ContactSurface surface(shell);
    const Index count = surface.vertices();
    Random random(3);
    std::size_t found = 0, asked = 0;
    for (const double speed : {0.0, 1e-3, 0.01})
        for (const double spin : {0.0, 0.3})
            for (const double common : {0.0, 10.0}) {
                Positions motion = flight(random, shell, speed, spin);
                motion.colwise() += common * Vector3d(1, -2, 3);
                CachedTrees none;
                ContactCandidates candidates(surface, {shell.position, motion, 1e-3}, none);
                for (int sample = 0; sample < 12; ++sample) {
                    const Positions x =
                        shell.position + random.uniform(0, 1) * motion + noise(random, count, 4e-4);
                    const Neighbourhood near(x, 0.3 * noise(random, count, 4e-4), 1e-4);
                    if (!candidates.neighbourhood().contains(near)) continue;
                    ++asked;
                    const std::vector<ContactPair> picked = candidates.pick(surface, near);
                    for (const double time : {0.0, 0.4, 1.0}) {
                        Positions at = x + time * near.motion + noise(random, count, 5e-5);
                        at.colwise() += random.matrix<Vector3d>(1);
                        EXPECT_TRUE(near.contains(at));
                        expect_all_near(surface, picked, at);
                        found += near_pairs(surface, at).size();
                    }
                }
            }
    EXPECT_GT(asked, 50u);
    EXPECT_GT(found, 10000u);
}

// A missed pair is an intersection that nothing later finds. Candidates must include every near pair, for
// any motion, at all positions in the neighbourhood, and after any earlier queries.
TEST(ContactCandidates, MissNoPairThatBruteForceFinds) {
    expect_no_pair_missed(test::stacked_plates(3, 3, 2.1e-3, test::ceramic));
}

// A pair with a vertex and a triangle of uneven sheets acts at a distance by their mean thicknesses, even if
// the triangle's nearest vertex is thin: such a pair must not be missed.
TEST(ContactCandidates, MissNoPairOfUnevenSheets) {
    Shell shell = test::stacked_plates(3, 3, 2.1e-3, test::ceramic);
    Random random(5);
    shell.uneven = true;
    for (double& thickness : shell.thickness) thickness = random.below(2) == 0 ? 1e-3 : 8e-3;
    expect_no_pair_missed(shell);
}

// Pairs with colliders, at rest and moving, must be found with the trees that an earlier search has left.
TEST(ContactCandidates, MissNoPairWithSolids) {
    const Shell shell = test::stacked_plates(1, 4, 0, test::ceramic);
    const auto box = test::box_surface(Vector3d(0, 0, -0.0109), Vector3d(0.03, 0.02, 0.01));
    const auto ball = test::sphere_surface(0.02, 2);
    std::vector<ContactCollider> both(2);
    both[0].surface = box.get();
    both[1].surface = ball.get();
    const ContactSurface surface(shell, both, false);
    const Index colliders = surface.collider_vertices(), count = surface.vertices();
    Positions start(3, count);
    start << box->points, ball->points.colwise() + Vector3d(0.01, 0.01, 0.0209), shell.position;
    Random random(5);
    CachedTrees kept;
    std::size_t found = 0, asked = 0;
    for (const double of_ball : {0.0, 0.01, 0.0})
        for (const double of_sheet : {0.0, 0.01}) {
            Positions motion = Positions::Zero(3, count);
            motion.middleCols(8, colliders - 8).colwise() = Vector3d(0, of_ball, 0);
            motion.rightCols(count - colliders).colwise() = Vector3d(of_sheet, 0, 0);
            ContactCandidates candidates(surface, Neighbourhood(start, motion, 1e-3, colliders), kept);
            for (int sample = 0; sample < 20; ++sample) {
                Positions x = start + random.uniform(0, 1) * motion;
                x.rightCols(count - colliders) += noise(random, count - colliders, 4e-4);
                const Neighbourhood near(x, Positions::Zero(3, count), 1e-4, colliders);
                if (!candidates.neighbourhood().contains(near)) continue;
                ++asked;
                expect_all_near(surface, candidates.pick(surface, near), x);
                found += near_pairs(surface, x).size();
            }
        }
    EXPECT_GT(asked, 50u);
    EXPECT_GT(found, 100u);
}

// Cracks change the surface: all changed elements must be searched again, and no removed pair may stay.
TEST(ContactCandidates, FollowCracksAsIfSearchedAgain) {
    Shell shell = test::stacked_plates(2, 4, 2.1e-3, test::ceramic);
    ContactSurface surface(shell);
    const Positions still = Positions::Zero(3, shell.position.cols());
    CachedTrees none;
    ContactCandidates candidates(surface, {shell.position, still, 1e-3}, none);
    for (const std::size_t triangle : {50, 51, 40, 3, 0}) {
        const Index corner = shell.triangles[triangle].vertices[1],
                    copy = static_cast<Index>(shell.mass.size());
        const ShellChange change{.vertices = {{copy, {{corner, 1}}}}};
        follow(shell, change);
        shell.triangles[triangle].vertices[1] = copy;
        shell.exempt_pairs.push_back({corner, copy});
        if (triangle == 3) shell.exempt_pairs.erase(shell.exempt_pairs.begin());
        const ContactSurface before = std::exchange(surface, ContactSurface(shell));
        candidates.follow(change, before, surface, none);
        const Neighbourhood here(shell.position, Positions::Zero(3, copy + 1), 1e-4);
        ASSERT_TRUE(candidates.neighbourhood().contains(here));
        const std::vector<ContactPair> picked = candidates.pick(surface, here);
        expect_all_near(surface, picked, shell.position);
        ContactCandidates anew(surface, here, none);
        const std::vector<ContactPair> expected = anew.pick(surface, here);
        EXPECT_EQ(test::names_of(picked), test::names_of(expected));
        for (std::size_t i = 0; i < picked.size(); ++i) {
            EXPECT_EQ(picked[i].stiffness, expected[i].stiffness);
            EXPECT_EQ(picked[i].activation_distance, expected[i].activation_distance);
        }
    }
}

// If the separation along a direction were more than the distance, near pairs would be skipped, and elements
// would pass through each other.
TEST(ContactCandidates, SeparationIsNeverMoreThanTheDistance) {
    Random random(5);
    for (const PairKind kind : {PairKind::vertex_triangle, PairKind::edge_edge})
        for (const PairPositions& x : test::adversarial_pairs(400)) {
            const Closest closest = closest_points(kind, x);
            const double apart = std::sqrt(squared_distance(closest, x)), size = x.cwiseAbs().maxCoeff();
            for (int i = 0; i < 20; ++i)
                EXPECT_LE(separation(kind, x, random.matrix<Vector3d>(1).normalized()), apart + 1e-14 * size);
            const Vector3d direction = (x * closest.weights).normalized();
            EXPECT_LE(separation(kind, x, direction), apart + 1e-14 * size);
            if (apart > 1e-6 * size) {
                EXPECT_NEAR(separation(kind, x, direction), apart, 1e-8 * size);
            }
        }
}

}  // namespace
}  // namespace sherd
