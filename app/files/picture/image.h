// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace sherd {

/// Largest number of bytes that deflate compresses into one, reached for zeros. PNG and HDF5 use it: a file
/// whose header claims more is damaged.
inline constexpr std::uintmax_t most_of_a_deflated_byte = 1032;

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

/// An encoded picture, to be embedded in another file.
struct PictureFile {
    std::string bytes;
    bool is_jpeg = false;  ///< otherwise PNG

    const char* media_type() const { return is_jpeg ? "image/jpeg" : "image/png"; }
};

/// Throws Error naming the file if it cannot be read or is neither PNG nor JPEG by its first bytes.
PictureFile read_picture_file(const std::filesystem::path& file);

/// Encodes an image as JPEG or PNG.
PictureFile picture_file(const Image& image, bool is_jpeg);

/// A texel, and its weight in a bilinear mean.
struct WeightedColour {
    Eigen::Vector3f colour;
    double weight;
};

/// Returns the four texels around texture coordinates (u, v); their weights add up to one. (0, 0) is the
/// lower left corner of the image and (1, 1) the upper right one. A texel's colour holds at its centre, and
/// the image repeats in both directions.
std::array<WeightedColour, 4> texels_around(const Image& image, const Eigen::Vector2d& uv);

}  // namespace sherd
