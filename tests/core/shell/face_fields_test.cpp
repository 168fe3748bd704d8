// SPDX-License-Identifier: GPL-3.0-or-later
// With wrong face fields, stress and curvature would be recorded with a wrong sign, on the wrong surface or
// in the wrong direction.
#include "core/shell/face_fields.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/elements/principal_values.h"
#include "core/forces/shell_energies.h"
#include "tests/support/shell/small_sheet.h"

namespace sherd {
namespace {

constexpr double field_thickness = 0.01, field_young = 2e9, field_poisson = 0.3;
const Material field_material{1000, field_thickness, field_young, field_poisson};
constexpr int field_rows = 7, field_columns = 9;  // numbers of vertices along y and x

/// Flat rectangle of 1.6 m by 1.2 m with unequal triangles, whose normals are z; each face's material axis
/// is turned by `angle` (rad) against x.
Shell field_sheet(const Material& material, double angle = 0) {
    Positions rest(3, field_columns * field_rows);
    std::vector<std::array<Index, 3>> triangles;
    test::Random random(8);
    for (int i = 0; i < field_columns; ++i)
        for (int j = 0; j < field_rows; ++j) {
            rest.col(field_rows * i + j) << 0.2 * i + random.uniform(-0.03, 0.03),
                0.2 * j + random.uniform(-0.03, 0.03), 0;
            if (i == 0 || j == 0) continue;
            const Index a = field_rows * (i - 1) + j - 1, b = a + field_rows, c = b + 1, d = a + 1;
            if ((i + j) % 2 == 0)
                triangles.insert(triangles.end(), {{a, b, c}, {d, a, c}});
            else
                triangles.insert(triangles.end(), {{c, d, b}, {a, b, d}});
        }
    Shell shell = test::small_sheet(rest, triangles, material);
    const Vector3d axis(std::cos(angle), std::sin(angle), 0);
    for (auto& [vertices, membrane] : shell.triangles)
        membrane.elasticity = membrane_elasticity(material, axis_angle(columns(rest, vertices), axis));
    return shell;
}

FaceFields fields_of(const Shell& shell, const Positions& x, BendingModel model) {
    const ShellEnergies energies(shell, {.bending = {.model = model}});
    return face_fields(shell, energies.face_strains(x), energies.face_curvatures(x), {true, true, true});
}

/// Components (00, 11, 01) in the axes x and y of a tensor that is given in the frame of a face.
Vector3d in_x_and_y(const Shell& shell, Index face, const Vector3d& tensor) {
    const auto axes = frame_axes(columns(shell.rest, shell.triangles[face].vertices));
    Eigen::Matrix2d local;
    local << tensor[0], tensor[2], tensor[2], tensor[1];
    const Matrix3d full = axes * local * axes.transpose();
    return {full(0, 0), full(1, 1), full(0, 1)};
}

/// Faces without a vertex on the rim, so that no free edge is near.
std::vector<Index> inner_faces(const Shell& shell) {
    std::vector<Index> faces;
    for (Index f = 0; f < static_cast<Index>(shell.triangles.size()); ++f)
        if (std::ranges::all_of(shell.triangles[f].vertices, [](Index v) {
                return v >= field_rows && v < (field_columns - 1) * field_rows && v % field_rows > 0 &&
                       v % field_rows < field_rows - 1;
            }))
            faces.push_back(f);
    return faces;
}

TEST(FaceFields, BendTowardsTheNormalSqueezesTheTop) {
    const Shell shell = field_sheet(field_material);
    const double xx = 1e-4, yy = -3e-5, xy = 2e-5;
    Positions x = shell.rest;
    for (Eigen::Index v = 0; v < x.cols(); ++v)
        x(2, v) = 0.5 * xx * x(0, v) * x(0, v) + 0.5 * yy * x(1, v) * x(1, v) + xy * x(0, v) * x(1, v);
    const FaceFields fields = fields_of(shell, x, BendingModel::coupled);
    const double modulus = field_young / (1 - field_poisson * field_poisson), half = field_thickness / 2;
    ASSERT_GT(inner_faces(shell).size(), 20u);
    for (const Index f : inner_faces(shell)) {
        const Vector3d curvature = in_x_and_y(shell, f, tensor_of_strain(fields.curvature.col(f)));
        EXPECT_LT((curvature - Vector3d(xx, yy, xy)).norm(), 1e-6 * xx);
        const Vector3d bending =
            modulus * half *
            Vector3d(xx + field_poisson * yy, yy + field_poisson * xx, (1 - field_poisson) * xy);
        const Vector3d top = in_x_and_y(shell, f, fields.stress_top.col(f)),
                       bottom = in_x_and_y(shell, f, fields.stress_bottom.col(f));
        EXPECT_LT(((bottom - top) / 2 - bending).norm(), 1e-6 * bending.norm());
        EXPECT_LT(top[0], 0);
        EXPECT_GT(bottom[0], 0);
    }
}

TEST(FaceFields, StretchIsTheSameAtBothSurfaces) {
    const Shell shell = field_sheet(field_material);
    Positions x = shell.rest;
    x.row(0) *= 1.002;
    const double strain = 0.5 * (1.002 * 1.002 - 1);
    const double modulus = field_young / (1 - field_poisson * field_poisson);
    for (const BendingModel model : {BendingModel::coupled, BendingModel::cubic}) {
        const FaceFields fields = fields_of(shell, x, model);
        for (Index f = 0; f < fields.curvature.cols(); ++f) {
            EXPECT_LT((in_x_and_y(shell, f, tensor_of_strain(fields.membrane_strain.col(f))) -
                       Vector3d(strain, 0, 0))
                          .norm(),
                      1e-12);
            const Vector3d stress = modulus * strain * Vector3d(1, field_poisson, 0);
            EXPECT_LT((in_x_and_y(shell, f, fields.stress_top.col(f)) - stress).norm(), 1e-9 * stress.norm());
            EXPECT_LT((in_x_and_y(shell, f, fields.stress_bottom.col(f)) - stress).norm(),
                      1e-9 * stress.norm());
        }
    }
}

// The stiff axis is at 30 degrees: a pull along x also shears.
TEST(FaceFields, StressFollowsTheMaterialsAxes) {
    const Orthotropy wood{1e10, 8e8, 3e8, 7e8};
    Material material{500, field_thickness, wood.young0, wood.young01 / wood.young1, wood.young1, wood.shear};
    const double angle = 0.5236;
    const Shell shell = field_sheet(material, angle);
    Positions x = shell.rest;
    x.row(0) *= 1.001;
    x.row(1) += 0.0005 * shell.rest.row(0);
    const Matrix3d elasticity =
        turned_elasticity(plane_stress_elasticity(elastic_constants(material), 1), angle);
    const double xx = 0.5 * (1.001 * 1.001 + 0.0005 * 0.0005 - 1);
    const Vector3d stress = elasticity * Vector3d(xx, 0, 0.0005);
    ASSERT_GT(std::abs(stress[2]), 0.1 * stress[0]);
    const FaceFields fields = fields_of(shell, x, BendingModel::coupled);
    for (Index f = 0; f < fields.curvature.cols(); ++f)
        EXPECT_LT((in_x_and_y(shell, f, fields.stress_top.col(f)) - stress).norm(), 1e-9 * stress.norm());
}

// A single hinge must give both faces the curvature of twice its change of angle over the sum of their
// heights.
TEST(FaceFields, SingleHingeBendsBothFacesAlikeAcrossItsEdge) {
    const Shell shell = test::two_triangles(field_material);
    Positions x = shell.rest;
    const double angle = 0.01, height0 = 0.8, height1 = 0.9;
    x(1, 3) = -height1 * std::cos(angle);
    x(2, 3) = height1 * std::sin(angle);
    const FaceFields fields = fields_of(shell, x, BendingModel::cubic);
    for (const Index f : {0, 1}) {
        const Vector3d curvature = in_x_and_y(shell, f, tensor_of_strain(fields.curvature.col(f)));
        EXPECT_LT((curvature - Vector3d(0, 2 * angle / (height0 + height1), 0)).norm(), 1e-12);
    }
}

// A clamp bends its face by half of the angle between the face and its mirror image.
TEST(FaceFields, SingleHingesKnowOfClamps) {
    const Shell shell = test::two_triangles(field_material);
    const ShellEnergies energies(shell, {.bending = {BendingModel::cubic, BendingJacobian::cubic},
                                         .mirrors = {clamp_hinge(shell, {0, 1}, 1)}});
    const Eigen::Matrix3Xd at_rest = energies.face_curvatures(shell.rest);
    EXPECT_LT(at_rest.norm(), 1e-14);
    // The whole sheet turns by an angle about the clamped side, from vertex 2 to vertex 0.
    const Vector3d pivot = shell.rest.col(0), way = (shell.rest.col(0) - shell.rest.col(2)).normalized();
    const Matrix3d turn = Eigen::AngleAxisd(0.02, way).toRotationMatrix();
    const Positions x = (turn * (shell.rest.colwise() - pivot)).colwise() + pivot;
    const Eigen::Matrix3Xd curvature = energies.face_curvatures(x);
    const double area = shell.triangles[0].membrane.area, length = (shell.rest.col(2) - pivot).norm();
    const Vector2d principal = principal_values(tensor_of_strain(curvature.col(0)));
    EXPECT_NEAR(principal.cwiseAbs().maxCoeff(), length / area * 0.02, 1e-9);
    EXPECT_NEAR(principal.cwiseAbs().minCoeff(), 0, 1e-12);
    EXPECT_LT(curvature.col(1).norm(), 1e-12);
}

TEST(FaceFields, WhatIsNotWantedIsEmpty) {
    const Shell shell = test::two_triangles(field_material);
    const Eigen::Matrix3Xd flat = Eigen::Matrix3Xd::Zero(3, 2);
    EXPECT_FALSE(choice_of(face_fields(shell, flat, flat, {})).any());
    for (const FaceFieldChoice choice : {FaceFieldChoice{.stress = true}, FaceFieldChoice{.curvature = true},
                                         FaceFieldChoice{.membrane_strain = true}})
        EXPECT_EQ(choice_of(face_fields(shell, flat, flat, choice)), choice);
}

TEST(PrincipalValues, AreThoseOfTheTensorLargerOneFirst) {
    test::Random random(3);
    for (int i = 0; i < 100; ++i) {
        const double a = random.uniform(-1, 1), b = random.uniform(-1, 1), angle = random.uniform(0, 6);
        const double c = std::cos(angle), s = std::sin(angle);
        const Vector2d found =
            principal_values(Vector3d(c * c * a + s * s * b, s * s * a + c * c * b, c * s * (a - b)));
        EXPECT_LT((found - Vector2d(std::max(a, b), std::min(a, b))).norm(), 1e-14);
    }
}

// The colour of a picture and the value in `sherd info` are the most tensile stress of both surfaces.
TEST(FaceFields, LargestStressIsTheMostTensileOfBothSurfaces) {
    FaceFields fields;
    fields.stress_top.resize(3, 2);
    fields.stress_bottom.resize(3, 2);
    fields.stress_top << 1, 2, -9, 5, 0, 0;
    fields.stress_bottom << 3, -1, 0, -2, 4, 0;
    EXPECT_NEAR(largest_stress(fields)[0], 1.5 + std::sqrt(1.5 * 1.5 + 16), 1e-12);
    EXPECT_NEAR(largest_stress(fields)[1], 5, 1e-12);
    fields.curvature = fields.stress_bottom;
    fields.curvature.col(1) << -7, 2, 0;
    EXPECT_NEAR(largest_curvature(fields)[1], -7, 1e-12);
}

}  // namespace
}  // namespace sherd
