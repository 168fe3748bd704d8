// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/messages/place_text.h"

#include <fmt/format.h>

#include "meshops/mesh_measures.h"

namespace sherd {

std::string place_text(const Vector3d& at) {
    return fmt::format("({:.4g}, {:.4g}, {:.4g}) m", at.x(), at.y(), at.z());
}

std::string face_text(const Mesh& mesh, Face face) {
    return fmt::format("face {} at {}", face.idx(), place_text(centroid(mesh, face)));
}

}  // namespace sherd
