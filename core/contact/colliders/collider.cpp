// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/colliders/collider.h"

#include "core/contact/colliders/placed_box.h"

namespace sherd {

Overlap overlap(const Shape& shape, const Eigen::Isometry3d& pose, const Vector3d& x, double half) {
    const PlacedBox box(shape, pose);
    const Vector3d local = box.local(x);
    if (!box.is_near(local, half)) return {};
    const SurfaceDistance surface = shape.distance(local);
    const double depth = half - surface.distance;
    if (!(depth > 0)) return {};
    return {depth, pose.linear() * surface.gradient,
            pose.linear() * surface.hessian * pose.linear().transpose()};
}

}  // namespace sherd
