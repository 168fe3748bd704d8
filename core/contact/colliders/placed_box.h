// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/geometry/shape.h"

namespace sherd {

/// Bounding box of a shape at a pose.
class PlacedBox {
  public:
    PlacedBox(const Shape& shape, const Eigen::Isometry3d& pose)
        : box(shape.bounds()), turn(pose.linear()), at(pose.translation()) {}
    /// x in the shape's frame, m.
    Vector3d local(const Vector3d& x) const { return turn.transpose() * (x - at); }
    /// Whether a point in the shape's frame is at most `margin`, m, outside the box along each axis.
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
