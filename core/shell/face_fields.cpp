// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shell/face_fields.h"

#include "core/elements/hinge_angles.h"
#include "core/elements/membrane_stress.h"
#include "core/elements/principal_values.h"
#include "core/shell/thickness.h"

namespace sherd {

Eigen::Matrix3Xd green_strains(const Shell& shell, const Positions& x) {
    return green_strains(shell, x, numbers_up_to(static_cast<Index>(shell.triangles.size())));
}

Eigen::Matrix3Xd green_strains(const Shell& shell, const Positions& x, std::span<const Index> faces) {
    Eigen::Matrix3Xd strains(3, faces.size());
    each_four(static_cast<Index>(strains.cols()), [&](const std::array<Index, Lanes::count>& columns) {
        std::array<Index, 3> vertices[Lanes::count];
        Eigen::Matrix<Lanes, 2, 2> derivatives;  // shape functions of the second and the third corner
        for (int lane = 0; lane < Lanes::count; ++lane) {
            const auto& [of, membrane] = shell.triangles[faces[columns[lane]]];
            vertices[lane] = of;
            for (int i = 0; i < 2; ++i)
                for (int j = 0; j < 2; ++j) derivatives(i, j).set(lane, membrane.derivatives(i + 1, j));
        }
        const Eigen::Matrix<Lanes, 3, 3> at = lane_columns(x, vertices);
        const Eigen::Matrix<Lanes, 3, 1> one = at.col(1) - at.col(0), other = at.col(2) - at.col(0);
        Eigen::Matrix<Lanes, 3, 2> F;
        F.col(0) = derivatives(0, 0) * one + derivatives(1, 0) * other;
        F.col(1) = derivatives(0, 1) * one + derivatives(1, 1) * other;
        const Eigen::Matrix<Lanes, 3, 1> strain = strain_of(F);
        for (int lane = 0; lane < Lanes::count; ++lane)
            for (int c = 0; c < 3; ++c) strains(c, columns[lane]) = strain[c][lane];
    });
    return strains;
}

FaceState face_state(const Shell& shell, Index face, const Vector3d& strain, const Vector3d& curvature) {
    const TriangleStencil& triangle = shell.triangles[face];
    const double thickness = mean_thickness(shell, triangle.vertices);
    const auto stress = [&](double height) -> Vector3d {
        return triangle.membrane.elasticity * (strain - height * curvature) / thickness;
    };
    return {curvature, strain, stress(thickness / 2), stress(-thickness / 2)};
}

FaceFields face_fields(const Shell& shell, const Eigen::Matrix3Xd& strains,
                       const Eigen::Matrix3Xd& curvatures, const FaceFieldChoice& choice) {
    FaceFields fields;
    if (choice.curvature) fields.curvature = curvatures;
    if (choice.membrane_strain) fields.membrane_strain = strains;
    if (!choice.stress) return fields;
    fields.stress_top.resize(3, strains.cols());
    fields.stress_bottom.resize(3, strains.cols());
    for (Eigen::Index f = 0; f < strains.cols(); ++f) {
        const FaceState state = face_state(shell, static_cast<Index>(f), strains.col(f), curvatures.col(f));
        fields.stress_top.col(f) = state.stress_top;
        fields.stress_bottom.col(f) = state.stress_bottom;
    }
    return fields;
}

FaceFieldChoice choice_of(const FaceFields& fields) {
    return {.stress = fields.stress_top.size() > 0,
            .curvature = fields.curvature.size() > 0,
            .membrane_strain = fields.membrane_strain.size() > 0};
}

Eigen::Matrix2Xd principal_values(const Eigen::Matrix3Xd& tensors, bool twice) {
    Eigen::Matrix2Xd principal(2, tensors.cols());
    for (Eigen::Index f = 0; f < tensors.cols(); ++f) {
        const Vector3d tensor = tensors.col(f);
        principal.col(f) = principal_values(twice ? tensor_of_strain(tensor) : tensor);
    }
    return principal;
}

VectorXd largest_stress(const FaceFields& fields) {
    return principal_values(fields.stress_top, false)
        .row(0)
        .cwiseMax(principal_values(fields.stress_bottom, false).row(0))
        .transpose();
}

VectorXd largest_curvature(const FaceFields& fields) {
    VectorXd largest(fields.curvature.cols());
    for (Eigen::Index f = 0; f < largest.size(); ++f) largest[f] = principal_strain(fields.curvature.col(f));
    return largest;
}

FieldPeak stress_peak(const FaceFields& fields) {
    Eigen::Index face = 0;
    const double value = largest_stress(fields).maxCoeff(&face);
    const Vector3d top = fields.stress_top.col(face);
    return {value, static_cast<Index>(face), principal_values(top)[0] == value};
}

FieldPeak curvature_peak(const FaceFields& fields) {
    const VectorXd curvatures = largest_curvature(fields);
    Eigen::Index face = 0;
    curvatures.cwiseAbs().maxCoeff(&face);
    return {curvatures[face], static_cast<Index>(face)};
}

}  // namespace sherd
