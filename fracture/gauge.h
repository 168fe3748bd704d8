// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "core/shell/face_fields.h"
#include "core/shell/shell.h"
#include "core/shell_change.h"

namespace sherd {

/// A point of the material at which something is measured in each step.
struct Gauge {
    Index face = 0;
    Vector3d place = Vector3d::Zero();  ///< m, on the face at rest
    bool displacement = true;           ///< whether it is wanted
    FaceFieldChoice fields = {};        ///< of its face, that are wanted, too
};

/// What a gauge shows at the end of a step; what is not wanted is zero.
struct GaugeReading {
    Vector3d displacement = Vector3d::Zero();  ///< m, from where the sheet was placed
    // These are of its face, which is strained and bent alike everywhere: see FaceState.
    Vector3d curvature = Vector3d::Zero();        ///< 1/m
    Vector3d membrane_strain = Vector3d::Zero();  ///< 1
    Vector3d stress_top = Vector3d::Zero();       ///< Pa
    Vector3d stress_bottom = Vector3d::Zero();    ///< Pa
};

/// The largest principal stress of both surfaces, Pa: the most tensile one.
double largest_stress(const GaugeReading& reading);

/// The gauge at the point of the faces of `sheet` (-1: of any sheet) that is nearest to `place` (m) at rest.
Gauge nearest_gauge(const Shell& shell, const Vector3d& place, Index sheet);

/// state: of its face; none is needed when no field is wanted.
GaugeReading reading(const Shell& shell, const Gauge& gauge, const std::optional<FaceState>& state = {});

/// Lets gauges stay with their material when the shell has changed: of the faces that have a part of what
/// was the gauge's face, the one that has the place is the gauge's from then on.
void follow(const Shell& shell, const ShellChange& change, std::span<Gauge> gauges);

}  // namespace sherd
