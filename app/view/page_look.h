// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/view/page_pictures.h"
#include "fracture/snapshot.h"

namespace sherd {

/// How the sheets of a recording look on its page: as the files of their meshes paint them.
class PageLook {
  public:
    /// Of a frame: arrays of numbers of which the page is told the changes. Empty: none has any.
    struct Arrays {
        std::vector<std::uint32_t> texture;   ///< [6 F] bits of the floats u and v of the corners
        std::vector<std::uint32_t> material;  ///< [F] numbers of materials()
        std::vector<std::uint32_t> colour;    ///< [3 F] of corners: red + 256 green + 65536 blue
    };

    struct Material {
        std::uint32_t colour;  ///< 0xRRGGBB (sRGB), which colours of corners multiply
        std::int32_t picture;  ///< of pictures(), instead of the colour; -1: none
    };

    /// look: of the unbroken mesh. Pictures get at most so many bytes of the page; `warnings` gets a sentence
    /// for each that cannot be read, or not as it is.
    PageLook(const SurfaceLook& look, std::size_t picture_bytes, std::vector<std::string>& warnings);

    Arrays arrays(const Snapshot& frame) const;
    /// Those of the files, and behind them one for faces that have none.
    const std::vector<Material>& materials() const { return drawn; }
    const PagePictures& pictures() const { return files; }

  private:
    Material drawn_material(const SurfaceMaterial& material, bool has_texture,
                            std::vector<std::string>& warnings);

    std::vector<SurfaceMaterial> known;
    std::vector<Material> drawn;
    PagePictures files;
};

/// About what arrays of such a look take in a page, before any changes.
std::size_t look_bytes(const SurfaceLook& look, std::size_t faces);

}  // namespace sherd
