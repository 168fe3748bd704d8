// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/geometry/shape.h"

namespace sherd {

/// Bounding box of a shape that has a pose, aligned with the axes of the shape's frame.
class PlacedBox {
  public:
    PlacedBox(const Shape& shape, const Eigen::Isometry3d& pose)
        : box(shape.bounds()), turn(pose.linear()), at(pose.translation()) {}
    /// Returns the point x (m, in space) in the shape's frame.
    Vector3d local(const Vector3d& x) const { return turn.transpose() * (x - at); }
    /// Whether the point `local` (m, in the shape's frame) is outside the box by at most `margin` (m) along
    /// each axis.
    bool is_near(const Vector3d& local, double margin) const {
        return (local.array() >= box.min().array() - margin).all() &&
               (local.array() <= box.max().array() + margin).all();
    }

  private:
    Eigen::AlignedBox3d box;
    Matrix3d turn;
    Vector3d at;
};

}  // namespace sherd
