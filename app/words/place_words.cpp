// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/words/place_words.h"

#include <fmt/format.h>

#include "meshops/mesh_measures.h"

namespace sherd {

std::string place_words(const Vector3d& at) {
    return fmt::format("({:.4g}, {:.4g}, {:.4g}) m", at.x(), at.y(), at.z());
}

std::string face_words(const Mesh& mesh, Face face) {
    return fmt::format("face {} at {}", face.idx(), place_words(centroid(mesh, face)));
}

}  // namespace sherd
