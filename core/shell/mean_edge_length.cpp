// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shell/mean_edge_length.h"

#include <limits>

namespace sherd {

double mean_edge_length(const Shell& shell) {
    if (shell.triangles.empty()) return std::numeric_limits<double>::infinity();
    double sum = 0;
    for (const TriangleStencil& triangle : shell.triangles)
        for (int i = 0; i < 3; ++i)
            sum += (shell.rest.col(triangle.vertices[i]) - shell.rest.col(triangle.vertices[(i + 1) % 3]))
                       .norm();
    return sum / (3.0 * static_cast<double>(shell.triangles.size()));
}

}  // namespace sherd
