// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/scene/scene.h"
#include "fracture/shell/breakable_shell.h"

namespace sherd {

/// Makes the input for a sheet of a scene, where the scene places the sheet. Throws Error naming the scene's
/// line and key; warnings are sentences. remeshed: see make_unplaced_mesh().
SheetInput make_sheet(const SheetSpec& sheet, const Scene& scene, std::vector<std::string>& warnings,
                      std::string* remeshed = nullptr);

}  // namespace sherd
