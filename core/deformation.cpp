// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/deformation.h"

#include <algorithm>

namespace sherd {
namespace {

/// Velocity at a sample, m/s.
Positions velocity(const Deformation& deformation, std::size_t sample) {
    const auto& [times, samples, smooth] = deformation;
    if (sample == 0 || sample + 1 == samples.size()) return Positions::Zero(3, samples[sample].cols());
    return (samples[sample + 1].cast<double>() - samples[sample - 1].cast<double>()) /
           (times[sample + 1] - times[sample - 1]);
}

}  // namespace

Positions Deformation::at(double time) const {
    const std::size_t next = std::ranges::upper_bound(times, time) - times.begin();
    if (next == 0) return samples.front().cast<double>();
    if (next == times.size()) return samples.back().cast<double>();
    const double length = times[next] - times[next - 1], s = (time - times[next - 1]) / length;
    const Positions from = samples[next - 1].cast<double>();
    const Positions way = samples[next].cast<double>() - from;
    if (!smooth) return from + s * way;
    return from + s * s * (3 - 2 * s) * way + length * s * (1 - s) * (1 - s) * velocity(*this, next - 1) -
           length * s * s * (1 - s) * velocity(*this, next);
}

}  // namespace sherd
