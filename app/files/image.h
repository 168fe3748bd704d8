// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace sherd {

/// Colours as a file stores them, 0 to 1.
struct Image {
    int width = 0, height = 0;
    Eigen::Matrix3Xf colours;  ///< red, green, blue; row by row from the top left

    Eigen::Vector3f colour(int column, int row) const {
        return colours.col(static_cast<Eigen::Index>(row) * width + column);
    }
};

inline constexpr int largest_image = 16384;  ///< pixels per side that can be read

/// Reads a PNG file of any kind: palettes are looked up, grey becomes three equal colours, transparency is
/// dropped, 16 bits are kept and no gamma is applied. Throws Error naming the file when it is missing,
/// unreadable, no PNG, damaged, or larger than largest_image.
Image read_png(const std::filesystem::path& file);

/// Reads a JPEG file; grey becomes three equal colours. Throws Error like read_png.
Image read_jpeg(const std::filesystem::path& file);

/// Reads a PNG or JPEG file, by its first bytes.
Image read_picture(const std::filesystem::path& file);

/// Returns an image of half the width and half the height, rounded down but at least 1: the means of four
/// pixels.
Image half_size(const Image& image);

/// Red, green and blue of each pixel in turn, 0 to 255.
std::vector<std::uint8_t> channel_bytes(const Image& image);

/// The bytes of a JPEG file (quality 90) that shows the image; the same bytes for the same image.
std::string jpeg_bytes(const Image& image);

/// The bytes of a PNG file of 8 bits a channel that shows the image; the same bytes for the same image.
std::string png_bytes(const Image& image);

}  // namespace sherd
