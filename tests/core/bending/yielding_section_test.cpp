// SPDX-License-Identifier: GPL-3.0-or-later
// With a wrong moment or kept curvature of a yielding section, metal would keep wrong dents.
#include "core/bending/yielding_section.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/shell/finite_differences.h"
#include "tests/support/shell/random_shapes.h"
#include "tests/support/shell/yielding_layers.h"

namespace sherd {
namespace {

using namespace test::yielding;

YieldingSection steel() {
    return {rigidity(), yield_moment};
}

/// State of a section with `curvature` along the first axis that bears no moment along the second axis; the
/// curvature along the second axis is found by bisection.
YieldingSection::State in_one_direction(double curvature, const PlasticBend& before) {
    double least = -curvature, most = curvature;
    for (int i = 0; i < 100; ++i) {
        const double middle = (least + most) / 2;
        (steel().at({curvature, middle, 0}, before).moment[1] < 0 ? least : most) = middle;
    }
    return steel().at({curvature, most, 0}, before);
}

// A strip of curvature k that is released keeps, by Gardiner 1957 and every handbook of forming, all of it
// but (3 - (k_y / k)^2) / 2 times k_y, the curvature at first yield.
TEST(YieldingSection, AStripSpringsBackAsHandbooksSay) {
    for (const double ratio : {0.5, 1.0, 1.01, 1.5, 3.0, 20.0}) {
        const YieldingSection::State bent = in_one_direction(ratio * first, {});
        const double share = ratio > 1 ? 1.5 - 0.5 / (ratio * ratio) : ratio;
        EXPECT_NEAR(bent.moment[0], share * yield_moment, 1e-6 * yield_moment) << ratio;
        EXPECT_NEAR(bent.plastic.curvature[0], (ratio - share) * first, 1e-6 * first) << ratio;
        EXPECT_EQ(bent.taken > 0, ratio > 1.005) << ratio;
    }
}

// For bending in two directions and for twist there is no formula like that of a strip; layers through the
// thickness are the reference.
TEST(YieldingSection, OtherBendsAreNearlyThoseOfLayers) {
    for (const Vector3d& way : {Vector3d(1, 0, 0), Vector3d(1, 1, 0), Vector3d(1, -1, 0), Vector3d(0, 0, 1.5),
                                Vector3d(1, 0.3, 0.7)}) {
        Layers layers;
        PlasticBend plastic;
        for (int i = 1; i <= 24; ++i) {
            const Vector3d bent = 0.25 * i * first * way;
            const Vector3d exact = layers.bend(bent);
            const YieldingSection::State state = steel().at(bent, plastic);
            plastic = state.plastic;
            EXPECT_LT((state.moment - exact).norm(), 0.04 * mises(exact)) << way.transpose() << " " << i;
            EXPECT_LT((plastic.curvature - Layers::plastic_curvature(bent, exact)).norm(), 0.05 * first)
                << way.transpose() << " " << i;
        }
    }
}

// A section that has yielded takes no more energy when it is bent back to zero moment, and is elastic until
// it is bent as far as before.
TEST(YieldingSection, IsElasticWithinWhatItHasBorne) {
    const Vector3d far(3 * first, first, 0.5 * first);
    const PlasticBend plastic = steel().at(far, {}).plastic;
    EXPECT_LT(steel().at(plastic.curvature, plastic).moment.norm(), 1e-12 * yield_moment);
    for (const double share : {0.0, 0.4, 0.999}) {
        const Vector3d bent = plastic.curvature + share * (far - plastic.curvature);
        const YieldingSection::State state = steel().at(bent, plastic);
        EXPECT_EQ(state.taken, 0);
        EXPECT_EQ(state.plastic.passed, plastic.passed);
        EXPECT_EQ(state.moment, Vector3d(rigidity() * (bent - plastic.curvature)));
    }
}

// The solver minimises a potential: the moment must be the derivative of the sum of stored and dissipated
// energy, and the tangent the derivative of the moment, in orthotropic materials, too.
TEST(YieldingSection, DerivativesAreThoseOfThePotential) {
    test::Random random(5);
    const Matrix3d grain{{9, 1, 0}, {1, 3, 0}, {0, 0, 2}};
    for (const Matrix3d& plate : {Matrix3d(rigidity()), Matrix3d(2 * grain)}) {
        const YieldingSection section(plate, yield_moment);
        const double least = yield_moment / plate(0, 0);
        const PlasticBend before = section.at(3 * least * random.matrix<Vector3d>(1), {}).plastic;
        for (int i = 0; i < 20; ++i) {
            const Vector3d bent = before.curvature + 4 * least * random.matrix<Vector3d>(1);
            const auto potential = [&](const Vector3d& k) {
                const YieldingSection::State state = section.at(k, before);
                return state.stored + state.taken;
            };
            const auto moment = [&](const Vector3d& k) { return section.at(k, before).moment; };
            const YieldingSection::State state = section.at(bent, before);
            const Vector3d slope = test::difference_gradient(potential, bent, 1e-4 * least);
            EXPECT_LT((state.moment - slope).norm(), 1e-6 * yield_moment) << i;
            const Matrix3d tangent = section.tangent(state, before);
            const Matrix3d change = test::difference_hessian(moment, bent, 1e-4 * least);
            EXPECT_LT((tangent - change).norm(), 1e-4 * plate.norm()) << i;
        }
    }
}

}  // namespace
}  // namespace sherd
