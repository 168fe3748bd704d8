// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/render/render_scene.h"

namespace sherd {

/// The tip of a crack as it is drawn: a ball of `radius` (m) at `place` (m), out of which a cone points along
/// `direction` (unit), so long as `reach` (m), from the ball's middle.
struct TipMark {
    Eigen::Vector3d place, direction;
    double radius, reach;
    Eigen::Vector3f colour;  ///< albedo
};

/// All of them in one mesh; origin: m, subtracted from all positions.
RenderMesh tip_marks(const std::vector<TipMark>& marks, const Eigen::Vector3d& origin);

}  // namespace sherd
