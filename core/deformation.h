// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/vector.h"

namespace sherd {

/// A scripted deformation: where the same points are at several times.
struct Deformation {
    std::vector<double> times;              ///< s, ascending, at least one
    std::vector<Eigen::Matrix3Xf> samples;  ///< [3, P] m, at each of these times
    /// Interpolation between samples: true: by cubics whose velocity is continuous, in a sample that of its
    /// two neighbours (Catmull and Rom 1974), and none in the first and the last one; false: at constant
    /// speed.
    bool smooth = true;

    /// [3, P] m, at `time` (s). They rest before the first and after the last sample.
    Positions at(double time) const;
};

}  // namespace sherd
