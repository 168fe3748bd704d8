// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/vector.h"

namespace sherd {

/// Throws Error (input), with advice on recording it, if a frame does not have the field `name` (of
/// output.fields).
void require_field(const Eigen::Matrix3Xd& values, const std::string& name);

}  // namespace sherd
