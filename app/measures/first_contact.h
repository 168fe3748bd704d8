// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/recording/recording.h"

namespace sherd {

/// Returns the place on the sheets at rest (m) that an obstacle touched first: the vertex nearest to it at
/// the end of the first step in which it had a contact force, interpolated between frames. Forces on free
/// bodies are not recorded: for these the first step with any contact counts. name: "ball" or
/// "obstacle.ball". Throws Error (input) if there is no such obstacle, or if it touched nothing.
Vector3d first_contact(const Recording& recording, const std::string& name);

}  // namespace sherd
