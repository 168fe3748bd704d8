// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/vector.h"
#include "meshops/mesh.h"

namespace sherd {

// Texts of places for messages. Positions are in m.

std::string place_text(const Vector3d& at);          ///< "(0.1, 0.02, 0.03) m"
std::string face_text(const Mesh& mesh, Face face);  ///< "face 12 at (0.1, 0.02, 0.03) m": its centroid

}  // namespace sherd
