// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <filesystem>

#include "meshops/surface_material.h"

namespace sherd {

/// What a picture of a material needs of its definition in .mtl. Numbers in .mtl are taken for linear light,
/// as Blender takes them.
struct MaterialLook {
    Eigen::Vector3f colour = Eigen::Vector3f::Constant(0.8f);  ///< `Kd`: albedo, linear light
    float opacity = 1;                                         ///< `d`, or 1 less `Tr`
    float roughness = 0.6f;                                    ///< by `Ns`, as Blender takes it
    Eigen::Vector3f glow = Eigen::Vector3f::Zero();            ///< `Ke`
    std::filesystem::path picture;  ///< `map_Kd`, instead of the colour; empty: none
};

/// What the definition does not say, or not in numbers, is as above.
MaterialLook material_look(const SurfaceMaterial& material);

}  // namespace sherd
