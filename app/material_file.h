// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include "app/scene/material_axis.h"
#include "core/material/material.h"

namespace sherd {

/// Contents of a material file, without a scene.
struct MaterialFile {
    Material material;
    MaterialAxis axis;                        ///< axis of a directional material
    std::optional<double> bending_stiffness;  ///< lambda of every hinge instead of the material's, N m
};

/// Reads the keys of a scene's [material] table at the top level of a TOML file, and `bending_stiffness`.
/// Throws Error as read_scene does, with a line for each mistake.
MaterialFile read_material_file(const std::filesystem::path& file);

}  // namespace sherd
