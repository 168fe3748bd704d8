// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/files/picture/image.h"
#include "fracture/record/snapshot.h"

namespace sherd {

/// Pictures embedded in a page, each once.
class PagePictures {
  public:
    /// Returns the index of a picture, and adds it if it is new. Throws Error naming the file if it cannot be
    /// read.
    std::int32_t add(const std::filesystem::path& file);

    /// Halves the largest picture repeatedly, until all take at most `most_bytes` of the page; `warnings`
    /// gets a sentence for each that is smaller then.
    void fit(std::size_t most_bytes, std::vector<std::string>& warnings);

    std::size_t bytes() const;              ///< size of all in the page
    std::vector<std::string> urls() const;  ///< with their content ("data:")

  private:
    struct Picture {
        std::filesystem::path file;
        PictureFile content;
        Image smaller = {};  ///< image in `content`, if it has been halved
    };
    static void halve(Picture& picture);

    std::vector<Picture> pictures;
};

/// Look of a recording's sheets on its page, from the files of their meshes.
class PageLook {
  public:
    /// Arrays of a frame, of which the page gets the changes. Empty: none of the look.
    struct Arrays {
        std::vector<std::uint32_t> texture;   ///< [6 F] bits of the floats u and v of the corners
        std::vector<std::uint32_t> material;  ///< [F] indices of materials()
        std::vector<std::uint32_t> colour;    ///< [3 F] colours of corners: red + 256 green + 65536 blue
    };

    struct Material {
        std::uint32_t colour;  ///< 0xRRGGBB (sRGB), multiplied by the colours of corners
        std::int32_t picture;  ///< index of pictures(), instead of the colour; -1: none
    };

    /// look: of the unfractured mesh. Pictures take at most `picture_bytes` of the page; `warnings` gets a
    /// sentence for each that cannot be read, or is reduced.
    PageLook(const SurfaceLook& look, std::size_t picture_bytes, std::vector<std::string>& warnings);

    Arrays arrays(const Snapshot& frame) const;
    /// Materials of the files, and behind them one for faces without a material.
    const std::vector<Material>& materials() const { return drawn; }
    const PagePictures& pictures() const { return files; }

  private:
    Material drawn_material(const SurfaceMaterial& material, bool has_texture,
                            std::vector<std::string>& warnings);

    std::vector<SurfaceMaterial> known;
    std::vector<Material> drawn;
    PagePictures files;
};

/// Approximate size of such arrays in a page, bytes, without changes.
std::size_t look_bytes(const SurfaceLook& look, std::size_t faces);

}  // namespace sherd
