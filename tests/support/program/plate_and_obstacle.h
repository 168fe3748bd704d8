// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sherd::test {

/// Scene of a plate, and far below it an obstacle `thing`, whose keys are to be appended.
inline const std::string plate_and_obstacle = R"(duration = 0.002
[sheet.plate]
mesh = { generate = "disc", radius = 0.1, edge_length = 0.03 }
place = { translate = [0, 0, 1] }
material = { preset = "stoneware" }
[obstacle.thing]
)";

}  // namespace sherd::test
