// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/vector.h"

namespace sherd {

/// Throws Error (input) if `values`, the field `name` of a frame (one of output.fields), has no columns, that
/// is, was not recorded. The message says how to record the field.
void require_field(const Eigen::Matrix3Xd& values, const std::string& name);

}  // namespace sherd
