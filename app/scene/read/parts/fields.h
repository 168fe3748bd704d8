// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/shell/face_fields.h"

namespace sherd {

/// Names of the fields of faces.
inline constexpr std::array<std::string_view, 3> field_names{"stress", "curvature", "membrane_strain"};

/// Returns the choice of the fields of faces that are among `names`. Other names are ignored.
FaceFieldChoice chosen_fields(const std::vector<std::string>& names);

}  // namespace sherd
