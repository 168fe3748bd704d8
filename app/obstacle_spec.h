// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <variant>

#include "core/contact/motion.h"
#include "core/contact/solids.h"

namespace sherd {

/// `[obstacle.NAME]`.
struct ObstacleSpec {
    std::string name;
    std::variant<PlaneShape, SphereShape, BoxShape, CylinderShape> shape;  ///< before it is placed
    Motion motion;
    double friction = 0;
    double young = 0;   ///< Pa, of what it is made of
    std::string where;  ///< "FILE:LINE: dotted.key" of its shape, for errors
};

}  // namespace sherd
