// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "app/render/material_look.h"
#include "app/render/render_solid.h"

namespace sherd {

/// Colour 0xRRGGBB (sRGB) of sheets whose files define none.
inline constexpr std::uint32_t porcelain = 0xd8d2c6;

/// Throws Error (input) if a recording's look has neither materials nor colours.
void require_paint(const SurfaceLook& look);

/// Returns the warning that a material is drawn in its colour, because its picture cannot be read.
std::string unread_picture(const SurfaceMaterial& material, const std::exception& error);

/// Paint of sheets from the files of their meshes: materials, their pictures, and colours.
class SurfacePaint {
  public:
    /// Reads the pictures of the materials; `warnings` gets a sentence for each picture that cannot be read.
    /// Throws Error as require_paint() does.
    SurfacePaint(const SurfaceLook& look, std::vector<std::string>& warnings);

    /// Returns the paint of a frame's sheets. plain: albedo where the files define none.
    SheetPaint paint(const Snapshot& frame, const Eigen::Vector3f& plain) const;

  private:
    struct Known {
        SurfaceMaterial material;
        Eigen::Vector3f colour;
        std::int32_t picture;  ///< index in `pictures`; -1: none
    };
    void add(const SurfaceMaterial& material, std::vector<std::string>& warnings);
    std::vector<const Known*> known_of(const std::vector<SurfaceMaterial>& materials) const;

    std::vector<Known> known;
    std::vector<std::shared_ptr<const Image>> pictures;
};

}  // namespace sherd
