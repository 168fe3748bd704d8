// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/vector.h"

namespace sherd {

/// A prescribed deformation: positions of the same points at several times.
struct Deformation {
    std::vector<double> times;              ///< s, ascending, at least one
    std::vector<Eigen::Matrix3Xf> samples;  ///< [3, P] m, positions at each of these times
    /// Interpolation between samples. true: by cubics with a continuous velocity, which at a sample is the
    /// mean velocity between its two neighbours (Catmull and Rom 1974), and zero at the first and the last
    /// sample; false: at constant velocity between two samples.
    bool smooth = true;

    /// Positions [3, P] m at `time` (s). The points rest before the first and after the last sample.
    Positions at(double time) const;
};

}  // namespace sherd
