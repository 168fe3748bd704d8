// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/mesh_spec.h"

#include <cmath>

namespace sherd {

double expected_faces(double area, double edge_length) {
    return area / (std::sqrt(3.0) / 4 * edge_length * edge_length);
}

}  // namespace sherd
