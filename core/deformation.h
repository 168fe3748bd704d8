// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/vector.h"

namespace sherd {

/// A prescribed deformation: positions of the same points at several times.
struct Deformation {
    std::vector<double> times;              ///< s, ascending, at least one
    std::vector<Eigen::Matrix3Xf> samples;  ///< [3, P] m, at each of these times
    /// Interpolation between samples: true: by cubics with a continuous velocity, at a sample the mean
    /// velocity between its two neighbours (Catmull and Rom 1974), zero at the first and the last one; false:
    /// at constant speed.
    bool smooth = true;

    /// Positions [3, P] m at `time` (s). The points rest before the first and after the last sample.
    Positions at(double time) const;
};

}  // namespace sherd
