// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/render/trace/render_scene.h"

namespace sherd {

/// A crack tip to be drawn: a ball of `radius` (m) at `place` (m), with a cone along `direction` (unit) that
/// is `reach` (m) long from the ball's middle.
struct TipMark {
    Eigen::Vector3d place, direction;
    double radius, reach;
    Eigen::Vector3f colour;  ///< albedo
};

/// Returns all marks as one mesh. origin: m, is subtracted from all positions.
RenderMesh tip_marks(const std::vector<TipMark>& marks, const Eigen::Vector3d& origin);

}  // namespace sherd
