// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shell/face_fields.h"

#include "core/elements/principal_values.h"
#include "core/shell/shell.h"

namespace sherd {

FaceState face_state(const Shell& shell, Index face, const Positions& x, const Vector3d& curvature) {
    const TriangleStencil& triangle = shell.triangles[face];
    const double thickness = shell.thickness[triangle.vertices[0]];
    const Vector3d strain = green_strain(triangle.membrane, columns(x, triangle.vertices));
    const auto stress = [&](double height) -> Vector3d {
        return triangle.membrane.elasticity * (strain - height * curvature) / thickness;
    };
    return {curvature, strain, stress(thickness / 2), stress(-thickness / 2)};
}

FaceFields face_fields(const Shell& shell, const Positions& x, const Eigen::Matrix3Xd& curvatures,
                       const FaceFieldChoice& choice) {
    const auto faces = static_cast<Eigen::Index>(shell.triangles.size());
    FaceFields fields;
    if (choice.curvature) fields.curvature = curvatures;
    if (choice.membrane_strain) fields.membrane_strain.resize(3, faces);
    if (choice.stress) fields.stress_top.resize(3, faces);
    if (choice.stress) fields.stress_bottom.resize(3, faces);
    for (Eigen::Index f = 0; f < faces; ++f) {
        const FaceState state = face_state(shell, static_cast<Index>(f), x, curvatures.col(f));
        if (choice.membrane_strain) fields.membrane_strain.col(f) = state.membrane_strain;
        if (!choice.stress) continue;
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
