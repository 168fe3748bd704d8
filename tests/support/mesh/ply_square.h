// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace sherd::test {

/// Text of a PLY file with a unit square of two triangles, each with an axis, "x y z".
inline std::string ply_square(const std::string& first_axis, const std::string& second_axis) {
    return "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
           "element face 2\nproperty list uchar int vertex_indices\nproperty float axis_x\n"
           "property float axis_y\nproperty float axis_z\nend_header\n"
           "0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
           "3 0 1 2 " +
           first_axis + "\n3 0 2 3 " + second_axis + "\n";
}

}  // namespace sherd::test
