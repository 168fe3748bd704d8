// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/shell/shell.h"
#include "core/shell_change.h"

namespace sherd {

/// A point of the material at which something is measured in each step.
struct Gauge {
    Index face = 0;
    Vector3d place = Vector3d::Zero();  ///< m, on the face at rest
};

/// What a gauge shows at the end of a step.
struct GaugeReading {
    Vector3d displacement = Vector3d::Zero();  ///< m, from where the sheet was placed
};

/// The gauge at the point of the faces of `sheet` (-1: of any sheet) that is nearest to `place` (m) at rest.
Gauge nearest_gauge(const Shell& shell, const Vector3d& place, Index sheet);

GaugeReading reading(const Shell& shell, const Gauge& gauge);

/// Lets gauges stay with their material when the shell has changed: of the parts of a face that was split,
/// the one that has the place is the gauge's from then on.
void follow(const Shell& shell, const ShellChange& change, std::span<Gauge> gauges);

}  // namespace sherd
