// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/colliders/rigid_body.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/contact/geometry/basic_shapes.h"

namespace sherd {
namespace {

constexpr double steel_young = 2.1e11;  // Pa, Young's modulus

}  // namespace

RigidBody rigid_sphere(double radius, double density) {
    RigidBody body;
    body.young = steel_young;
    body.shape = std::make_shared<SphereShape>(Vector3d::Zero(), radius);
    body.mass = 4.0 / 3 * std::numbers::pi * radius * radius * radius * density;
    body.inertia.setConstant(0.4 * body.mass * radius * radius);
    body.contact_points = {Vector3d::Zero()};
    body.contact_radius = radius;
    body.contact_length = radius;
    return body;
}

RigidBody rigid_box(const Vector3d& size, double density) {
    RigidBody body;
    body.young = steel_young;
    body.shape = std::make_shared<BoxShape>(Vector3d::Zero(), 0.5 * size);
    body.mass = size.prod() * density;
    const Vector3d squares = size.cwiseAbs2();
    body.inertia = body.mass / 12 * (Vector3d::Constant(squares.sum()) - squares);
    for (int i = 0; i < 8; ++i)
        body.contact_points.push_back(
            0.5 * size.cwiseProduct(Vector3d(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)));
    body.contact_length = 0.25 * std::cbrt(size.prod());
    return body;
}

RigidBody rigid_solid(double volume, const Vector3d& inertia, const Positions& points, double density) {
    RigidBody body;
    body.young = steel_young;
    body.mass = volume * density;
    body.inertia = inertia * density;
    for (const auto& point : points.colwise()) body.contact_points.push_back(point);
    // If a sixth of a fine mesh's points lie on a floor, as on a side of a cube, they are together as stiff
    // as the four corners of a box.
    const double count = std::max<double>(1, static_cast<double>(points.cols()));
    body.contact_length = std::cbrt(volume) * std::min(0.25, 6 / count);
    return body;
}

}  // namespace sherd
