// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sherd {

/// Returns a time of a run with its unit (RecordingHeader::time_unit): "0.5 s", or in statics "load 0.5".
/// number: the time as text.
inline std::string time_text(const std::string& number, const std::string& unit) {
    return unit == "s" ? number + " s" : unit + " " + number;
}

}  // namespace sherd
