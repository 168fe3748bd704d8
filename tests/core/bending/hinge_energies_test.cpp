// SPDX-License-Identifier: GPL-3.0-or-later
// Properties of each of the three hinge energies.
#include <gtest/gtest.h>

#include <cmath>

#include "core/bending/cubic_hinge.h"
#include "core/bending/nonlinear_hinge.h"
#include "core/elements/hinge.h"
#include "tests/support/shell/automatic_differentiation.h"
#include "tests/support/shell/finite_differences.h"
#include "tests/support/shell/random_shapes.h"

namespace sherd::test {
namespace {

/// Formulas of the paper that docs/theory/bending.md follows, literally and for any scalar type, as
/// reference for the tests. No code is shared with core/.
template <class Scalar>
using Vector = Eigen::Matrix<Scalar, 3, 1>;

template <class Scalar>
using Quad = Eigen::Matrix<Scalar, 3, 4>;

template <class Scalar>
Scalar dot(const Vector<Scalar>& a, const Vector<Scalar>& b) {
    return Scalar(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

template <class Scalar>
Vector<Scalar> cross(const Vector<Scalar>& a, const Vector<Scalar>& b) {
    return {Scalar(a[1] * b[2] - a[2] * b[1]), Scalar(a[2] * b[0] - a[0] * b[2]),
            Scalar(a[0] * b[1] - a[1] * b[0])};
}

template <class Scalar>
struct HingeEdges {
    Vector<Scalar> e0, e1, e2, e3, e4;

    explicit HingeEdges(const Quad<Scalar>& x)
        : e0(x.col(1) - x.col(0)),
          e1(x.col(2) - x.col(0)),
          e2(x.col(3) - x.col(0)),
          e3(x.col(2) - x.col(1)),
          e4(x.col(3) - x.col(1)) {}
    Scalar triple() const { return dot<Scalar>(cross<Scalar>(e0, e1), e2); }
};

double cotangent(const Vector3d& a, const Vector3d& b) {
    return a.dot(b) / cross<double>(a, b).norm();
}

double two_areas(const HingeEdges<double>& rest) {
    return 0.5 * (cross<double>(rest.e0, rest.e1).norm() + cross<double>(rest.e0, rest.e2).norm());
}

/// Eq. 4 of the paper with the true angle.
template <class Scalar>
Scalar nonlinear_energy(const HingePositions& rest, double stiffness, const Quad<Scalar>& x) {
    const HingeEdges<double> bar(rest);
    const HingeEdges<Scalar> e(x);
    const Vector<Scalar> n0 = cross<Scalar>(e.e0, e.e1), n1 = cross<Scalar>(e.e2, e.e0);
    using std::sqrt;
    const Scalar normals = sqrt(Scalar(dot<Scalar>(n0, n0) * dot<Scalar>(n1, n1)));
    const Scalar cosine = dot<Scalar>(n0, n1) / normals;
    const Scalar sine = sqrt(dot<Scalar>(e.e0, e.e0)) * e.triple() / normals;
    const double angle = hinge_angle(rest);
    const Scalar turned = Scalar(cosine * std::cos(angle) + sine * std::sin(angle));
    return Scalar(3 * stiffness * bar.e0.squaredNorm() / two_areas(bar) * (1 - turned));
}

/// Eq. 7 of the paper with the corrected k, by the edge normals t0 and t1 of its eqs. 5 and 6.
template <class Scalar>
Scalar cubic_energy_2007(const HingePositions& rest, double stiffness, const Quad<Scalar>& x) {
    const HingeEdges<double> bar(rest);
    const HingeEdges<Scalar> e(x);
    const double c01 = cotangent(bar.e0, bar.e1), c03 = cotangent(-bar.e0, bar.e3),
                 c02 = cotangent(bar.e0, bar.e2), c04 = cotangent(-bar.e0, bar.e4);
    Vector<Scalar> sum;
    for (int i = 0; i < 3; ++i)
        sum[i] = Scalar(-(c03 * e.e1[i] + c01 * e.e3[i] + c04 * e.e2[i] + c02 * e.e4[i]));
    const double angle = hinge_angle(rest), scale = 3 * stiffness / two_areas(bar);
    const double k = scale * std::sin(angle) * (c01 + c03) * (c02 + c04) / bar.e0.norm();
    const double constant = scale * bar.e0.squaredNorm() * (1 - std::cos(angle));
    return Scalar(0.5 * scale * std::cos(angle) * dot<Scalar>(sum, sum) - k * e.triple() + constant);
}

}  // namespace
}  // namespace sherd::test

namespace sherd {
namespace {

using test::Quad;
using test::Random;

constexpr double stiffness = 1.7;

struct Nonlinear {
    static NonlinearHinge make(const HingePositions& rest) { return nonlinear_hinge(rest, stiffness); }
    template <class Scalar>
    static Scalar energy(const HingePositions& rest, const Quad<Scalar>& x) {
        return test::nonlinear_energy<Scalar>(rest, stiffness, x);
    }
};

struct Cubic2007 {
    static CubicHinge make(const HingePositions& rest) { return cubic_hinge_2007(rest, stiffness); }
    template <class Scalar>
    static Scalar energy(const HingePositions& rest, const Quad<Scalar>& x) {
        return test::cubic_energy_2007<Scalar>(rest, stiffness, x);
    }
};

struct Cubic {
    static CubicHinge make(const HingePositions& rest) { return cubic_hinge(rest, stiffness); }
    /// Eq. 7 and the correction that puts the rest shape in equilibrium: the difference of the matrices Q of
    /// both forms, which is a sum over squared edge lengths (QuadraticCorrectionIsMadeOfEdgeLengths).
    template <class Scalar>
    static Scalar energy(const HingePositions& rest, const Quad<Scalar>& x) {
        const Eigen::Matrix4d added = make(rest).quadratic - Cubic2007::make(rest).quadratic;
        Scalar sum = test::cubic_energy_2007<Scalar>(rest, stiffness, x);
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < i; ++j) {
                const test::Vector<Scalar> edge = x.col(i) - x.col(j);
                const double rest_length = (rest.col(i) - rest.col(j)).squaredNorm();
                sum = Scalar(sum - 0.5 * added(i, j) * (test::dot<Scalar>(edge, edge) - rest_length));
            }
        return sum;
    }
};

template <class Model>
class HingeEnergy : public testing::Test {};
using Models = testing::Types<Nonlinear, Cubic2007, Cubic>;
TYPED_TEST_SUITE(HingeEnergy, Models);

HingePositions random_fold(Random& random, double largest_angle = 2.6) {
    return test::random_hinge(random, random.uniform(-largest_angle, largest_angle));
}

// With a wrong sign or factor in the forces sheets would bend wrongly.
TYPED_TEST(HingeEnergy, GradientIsTheDerivativeOfTheValue) {
    Random random(1);
    for (int i = 0; i < 500; ++i) {
        const auto hinge = TypeParam::make(random_fold(random));
        const HingePositions x = random_fold(random), exact = gradient(hinge, x);
        const auto energy = [&](const HingePositions& at) { return value(hinge, at); };
        EXPECT_LT((exact - test::difference_gradient(energy, x, 3e-4)).norm(), 1e-8 * exact.norm());
    }
}

TYPED_TEST(HingeEnergy, HessianIsTheSymmetricDerivativeOfTheGradient) {
    Random random(2);
    for (int i = 0; i < 500; ++i) {
        const auto hinge = TypeParam::make(random_fold(random));
        const HingePositions x = random_fold(random);
        const auto slope = [&](const HingePositions& at) { return gradient(hinge, at); };
        const HingeHessian exact = hessian(hinge, x);
        EXPECT_LT((exact - test::difference_hessian(slope, x, 3e-4)).norm(), 1e-8 * exact.norm());
        EXPECT_LT((exact - exact.transpose()).norm(), 1e-13 * exact.norm());
    }
}

// Reference: automatic differentiation of the paper's formula.
TYPED_TEST(HingeEnergy, IsThePapersFormulaToTheSecondDerivative) {
    Random random(3);
    for (int i = 0; i < 500; ++i) {
        const HingePositions rest = random_fold(random, 3.1), x = random_fold(random, 3.1);
        const auto hinge = TypeParam::make(rest);
        const auto truth = test::differentiate(
            [&](const auto& at) {
                return TypeParam::template energy<typename std::decay_t<decltype(at)>::Scalar>(rest, at);
            },
            x);
        EXPECT_NEAR(value(hinge, x), truth.value, 1e-12 * truth.hessian.norm());
        EXPECT_LT((gradient(hinge, x).reshaped() - truth.gradient).norm(), 1e-12 * truth.hessian.norm());
        EXPECT_LT((hessian(hinge, x) - truth.hessian).norm(), 1e-12 * truth.hessian.norm());
    }
}

// With a net force or torque, a bending model would set a free sheet in motion.
TYPED_TEST(HingeEnergy, HasNoNetForceOrTorqueOnAnyDeformation) {
    Random random(4);
    for (int i = 0; i < 500; ++i) {
        const auto hinge = TypeParam::make(random_fold(random));
        const HingePositions x = random_fold(random) + random.matrix<HingePositions>(0.05);
        const HingePositions force = gradient(hinge, x);
        Vector3d torque = Vector3d::Zero();
        for (int v = 0; v < 4; ++v) torque += Vector3d(x.col(v)).cross(Vector3d(force.col(v)));
        EXPECT_LT(force.rowwise().sum().norm(), 1e-12 * force.norm());
        EXPECT_LT(torque.norm(), 1e-12 * force.norm() * x.norm());
    }
}

TYPED_TEST(HingeEnergy, IsTheSameAfterARigidMotionOfEitherShape) {
    Random random(5);
    for (int i = 0; i < 500; ++i) {
        const HingePositions rest = random_fold(random), x = random_fold(random);
        const auto moved = [&](const HingePositions& shape) {
            return HingePositions((random.rotation() * shape).colwise() + random.matrix<Vector3d>(3));
        };
        const double energy = value(TypeParam::make(rest), x);
        const double scale = 1e-12 * hessian(TypeParam::make(rest), x).norm();
        EXPECT_NEAR(value(TypeParam::make(rest), moved(x)), energy, scale);
        EXPECT_NEAR(value(TypeParam::make(moved(rest)), x), energy, scale);
        EXPECT_NEAR(value(TypeParam::make(rest), moved(rest)), 0, scale);
    }
}

// Folding about the edge stretches no triangle: for such motions all three energies must equal eq. 4.
TYPED_TEST(HingeEnergy, IsEquationFourAlongIsometries) {
    Random random(6);
    for (int i = 0; i < 500; ++i) {
        const double rest_angle = random.uniform(-2.6, 2.6), angle = random.uniform(-2.6, 2.6);
        const double a0 = random.uniform(-0.3, 1.3), h0 = random.uniform(0.2, 2),
                     a1 = random.uniform(-0.3, 1.3), h1 = random.uniform(0.2, 2);
        const HingePositions rest = test::folded_hinge(rest_angle, a0, h0, a1, h1);
        const HingePositions folded = random.rotation() * test::folded_hinge(angle, a0, h0, a1, h1);
        const double most = stiffness * 3 / ((h0 + h1) / 2);
        EXPECT_NEAR(value(TypeParam::make(rest), folded), most * (1 - std::cos(angle - rest_angle)),
                    1e-12 * most);
    }
}

}  // namespace
}  // namespace sherd
