// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/scene/scene.h"
#include "fracture/breakable_shell.h"

namespace sherd {

/// How far cracks by toughness may run in a step of the scene, and which step resolves them edge by edge
/// (resolving_step()). Empty in statics, where no sheet has a toughness, and where explicit steps are short
/// enough, as they are meant to be.
std::string crack_step_words(const Scene& scene, const BreakableShell& sheets);

}  // namespace sherd
