// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/scene/scene.h"
#include "fracture/shell/breakable_shell.h"

namespace sherd {

/// Kind of a fault of a face with which a scene cannot start. If a face has faults of several kinds, a
/// picture shows the last of them in this list.
enum class FaultKind {
    zero_area,
    repeated,
    non_manifold,
    inside_obstacle,
    near_obstacle,
    across_obstacle,
    too_near,
    crossing
};

/// A face that a scene cannot start with.
struct StartFault {
    FaultKind kind;
    std::size_t sheet;  ///< number of the sheet in the scene's order
    Index face;         ///< number of the face in the sheet, from 0
    Vector3d at;        ///< m, centroid of the face
};

/// Returns the fault of a face, which is numbered over all sheets in the scene's order.
StartFault start_fault(FaultKind kind, Face face, const BreakableShell& all);

/// Returns, for example, "face 12 at (0.1, 0.02, 0.03) m".
std::string fault_place(const StartFault& fault);

/// Returns, for example, "face 12 of sheet.bowl at (0.1, 0.02, 0.03) m".
std::string fault_text(const StartFault& fault, const Scene& scene);

}  // namespace sherd
