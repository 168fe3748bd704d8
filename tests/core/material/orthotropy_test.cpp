// SPDX-License-Identifier: GPL-3.0-or-later
// With wrong stiffnesses, a woven or rolled sheet would be stiff in wrong directions, or an isotropic one
// would be stiffer in some directions than in others.
#include "core/material/orthotropy.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <numbers>

#include "core/material/material.h"
#include "tests/support/shell/random_shapes.h"

namespace sherd {
namespace {

using std::numbers::pi;
using test::Random;

const Orthotropy wood{1e10, 8e8, 3e8, 7e8};

Orthotropy random_constants(Random& random) {
    Orthotropy m{random.uniform(1e6, 1e9), random.uniform(1e6, 1e9), 0, random.uniform(1e6, 1e9)};
    m.young01 = random.uniform(-0.9, 0.9) * std::sqrt(m.young0 * m.young1);
    return m;
}

TEST(Orthotropy, IsotropicStiffnessIsTheRigidityInEveryDirection) {
    for (const double nu : {-0.5, 0.0, 0.2, 0.3, 0.499})
        for (int degrees = -180; degrees <= 180; ++degrees) {
            const Material material{1000, 0.003, 7e10, nu, {}, {}, Calibration::paper};
            const double rigidity = 7e10 * std::pow(0.003, 3) / (12 * (1 - nu * nu));
            EXPECT_NEAR(hinge_stiffness(material, degrees * pi / 180), rigidity, 1e-14 * rigidity);
        }
}

TEST(Orthotropy, HingesHaveAThirdOfItUnlessAskedForAllAsInThePaper) {
    Material material{1000, 0.003, 7e10, 0.2, 2e10, 3e10};
    const double third = hinge_stiffness(material, 0.4);
    material.calibration = Calibration::paper;
    EXPECT_DOUBLE_EQ(hinge_stiffness(material, 0.4), 3 * third);
    EXPECT_DOUBLE_EQ(hinge_stiffness(material, 0.4),
                     edge_stiffness(elastic_constants(material), material.thickness, 0.4));
}

// The hinge must have the elastic constants of the membrane. Reference: the rigidity of a sheet that is bent
// to a cylinder, k^T C k, with the full plane-stress tensor C and the unit curvature k across the edge.
TEST(Orthotropy, StiffnessIsThatOfTheTensorOnTheCurvatureAcrossTheEdge) {
    Random random(1);
    for (int i = 0; i < 200; ++i) {
        const Orthotropy m = random_constants(random);
        const double thickness = 0.002, angle = random.uniform(-4, 4);
        const Vector2d across(-std::sin(angle), std::cos(angle));
        const Vector3d curvature(across.x() * across.x(), across.y() * across.y(),
                                 2 * across.x() * across.y());
        const double tensor =
            curvature.dot(plane_stress_elasticity(m, thickness) * curvature) * thickness * thickness / 12;
        EXPECT_NEAR(edge_stiffness(m, thickness, angle), tensor, 1e-13 * m.young0 * std::pow(thickness, 3));
    }
}

// Eq. 8 of the paper gives the stiffness of bending along a direction, which is across an edge. Its shear
// term counts the twists k01 and k10 separately; here they are one number, hence the factor 4.
TEST(Orthotropy, StiffnessFollowsEquationEightWithoutPoissonEffect) {
    const double thickness = 0.012, h = std::pow(thickness, 3) / 12;
    const Orthotropy m{1e10, 8e8, 0, 7e8};
    EXPECT_DOUBLE_EQ(edge_stiffness(m, thickness, pi / 2), h * m.young0) << "bends along the first axis";
    EXPECT_DOUBLE_EQ(edge_stiffness(m, thickness, 0), h * m.young1) << "bends along the second axis";
    for (int degrees = 0; degrees <= 90; degrees += 15) {
        const double direction = degrees * pi / 180, c = std::cos(direction), s = std::sin(direction);
        const double expected =
            h * (m.young0 * std::pow(c, 4) + m.young1 * std::pow(s, 4) + 4 * m.shear * s * s * c * c);
        EXPECT_NEAR(edge_stiffness(m, thickness, direction + pi / 2), expected, 1e-13 * h * m.young0);
    }
}

TEST(Orthotropy, ShearModulusIsHubersUnlessGiven) {
    Material material{1000, 0.001, 4e9, 0.3};
    EXPECT_DOUBLE_EQ(elastic_constants(material).shear, 4e9 / 2.6);
    material.young1 = 1e9;  // nu10 = 0.075
    EXPECT_DOUBLE_EQ(elastic_constants(material).young01, 3e8);
    EXPECT_DOUBLE_EQ(elastic_constants(material).shear, 2e9 / (2 * (1 + std::sqrt(0.3 * 0.075))));
    EXPECT_FALSE(is_isotropic(material));
    material.young1 = 4e9;
    EXPECT_TRUE(is_isotropic(material));
    material.shear = 1e7;
    EXPECT_EQ(elastic_constants(material).shear, 1e7);
    EXPECT_FALSE(is_isotropic(material)) << "a square weave: both axes alike, soft between them";
}

TEST(Orthotropy, EachBrokenInequalityIsNamedWithItsNumbers) {
    EXPECT_EQ(broken_inequality(wood), "");
    EXPECT_EQ(broken_inequality({-1, 1, 0, 1}), "Y0 > 0 fails: Y0 = -1 Pa");
    EXPECT_EQ(broken_inequality({1, 0, 0, 1}), "Y1 > 0 fails: Y1 = 0 Pa");
    EXPECT_EQ(broken_inequality({1, 1, 0, std::nan("")}), "G01 > 0 fails: G01 = nan Pa");
    const std::string coupled = broken_inequality({4, 1, 2, 1});
    EXPECT_NE(coupled.find("Y01^2 < Y0 Y1 fails"), std::string::npos) << "the border is not admissible";
    EXPECT_NE(coupled.find("Y01^2 = 4 Pa^2, Y0 Y1 = 4 Pa^2"), std::string::npos) << coupled;
    EXPECT_EQ(broken_inequality({4, 1, -1.999, 1}), "");
}

// Every strain of an admissible material costs energy; a refused one would have strains that do not.
TEST(Orthotropy, AdmissibleConstantsArePositiveDefinite) {
    Random random(2);
    for (int i = 0; i < 200; ++i) {
        const Orthotropy m = random_constants(random);
        EXPECT_EQ(broken_inequality(m), "");
        const Matrix3d elasticity = turned_elasticity(plane_stress_elasticity(m, 1), random.uniform(-3, 3));
        EXPECT_GT(elasticity.determinant(), 0);
        EXPECT_GT(elasticity(0, 0), 0);
        EXPECT_GT(elasticity(0, 0) * elasticity(1, 1), elasticity(0, 1) * elasticity(1, 0));
    }
}

// Young's modulus at an angle to the axes must follow the textbook compliance formula of composites.
TEST(Orthotropy, UniaxialModuliFollowTheComplianceFormula) {
    const double nu01 = wood.young01 / wood.young1;
    for (int degrees = 0; degrees <= 180; degrees += 15) {
        const double angle = degrees * pi / 180, c = std::cos(angle), s = std::sin(angle);
        const Matrix3d elasticity = turned_elasticity(plane_stress_elasticity(wood, 1), angle);
        const double modulus = 1 / elasticity.inverse()(0, 0);
        const double compliance = std::pow(c, 4) / wood.young0 + std::pow(s, 4) / wood.young1 +
                                  (1 / wood.shear - 2 * nu01 / wood.young0) * s * s * c * c;
        EXPECT_NEAR(modulus * compliance, 1, 1e-12) << degrees;
    }
}

TEST(Orthotropy, IsotropicElasticityIsTheSameInEveryFrame) {
    const Material material{1000, 0.01, 3e5, 0.3};
    Matrix3d expected;
    expected << 1, 0.3, 0, 0.3, 1, 0, 0, 0, 0.35;
    expected *= 3e5 * 0.01 / (1 - 0.09);
    for (const double angle : {0.0, 0.3, 1.0, 3.0})
        EXPECT_LT((membrane_elasticity(material, angle) - expected).norm(), 1e-14 * expected.norm());
}

TEST(Orthotropy, AxisOfAHingeIsTheMeanOfItsFacesModuloHalfATurn) {
    Random random(3);
    for (int i = 0; i < 200; ++i) {
        const double fold = random.uniform(-2.6, 2.6), mean = random.uniform(-pi, pi),
                     apart = random.uniform(-0.7, 0.7);
        const HingePositions flat = test::folded_hinge(0, 0.2, 0.7, 0.6, 1.2);
        const auto direction = [](double angle) { return Vector3d(std::cos(angle), std::sin(angle), 0); };
        // The second face, and the axis in it, turn about the edge (the x axis).
        const Matrix3d turn = Eigen::AngleAxisd(-fold, Vector3d::UnitX()).toRotationMatrix();
        const HingePositions folded = test::folded_hinge(fold, 0.2, 0.7, 0.6, 1.2);
        ASSERT_LT((turn * flat.col(3) - folded.col(3)).norm(), 1e-14);
        const Matrix3d place = random.rotation();
        const double sign = random.uniform(-1, 1) < 0 ? -1 : 1;
        const double found = hinge_axis_angle(
            place * folded, {place * direction(mean - apart), sign * place * turn * direction(mean + apart)});
        EXPECT_NEAR(std::remainder(found - mean, pi), 0, 1e-12);
    }
}

TEST(Orthotropy, PerpendicularAxesOfAHingeLeaveTheFirst) {
    const HingePositions flat = test::folded_hinge(0, 0.2, 0.7, 0.6, 1.2);
    const double found = hinge_axis_angle(flat, {Vector3d(0.6, 0.8, 0), Vector3d(-0.8, 0.6, 0)});
    EXPECT_NEAR(found, std::atan2(0.8, 0.6), 1e-15);
}

TEST(Material, StretchOverBendIsThatOfTheFormula) {
    // Y t L^2 / (D / 3) = 36 (1 - nu^2) (L / t)^2, with the edge length L, thickness t and rigidity D
    const Material glass{2500, 0.004, 7e10, 0.2};
    EXPECT_NEAR(stretch_over_bend(glass, 0.02), 36 * 0.96 * 25, 1e-10);
    Material ply = glass;
    ply.young1 = 1.4e11;
    EXPECT_NEAR(stretch_over_bend(ply, 0.02), 36 * (1 - 0.08) * 25 / 2, 1e-10)
        << "softer stretch, stiffer bend";
}

}  // namespace
}  // namespace sherd
