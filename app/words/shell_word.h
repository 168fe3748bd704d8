// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sherd {

/// A word as a shell takes it, in quotes where it needs them.
std::string shell_word(const std::string& word);

}  // namespace sherd
