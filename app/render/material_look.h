// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <filesystem>

#include "meshops/surface_material.h"

namespace sherd {

/// Properties of a material that a picture shows, from its definition in .mtl. Numbers in .mtl are taken for
/// linear light, as Blender takes them.
struct MaterialLook {
    Eigen::Vector3f colour = Eigen::Vector3f::Constant(0.8f);  ///< `Kd`: albedo, linear light
    float opacity = 1;                                         ///< `d`, or 1 less `Tr`
    float roughness = 0.6f;                                    ///< by `Ns`, as Blender takes it
    Eigen::Vector3f glow = Eigen::Vector3f::Zero();            ///< `Ke`
    std::filesystem::path picture;  ///< `map_Kd`, instead of the colour; empty: none
};

/// Reads the definition of a material; values that it lacks, or that are no numbers, keep their defaults.
MaterialLook material_look(const SurfaceMaterial& material);

}  // namespace sherd
