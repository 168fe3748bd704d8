// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/files/picture/image.h"
#include "fracture/record/snapshot.h"

namespace sherd {

/// Pictures that are embedded in a page, each once.
class PagePictures {
  public:
    /// Returns the index of the picture in a file, and adds the picture if it is new. Throws Error naming the
    /// file if it cannot be read.
    std::int32_t add(const std::filesystem::path& file);

    /// Halves width and height of the largest picture repeatedly, until all pictures take at most
    /// `most_bytes` of the page or none can be halved. Adds a warning for each picture that has been reduced.
    void fit(std::size_t most_bytes, std::vector<std::string>& warnings);

    std::size_t bytes() const;              ///< size of all pictures in the page
    std::vector<std::string> urls() const;  ///< URLs that contain the pictures: "data:..."

  private:
    struct Picture {
        std::filesystem::path file;
        PictureFile content;
        Image smaller = {};  ///< reduced image, which `content` has; empty if it has not been halved
    };
    static void halve(Picture& picture);

    std::vector<Picture> pictures;
};

/// Look of a recording's sheets on its page: texture, materials and colours from the files of their meshes.
class PageLook {
  public:
    /// Arrays of a frame. The page stores them for the first frame, and then their changes from frame to
    /// frame. An array is empty if the look has no such data.
    struct Arrays {
        std::vector<std::uint32_t> texture;   ///< [6 F] u and v of each corner, as bits of floats
        std::vector<std::uint32_t> material;  ///< [F] index in materials() of each face's material
        std::vector<std::uint32_t> colour;    ///< [3 F] colours of corners: red + 256 green + 65536 blue
    };

    struct Material {
        std::uint32_t colour;  ///< 0xRRGGBB (sRGB), multiplied by the colours of corners
        std::int32_t picture;  ///< index in pictures() of the picture that replaces the colour; -1: none
    };

    /// look: of the unfractured mesh. The pictures take at most `picture_bytes` of the page. Adds a warning
    /// for each picture that cannot be read, or that is reduced.
    PageLook(const SurfaceLook& look, std::size_t picture_bytes, std::vector<std::string>& warnings);

    Arrays arrays(const Snapshot& frame) const;
    /// Materials in the meshes' files, and after them the material of faces that have none.
    const std::vector<Material>& materials() const { return drawn; }
    const PagePictures& pictures() const { return files; }

  private:
    Material drawn_material(const SurfaceMaterial& material, bool has_texture,
                            std::vector<std::string>& warnings);

    std::vector<SurfaceMaterial> known;
    std::vector<Material> drawn;
    PagePictures files;
};

/// Returns the approximate size, bytes, in a page of PageLook::Arrays of a frame with `faces` faces, without
/// their changes in later frames.
std::size_t look_bytes(const SurfaceLook& look, std::size_t faces);

}  // namespace sherd
