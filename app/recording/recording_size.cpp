// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/recording_size.h"

namespace sherd {

double recording_size(const MeshSize& mesh, double frames, double steps, double columns,
                      const FaceFieldChoice& fields) {
    const int tensors = 2 * fields.stress + fields.curvature + fields.membrane_strain;
    // Bytes per element, measured with compression, and including HDF5's own data. Compression shrinks
    // coordinates by a quarter, and indices of vertices and faces to a third.
    const double of_faces = 6 + 40 * tensors + (fields.any() ? 40 : 0);
    const double frame =
        47 * mesh.vertices + of_faces * mesh.faces + 11 * mesh.edges + 19 * mesh.moving_points + 40e3;
    const double step = 220 + 8 * columns, head = 60e3;
    return head + frames * frame + steps * step;
}

}  // namespace sherd
