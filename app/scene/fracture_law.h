// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sherd {

/// Property that a map or a scored line multiplies: strength, at which cracks nucleate, or toughness, at
/// which they propagate.
enum class FractureLaw { strength, toughness };

}  // namespace sherd
