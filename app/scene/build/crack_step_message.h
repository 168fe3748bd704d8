// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/scene/scene.h"
#include "fracture/breakable_shell.h"

namespace sherd {

/// Message on how far cracks by toughness may propagate in a step of the scene, and on the step that resolves
/// them edge by edge (resolving_step()). Empty in statics, without a toughness, and where explicit steps are
/// short enough.
std::string crack_step_message(const Scene& scene, const BreakableShell& sheets);

}  // namespace sherd
