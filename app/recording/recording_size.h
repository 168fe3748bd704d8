// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shell/face_fields.h"

namespace sherd {

/// Numbers of elements of a mesh.
struct MeshSize {
    double vertices = 0, faces = 0, edges = 0;
    double moving_points = 0;  ///< number of points of moving obstacles and bodies
};

/// Returns the estimated size, bytes, of a recording without cracks that has so many frames and steps.
/// columns: number of reactions and gauges in each step.
double recording_size(const MeshSize& mesh, double frames, double steps, double columns,
                      const FaceFieldChoice& fields = {});

}  // namespace sherd
