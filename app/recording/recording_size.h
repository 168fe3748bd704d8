// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shell/face_fields.h"

namespace sherd {

/// Elements of a mesh.
struct MeshSize {
    double vertices = 0, faces = 0, edges = 0;
    double moving_points = 0;  ///< points of moving obstacles and bodies
};

/// Returns the estimated size of a recording without cracks, bytes. columns: number of reactions and gauges
/// in a step.
double recording_size(const MeshSize& mesh, double frames, double steps, double columns,
                      const FaceFieldChoice& fields = {});

}  // namespace sherd
