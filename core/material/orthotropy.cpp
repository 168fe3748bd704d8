// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/material/orthotropy.h"

#include <Eigen/Geometry>
#include <cmath>
#include <sstream>

namespace sherd {
namespace {

/// 1 - nu01 nu10.
double stiffening(const Orthotropy& m) {
    return 1 - m.young01 / m.young0 * (m.young01 / m.young1);
}

Vector2d doubled(double angle) {
    return {std::cos(2 * angle), std::sin(2 * angle)};
}

/// Angle from the edge to the axis, rad, counterclockwise about the normal.
double angle_in_plane(const Vector3d& edge, const Vector3d& normal, const Vector3d& axis) {
    return std::atan2(axis.dot(normal.normalized().cross(edge)), axis.dot(edge));
}

}  // namespace

std::string broken_inequality(const Orthotropy& m) {
    std::ostringstream text;
    if (!(m.young0 > 0))
        text << "Y0 > 0 fails: Y0 = " << m.young0 << " Pa";
    else if (!(m.young1 > 0))
        text << "Y1 > 0 fails: Y1 = " << m.young1 << " Pa";
    else if (!(stiffening(m) > 0))
        text << "Y01^2 < Y0 Y1 fails: Y01 = nu01 Y1 = " << m.young01
             << " Pa, Y01^2 = " << m.young01 * m.young01 << " Pa^2, Y0 Y1 = " << m.young0 * m.young1
             << " Pa^2";
    else if (!(m.shear > 0))
        text << "G01 > 0 fails: G01 = " << m.shear << " Pa";
    return text.str();
}

double edge_stiffness(const Orthotropy& m, double thickness, double angle) {
    const double h = std::pow(thickness, 3) / 12, c = h / stiffening(m);
    const double sine = std::sin(angle), cosine = std::cos(angle);
    const double twice = 2 * sine * cosine;
    return c * m.young0 * std::pow(sine, 4) + c * m.young1 * std::pow(cosine, 4) +
           (c * m.young01 / 2 + h * m.shear) * twice * twice;
}

Matrix3d plane_stress_elasticity(const Orthotropy& m, double thickness) {
    Matrix3d elasticity;
    elasticity << m.young0, m.young01, 0, m.young01, m.young1, 0, 0, 0, m.shear * stiffening(m);
    return thickness / stiffening(m) * elasticity;
}

Matrix3d turned_elasticity(const Matrix3d& elasticity, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    Matrix3d to_material;  // transforms strains to the material frame
    to_material << c * c, s * s, s * c, s * s, c * c, -s * c, -2 * s * c, 2 * s * c, c * c - s * s;
    return to_material.transpose() * elasticity * to_material;
}

double axis_angle(const TrianglePositions& rest, const Vector3d& axis) {
    const Vector3d edge = rest.col(1) - rest.col(0);
    return angle_in_plane(edge, edge.cross(Vector3d(rest.col(2) - rest.col(0))), axis);
}

double hinge_axis_angle(const HingePositions& rest, const std::array<Vector3d, 2>& axes) {
    const Vector3d e0 = rest.col(1) - rest.col(0), e1 = rest.col(2) - rest.col(0),
                   e2 = rest.col(3) - rest.col(0);
    const double first = angle_in_plane(e0, e0.cross(e1), axes[0]);
    const Vector2d sum = doubled(first) + doubled(angle_in_plane(e0, e2.cross(e0), axes[1]));
    return sum.norm() > 1e-9 ? std::atan2(sum.y(), sum.x()) / 2 : first;
}

}  // namespace sherd
