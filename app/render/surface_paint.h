// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/render/material_look.h"
#include "app/render/render_solid.h"

namespace sherd {

/// Paints sheets as the files of their meshes say: with materials, their pictures, and colours.
class SurfacePaint {
  public:
    /// Reads the pictures of the materials; `warnings` gets a sentence for each that cannot be read. Throws
    /// Error (input) if the look says nothing of how a sheet is painted.
    SurfacePaint(const SurfaceLook& look, std::vector<std::string>& warnings);

    /// plain: albedo of what the files say nothing of.
    SheetPaint paint(const Snapshot& frame, const Eigen::Vector3f& plain) const;

  private:
    struct Known {
        SurfaceMaterial material;
        Eigen::Vector3f colour;
        std::int32_t picture;  ///< number; -1: none
    };
    void add(const SurfaceMaterial& material, std::vector<std::string>& warnings);
    std::vector<const Known*> known_of(const SurfaceLook& look) const;

    std::vector<Known> known;
    std::vector<std::shared_ptr<const Image>> pictures;
};

}  // namespace sherd
