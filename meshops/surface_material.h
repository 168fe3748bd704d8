// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <memory>
#include <string>

namespace sherd {

/// Appearance of a surface: a material of an OBJ file.
struct SurfaceMaterial {
    std::string name;  ///< name in `usemtl` lines
    /// Lines of the .mtl file between the `newmtl` of this material and the next `newmtl`, with absolute
    /// paths of pictures; empty if no .mtl file defines the material.
    std::string definition = {};

    auto operator<=>(const SurfaceMaterial&) const = default;
};

/// Pointer to the material of a face, which faces of the same material share; null: none.
using FaceMaterial = std::shared_ptr<const SurfaceMaterial>;

/// Whether two pointers are both null, or point to equal values.
template <class T>
bool is_same(const std::shared_ptr<const T>& a, const std::shared_ptr<const T>& b) {
    return a == b || (a && b && *a == *b);
}

}  // namespace sherd
