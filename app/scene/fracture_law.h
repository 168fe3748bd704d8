// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sherd {

/// What a map or a scored line changes: where cracks are born, or where they go on.
enum class FractureLaw { strength, toughness };

}  // namespace sherd
