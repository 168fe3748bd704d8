// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <filesystem>

#include "meshops/surface_material.h"

namespace sherd {

/// Properties of a material that a picture shows, from the material's definition in .mtl. Numbers in .mtl are
/// taken as linear light, as Blender does.
struct MaterialLook {
    Eigen::Vector3f colour = Eigen::Vector3f::Constant(0.8f);  ///< `Kd`: albedo, linear light
    float opacity = 1;                                         ///< `d`, or 1 - `Tr`
    float roughness = 0.6f;                                    ///< from `Ns`, as in Blender
    Eigen::Vector3f glow = Eigen::Vector3f::Zero();            ///< `Ke`: emitted light
    std::filesystem::path picture;                             ///< `map_Kd`: replaces the colour; empty: none
};

/// Reads the definition of a material. Values that the definition lacks, or that are no numbers, keep their
/// defaults.
MaterialLook material_look(const SurfaceMaterial& material);

}  // namespace sherd
