// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "core/shell/face_fields.h"
#include "core/shell/shell.h"
#include "core/shell_change.h"

namespace sherd {

/// A point of the material at which quantities are measured in each step.
struct Gauge {
    Index face = 0;
    Vector3d place = Vector3d::Zero();  ///< m, point on the face at rest
    bool displacement = true;           ///< whether the displacement is measured
    FaceFieldChoice fields = {};        ///< fields of the face that are measured, too
};

/// Reading of a gauge at the end of a step; zero where a quantity is not measured.
struct GaugeReading {
    Vector3d displacement = Vector3d::Zero();  ///< m, from the rest shape
    // Quantities of the gauge's face, which are constant in the face: see FaceState.
    Vector3d curvature = Vector3d::Zero();        ///< 1/m
    Vector3d membrane_strain = Vector3d::Zero();  ///< 1
    Vector3d stress_top = Vector3d::Zero();       ///< Pa
    Vector3d stress_bottom = Vector3d::Zero();    ///< Pa
};

/// The largest (most tensile) principal stress at the two surfaces, Pa.
double largest_stress(const GaugeReading& reading);

/// Returns a gauge at the point of the sheet that is nearest to `place` (m) at rest. sheet: number of the
/// sheet; -1: any sheet.
Gauge nearest_gauge(const Shell& shell, const Vector3d& place, Index sheet);

/// Returns the reading of a gauge. state: state of the gauge's face, needed only if the gauge measures a
/// field.
GaugeReading reading(const Shell& shell, const Gauge& gauge, const std::optional<FaceState>& state = {});

/// Must be called when the shell has changed: keeps gauges at their material points. Of the faces that cover
/// a part of a gauge's old face, the gauge gets the face that contains its place.
void follow(const Shell& shell, const ShellChange& change, std::span<Gauge> gauges);

}  // namespace sherd
