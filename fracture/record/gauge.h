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
    bool displacement = true;           ///< whether it is measured
    FaceFieldChoice fields = {};        ///< fields of its face that are measured, too
};

/// Reading of a gauge at the end of a step; zero where a quantity is not measured.
struct GaugeReading {
    Vector3d displacement = Vector3d::Zero();  ///< m, from the rest shape
    // Quantities of its face, in which strain and curvature are constant: see FaceState.
    Vector3d curvature = Vector3d::Zero();        ///< 1/m
    Vector3d membrane_strain = Vector3d::Zero();  ///< 1
    Vector3d stress_top = Vector3d::Zero();       ///< Pa
    Vector3d stress_bottom = Vector3d::Zero();    ///< Pa
};

/// The largest (most tensile) principal stress of both surfaces, Pa.
double largest_stress(const GaugeReading& reading);

/// The gauge at the point of the faces of `sheet` (-1: of any sheet) that is nearest to `place` (m) at rest.
Gauge nearest_gauge(const Shell& shell, const Vector3d& place, Index sheet);

/// Returns the reading of a gauge. state: of its face; not needed when no field is measured.
GaugeReading reading(const Shell& shell, const Gauge& gauge, const std::optional<FaceState>& state = {});

/// Keeps gauges at their material point when the shell has changed: of the faces that cover a part of the
/// gauge's old face, the gauge gets the one that contains its place.
void follow(const Shell& shell, const ShellChange& change, std::span<Gauge> gauges);

}  // namespace sherd
