// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/elements/hinge.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "core/elements/dihedral_angle.h"
#include "core/elements/hinge_angles.h"

namespace sherd {
namespace {

double cotangent(const Vector3d& a, const Vector3d& b) {
    return a.dot(b) / a.cross(b).norm();
}

}  // namespace

RestHinge rest_hinge(const HingePositions& rest) {
    const Vector3d e0 = rest.col(1) - rest.col(0), e1 = rest.col(2) - rest.col(0),
                   e2 = rest.col(3) - rest.col(0);
    const Vector3d e3 = rest.col(2) - rest.col(1), e4 = rest.col(3) - rest.col(1);
    RestHinge hinge;
    hinge.edge_length = e0.norm();
    hinge.area = 0.5 * (e0.cross(e1).norm() + e0.cross(e2).norm());
    hinge.angle = hinge_angle(rest);
    hinge.cotangents << cotangent(e0, e1), cotangent(-e0, e3), cotangent(e0, e2), cotangent(-e0, e4);
    return hinge;
}

double hinge_angle(const HingePositions& x) {
    return DihedralAngle(x).angle();
}

double hinge_strain(const RestHinge& rest, double angle) {
    const double change = std::remainder(angle - rest.angle, 2 * std::numbers::pi);
    return rest.edge_length / rest.area * change;
}

double hinge_strain(const RestHinge& rest, const HingePositions& x) {
    return hinge_strain(rest, hinge_angle(x));
}

}  // namespace sherd
