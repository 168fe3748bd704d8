// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/read_write/stl.h"

#include <Eigen/Geometry>

#include "meshops/raw_bytes.h"

namespace sherd {
namespace {

void append_vector(std::string& bytes, const Eigen::Vector3d& vector) {
    for (const double coordinate : vector) append_little_endian(bytes, static_cast<float>(coordinate));
}

}  // namespace

std::string stl_bytes(const TriangleSheet& sheet) {
    // The header must not start with "solid": readers would take the file for a text.
    std::string bytes = "binary STL of sherd, metres";
    bytes.resize(80);
    append_little_endian(bytes, static_cast<std::uint32_t>(sheet.triangles.size()));
    for (const auto& [a, b, c] : sheet.triangles) {
        const Eigen::Vector3d &p = sheet.points[a], &q = sheet.points[b], &r = sheet.points[c];
        append_vector(bytes, (q - p).cross(r - p).normalized());
        append_vector(bytes, p);
        append_vector(bytes, q);
        append_vector(bytes, r);
        append_little_endian(bytes, std::uint16_t{0});
    }
    return bytes;
}

}  // namespace sherd
