// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sherd::test {

/// Scene of a small disc that falls for two milliseconds: a short run.
inline const std::string falling_disc = R"(duration = 0.002
[sheet.plate]
mesh = { generate = "disc", radius = 0.1, edge_length = 0.03 }
material = { preset = "stoneware" }
)";

}  // namespace sherd::test
