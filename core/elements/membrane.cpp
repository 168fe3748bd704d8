// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/elements/membrane.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include "core/elements/membrane_stress.h"

namespace sherd {
namespace {

using Matrix32 = Eigen::Matrix<double, 3, 2>;

Eigen::Matrix2d tensor(const Vector3d& stress) {
    Eigen::Matrix2d s;
    s << stress[0], stress[2], stress[2], stress[1];
    return s;
}

Eigen::Matrix2d tensile_part(const Eigen::Matrix2d& stress) {
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen;
    eigen.computeDirect(stress);
    return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).asDiagonal() *
           eigen.eigenvectors().transpose();
}

}  // namespace

Matrix32 frame_axes(const TrianglePositions& x) {
    const Vector3d a = x.col(1) - x.col(0), normal = a.cross(Vector3d(x.col(2) - x.col(0)));
    Matrix32 axes;
    axes << a.normalized(), normal.cross(a).normalized();
    return axes;
}

Vector2d side_normal(const MembraneTriangle& triangle, int corner) {
    return -triangle.derivatives.row(corner).transpose();
}

MembraneTriangle membrane_triangle(const TrianglePositions& rest, const Matrix3d& elasticity) {
    const Vector3d a = rest.col(1) - rest.col(0), b = rest.col(2) - rest.col(0), normal = a.cross(b);
    const Matrix32 axes = frame_axes(rest);
    const Vector3d axis0 = axes.col(0), axis1 = axes.col(1);
    Eigen::Matrix2d edges;
    edges << axis0.dot(a), axis0.dot(b), axis1.dot(a), axis1.dot(b);
    MembraneTriangle triangle;
    triangle.area = 0.5 * normal.norm();
    triangle.derivatives.bottomRows<2>() = edges.inverse();
    triangle.derivatives.row(0) = -triangle.derivatives.bottomRows<2>().colwise().sum();
    triangle.elasticity = elasticity;
    return triangle;
}

// F is computed from edge vectors, since the derivatives' rows sum to zero: far from the origin this keeps
// digits.
Matrix32 deformation_gradient(const MembraneTriangle& triangle, const TrianglePositions& x) {
    const Vector3d one = x.col(1) - x.col(0), other = x.col(2) - x.col(0);
    Matrix32 F;
    for (int i = 0; i < 2; ++i)
        F.col(i) = triangle.derivatives(1, i) * one + triangle.derivatives(2, i) * other;
    return F;
}

Vector3d green_strain(const MembraneTriangle& triangle, const TrianglePositions& x) {
    return strain_of(deformation_gradient(triangle, x));
}

Matrix3d geometric_stiffness(const MembraneTriangle& triangle, const Vector3d& stress, bool convex) {
    const Eigen::Matrix2d full = convex ? tensile_part(tensor(stress)) : tensor(stress);
    return triangle.derivatives * full * triangle.derivatives.transpose();
}

double value(const MembraneTriangle& triangle, const TrianglePositions& x) {
    const Vector3d strain = green_strain(triangle, x);
    return 0.5 * triangle.area * strain.dot(triangle.elasticity * strain);
}

TrianglePositions gradient(const MembraneTriangle& triangle, const TrianglePositions& x) {
    const Matrix32 F = deformation_gradient(triangle, x);
    const Vector3d stress = triangle.area * (triangle.elasticity * strain_of(F));
    const Matrix32 P = pulled(F, stress);
    TrianglePositions gradient;
    for (int i = 0; i < 3; ++i)
        gradient.col(i) = triangle.derivatives(i, 0) * P.col(0) + triangle.derivatives(i, 1) * P.col(1);
    return gradient;
}

Eigen::Matrix<double, 2, 3> rest_gradient(const MembraneTriangle& triangle, const TrianglePositions& x) {
    const Matrix32 F = deformation_gradient(triangle, x);
    const Vector3d strain = strain_of(F), stress = triangle.elasticity * strain;
    const Eigen::Matrix2d eshelby =
        0.5 * strain.dot(stress) * Eigen::Matrix2d::Identity() - F.transpose() * F * tensor(stress);
    return triangle.area * eshelby * triangle.derivatives.transpose();
}

Eigen::Matrix<double, 9, 9> hessian(const MembraneTriangle& triangle, const TrianglePositions& x,
                                    bool convex) {
    const Matrix32 F = deformation_gradient(triangle, x);
    Eigen::Matrix<double, 3, 9> B;  // d(strain)/dx
    for (int i = 0; i < 3; ++i) {
        const double d0 = triangle.derivatives(i, 0), d1 = triangle.derivatives(i, 1);
        B.block<1, 3>(0, 3 * i) = d0 * F.col(0).transpose();
        B.block<1, 3>(1, 3 * i) = d1 * F.col(1).transpose();
        B.block<1, 3>(2, 3 * i) = d1 * F.col(0).transpose() + d0 * F.col(1).transpose();
    }
    const Matrix3d geometric = geometric_stiffness(triangle, triangle.elasticity * strain_of(F), convex);
    Eigen::Matrix<double, 9, 9> h = B.transpose() * triangle.elasticity * B;
    for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) h.block<3, 3>(3 * a, 3 * b).diagonal().array() += geometric(a, b);
    return triangle.area * h;
}

}  // namespace sherd
