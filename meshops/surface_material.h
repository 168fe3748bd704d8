// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <memory>
#include <string>

namespace sherd {

/// Appearance of a surface: a material of an OBJ file.
struct SurfaceMaterial {
    std::string name;  ///< name in `usemtl`
    /// Lines between its `newmtl` and the next one of the .mtl, with absolute paths of pictures; empty where
    /// no .mtl has it.
    std::string definition = {};

    auto operator<=>(const SurfaceMaterial&) const = default;
};

/// The material of a face, shared by faces that have the same; null: none.
using FaceMaterial = std::shared_ptr<const SurfaceMaterial>;

/// Whether two shared values are equal, or both missing.
template <class T>
bool is_same(const std::shared_ptr<const T>& a, const std::shared_ptr<const T>& b) {
    return a == b || (a && b && *a == *b);
}

}  // namespace sherd
