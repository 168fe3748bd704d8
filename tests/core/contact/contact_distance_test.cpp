// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/contact/barrier/barrier.h"
#include "core/contact/barrier/edge_mollifier.h"
#include "core/contact/geometry/distance.h"
#include "tests/support/contact/contact_pairs.h"
#include "tests/support/shell/automatic_differentiation.h"
#include "tests/support/shell/finite_differences.h"

namespace sherd {
namespace {

using test::Random;

/// Vertices with non-zero weight.
std::vector<int> involved(const Closest& closest) {
    std::vector<int> vertices;
    for (int i = 0; i < 4; ++i)
        if (closest.weights[i] != 0) vertices.push_back(i);
    return vertices;
}

template <class Vector>
auto cross(const Vector& a, const Vector& b) {
    Vector c;
    for (int i = 0; i < 3; ++i) c[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
    return c;
}

/// Squared distance from textbook formulas, for any scalar type, of the points, lines and planes through the
/// elements' closest vertices, edges and faces.
struct Unbounded {
    PairKind kind;
    Closest closest;

    template <class Scalar>
    Scalar operator()(const Eigen::Matrix<Scalar, 3, 4>& x) const {
        using Vector = Eigen::Matrix<Scalar, 3, 1>;
        const auto between = [&](int a, int b) { return Vector(x.col(b) - x.col(a)); };
        const std::vector<int> v = involved(closest);
        if (closest.freedom == 0) return between(v[0], v[1]).squaredNorm();
        if (closest.freedom == 1) {
            int p = 0;  // the vertex whose weight differs in sign from the two others
            for (const int i : v) {
                int same = 0;
                for (const int j : v) same += closest.weights[i] * closest.weights[j] > 0;
                if (same == 1) p = i;
            }
            std::vector<int> ends;
            for (const int i : v)
                if (i != p) ends.push_back(i);
            const Vector along = between(ends[0], ends[1]);
            return Scalar(cross(along, between(ends[0], p)).squaredNorm() / along.squaredNorm());
        }
        const bool edges = kind == PairKind::edge_edge;
        const Vector normal =
            edges ? cross(between(0, 1), between(2, 3)) : cross(between(1, 2), between(1, 3));
        const Scalar way = normal.dot(between(0, edges ? 2 : 1));
        return Scalar(way * way / normal.squaredNorm());
    }
};

// A distance that is too large, by a wrong case, sign or cancellation, lets elements pass: it must be the
// smallest over all points of the elements, also of degenerate ones.
TEST(ContactDistance, IsTheSmallestOverAllPoints) {
    for (const PairKind kind : test::pair_kinds)
        for (const PairPositions& x : test::adversarial_pairs(2000)) {
            const double distance = std::sqrt(squared_distance(closest_points(kind, x), x));
            const auto searched = static_cast<double>(test::searched_distance(kind, x.cast<long double>()));
            EXPECT_NEAR(distance, searched, 1e-14) << x;
        }
}

// A translation far from the origin must not cost more digits than the positions themselves have lost.
TEST(ContactDistance, KeepsItsDigitsFarFromTheOrigin) {
    for (const PairKind kind : test::pair_kinds)
        for (const PairPositions& x : test::adversarial_pairs(200)) {
            const PairPositions far = x.colwise() + Vector3d(1000, -2000, 500);
            const double distance = std::sqrt(squared_distance(closest_points(kind, far), far));
            EXPECT_NEAR(distance, static_cast<double>(test::searched_distance(kind, far.cast<long double>())),
                        1e-14);
        }
}

// Wrong derivatives would push elements wrongly. In every case of closest elements, the reference is
// automatic differentiation of the textbook formula.
TEST(ContactDistance, DerivativesAreThoseOfTheTextbookFormulas) {
    int seen[2][3] = {};
    for (const PairKind kind : test::pair_kinds) {
        Random random(3);
        for (int i = 0; i < 400; ++i) {
            const PairPositions x = random.matrix<PairPositions>(1);
            const Closest closest = closest_points(kind, x);
            ++seen[kind == PairKind::edge_edge][closest.freedom];
            const auto exact = test::differentiate(Unbounded{kind, closest}, x);
            EXPECT_NEAR(squared_distance(closest, x), exact.value, 1e-13);
            const Eigen::Matrix<double, 12, 1> gradient = squared_distance_gradient(closest, x).reshaped();
            EXPECT_LT((gradient - exact.gradient).norm(), 1e-10 * (1 + exact.gradient.norm()));
            const double scale = exact.hessian.norm();
            EXPECT_LT((squared_distance_hessian(closest, x) - exact.hessian).norm(), 1e-9 * scale * scale);
        }
    }
    for (const auto& of_kind : seen)
        for (const int count : of_kind) EXPECT_GT(count, 10);
}

// The gradient is continuous over the borders between the cases of closest elements: a jump would keep
// Newton's method from converging.
TEST(ContactDistance, GradientIsTheDifferenceQuotientAcrossCases) {
    for (const PairKind kind : test::pair_kinds) {
        Random random(5);
        for (int i = 0; i < 400; ++i) {
            PairPositions x = random.matrix<PairPositions>(1);
            if (kind == PairKind::vertex_triangle) {  // the closest point is on a side, or on a corner
                const double share = i % 2 ? random.uniform(0, 1) : 0;
                const Vector3d side = (x.col(2) - x.col(1)).normalized();
                const Vector3d off = random.matrix<Vector3d>(1);
                x.col(0) = (1 - share) * x.col(1) + share * x.col(2) + off - side.dot(off) * side;
            }
            const auto value = [kind](const PairPositions& at) {
                return squared_distance(closest_points(kind, at), at);
            };
            const PairPositions gradient = squared_distance_gradient(closest_points(kind, x), x);
            EXPECT_LT((gradient - test::difference_gradient(value, x, 1e-7)).norm(),
                      1e-6 * (1 + gradient.norm()));
        }
    }
}

// Newton's third law for the distance and the mollifier of a pair: a net force or torque would set a heap
// spinning.
TEST(ContactDistance, ForcesOfAPairHaveNeitherSumNorTorque) {
    const auto expect_balance = [](const PairPositions& x, const PairPositions& forces) {
        Vector3d torque = Vector3d::Zero();
        for (int i = 0; i < 4; ++i) torque += x.col(i).cross(forces.col(i));
        EXPECT_LT(forces.rowwise().sum().norm(), 1e-14 * (1 + forces.norm()));
        EXPECT_LT(torque.norm(), 1e-14 * (1 + forces.norm()));
    };
    for (const PairPositions& x : test::adversarial_pairs(800)) {
        for (const PairKind kind : test::pair_kinds)
            expect_balance(x, squared_distance_gradient(closest_points(kind, x), x));
        expect_balance(x, EdgeMollifier{10}.gradient(x));
    }
}

TEST(EdgeMollifier, DerivativesAreThoseOfTheFormula) {
    const auto crossing = [](const auto& x) {
        using Scalar = typename std::decay_t<decltype(x)>::Scalar;
        using Vector = Eigen::Matrix<Scalar, 3, 1>;
        return Scalar(cross(Vector(x.col(1) - x.col(0)), Vector(x.col(3) - x.col(2))).squaredNorm());
    };
    Random random(9);
    int active = 0;
    for (int i = 0; i < 200; ++i) {
        const PairPositions x = random.matrix<PairPositions>(1);
        const EdgeMollifier mollifier{4};
        const auto formula = [&](const auto& at) {
            // Each result is a scalar, not an expression: expressions of nested derivatives refer to
            // temporaries that would be gone.
            using Scalar = decltype(crossing(at));
            const Scalar ratio = crossing(at) / 4.0, left = 2.0 - ratio;
            return Scalar(ratio * left);
        };
        if (!mollifier.active(x)) {
            EXPECT_EQ(mollifier.value(x), 1);
            EXPECT_TRUE(mollifier.gradient(x).isZero(0) && mollifier.hessian(x).isZero(0));
            continue;
        }
        ++active;
        const auto exact = test::differentiate(formula, x);
        EXPECT_NEAR(mollifier.value(x), exact.value, 1e-13);
        const Eigen::Matrix<double, 12, 1> gradient = mollifier.gradient(x).reshaped();
        EXPECT_LT((gradient - exact.gradient).norm(), 1e-12 * (1 + exact.gradient.norm()));
        EXPECT_LT((mollifier.hessian(x) - exact.hessian).norm(), 1e-12 * exact.hessian.norm());
    }
    EXPECT_GT(active, 20);
    EXPECT_LT(active, 180);
}

// For parallel edges the mollifier's value and gradient must vanish, and the derivatives of the distance
// must be finite.
TEST(EdgeMollifier, LeavesNothingOfParallelEdges) {
    PairPositions x;
    x << 0, 1, 0.3, 1.7, 0, 0, 0, 0, 0, 0, 0.1, 0.1;
    const EdgeMollifier mollifier = edge_mollifier(1, 1.4);
    EXPECT_EQ(mollifier.value(x), 0);
    EXPECT_TRUE(mollifier.gradient(x).isZero(0));
    const Closest closest = closest_points(PairKind::edge_edge, x);
    EXPECT_DOUBLE_EQ(squared_distance(closest, x), 0.01);
    EXPECT_TRUE(squared_distance_hessian(closest, x).allFinite());
}

// Contact is as stiff as the materials only if the barrier has its nominal slope, that of a unit spring at
// half its range.
TEST(Barrier, PushesLikeAUnitSpringAtHalfItsRangeAndSmoothlyEndsThere) {
    const Barrier barrier{0.02};
    EXPECT_NEAR(barrier.slope(0.01), -0.01, 1e-16);
    for (const double gap : {1e-7, 1e-4, 0.003, 0.01, 0.019, 0.0199}) {
        const double step = 1e-4 * std::min(gap, 0.02 - gap);
        const auto quotient = [&](auto f) {
            return (8 * (f(gap + step) - f(gap - step)) - f(gap + 2 * step) + f(gap - 2 * step)) /
                   (12 * step);
        };
        const double slope = barrier.slope(gap), curvature = barrier.curvature(gap);
        EXPECT_LT(slope, 0);
        EXPECT_GT(curvature, 0);
        EXPECT_NEAR(quotient([&](double g) { return barrier.value(g); }), slope, 1e-8 * std::abs(slope));
        EXPECT_NEAR(quotient([&](double g) { return barrier.slope(g); }), curvature, 1e-7 * curvature);
    }
    for (const double gap : {0.02, 1.0}) {
        EXPECT_EQ(barrier.value(gap), 0);
        EXPECT_EQ(barrier.slope(gap), 0);
        EXPECT_EQ(barrier.curvature(gap), 0);
    }
    EXPECT_LT(barrier.curvature(0.02 * (1 - 1e-9)), 1e-8);
    EXPECT_EQ(barrier.value(0), std::numeric_limits<double>::infinity());
    EXPECT_EQ(barrier.value(-1), std::numeric_limits<double>::infinity());
}

// At its onset, a quarter of the range, a second spring must have neither a force nor an energy yet.
TEST(Barrier, AFirmSpringIsStifferBelowItsShareOfTheRange) {
    const Barrier soft{0.02, true}, firm{0.02, true, {.degree = 1, .halvings = 2}};
    for (const double gap : {0.025, 0.015, 0.005}) {
        EXPECT_EQ(firm.value(gap), soft.value(gap));
        EXPECT_EQ(firm.slope(gap), soft.slope(gap));
    }
    EXPECT_EQ(firm.curvature(0.006), 1);
    EXPECT_EQ(firm.curvature(0.004), 65);
    const double depth = 0.005 - 0.002;
    EXPECT_NEAR(firm.slope(0.002), soft.slope(0.002) - 64 * depth, 1e-15);
    EXPECT_NEAR(firm.value(0.002), soft.value(0.002) + 32 * depth * depth, 1e-15);
}

}  // namespace
}  // namespace sherd
