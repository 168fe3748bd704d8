// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/recording/recording.h"

namespace sherd {

/// Where on the sheets at rest (m) an obstacle touched them first: the vertex that was nearest to it at the
/// end of the first step in which it bore a force, between frames as they are interpolated. Of a free body no
/// force is recorded: then of the first step with any contact. name: "ball" or "obstacle.ball". Throws Error
/// (input) when there is no such obstacle, or it touched nothing.
Vector3d first_contact(const Recording& recording, const std::string& name);

}  // namespace sherd
