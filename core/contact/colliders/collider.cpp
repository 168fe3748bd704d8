// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/colliders/collider.h"

namespace sherd {

Overlap overlap(const Shape& shape, const Eigen::Isometry3d& pose, const Vector3d& x, double half) {
    const Vector3d local = pose.linear().transpose() * (x - pose.translation());
    const Eigen::AlignedBox3d box = shape.bounds();
    if ((local.array() < box.min().array() - half).any() || (local.array() > box.max().array() + half).any())
        return {};
    const SurfaceDistance surface = shape.distance(local);
    const double depth = half - surface.distance;
    if (!(depth > 0)) return {};
    return {depth, pose.linear() * surface.gradient,
            pose.linear() * surface.hessian * pose.linear().transpose()};
}

}  // namespace sherd
