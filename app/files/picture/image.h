// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace sherd {

/// Largest number of bytes that deflate, the compression of PNG and HDF5, can store in one byte; reached for
/// zeros. A file whose header claims a higher compression is damaged.
inline constexpr std::uintmax_t most_of_a_deflated_byte = 1032;

/// An image. Its colours are from 0 to 1 and otherwise as in the file, without any gamma correction.
struct Image {
    int width = 0, height = 0;
    Eigen::Matrix3Xf colours;  ///< red, green, blue of each pixel, row by row from the top left

    Eigen::Vector3f colour(int column, int row) const {
        return colours.col(static_cast<Eigen::Index>(row) * width + column);
    }
};

inline constexpr int largest_image = 16384;  ///< pixels, longest side of an image that can be read

/// Reads a PNG file of any kind: palettes are looked up, grey becomes three equal colours, transparency is
/// dropped, 16 bits are kept and no gamma is applied. Throws Error naming the file if it is missing,
/// unreadable, no PNG, damaged, or larger than largest_image.
Image read_png(const std::filesystem::path& file);

/// Reads a JPEG file; grey becomes three equal colours. Throws Error like read_png.
Image read_jpeg(const std::filesystem::path& file);

/// Reads a file as JPEG or PNG, whichever its first bytes indicate. Throws Error like read_png.
Image read_picture(const std::filesystem::path& file);

/// Returns an image of half the width and half the height, rounded down but at least 1. Each pixel is the
/// mean of four pixels of `image`.
Image half_size(const Image& image);

/// Returns the red, green and blue byte of each pixel, 0 to 255, in the order of Image::colours.
std::vector<std::uint8_t> channel_bytes(const Image& image);

/// Returns the bytes of a JPEG file (quality 90) that shows the image. Equal images give equal bytes.
std::string jpeg_bytes(const Image& image);

/// Returns the bytes of a PNG file with 8 bits per channel that shows the image. Equal images give equal
/// bytes.
std::string png_bytes(const Image& image);

/// An encoded picture, to be embedded in another file.
struct PictureFile {
    std::string bytes;
    bool is_jpeg = false;  ///< if false, the picture is PNG

    const char* media_type() const { return is_jpeg ? "image/jpeg" : "image/png"; }
};

/// Reads an encoded picture. Throws Error naming the file if it cannot be read, or is neither PNG nor JPEG by
/// its first bytes.
PictureFile read_picture_file(const std::filesystem::path& file);

/// Encodes an image as JPEG or PNG.
PictureFile picture_file(const Image& image, bool is_jpeg);

/// The colour of a texel, and its weight in a bilinear mean.
struct WeightedColour {
    Eigen::Vector3f colour;
    double weight;
};

/// Returns the four texels around texture coordinates (u, v); their weights add up to one. (0, 0) is the
/// lower left corner of the image and (1, 1) the upper right one. A texel's colour holds at its centre, and
/// the image repeats in both directions.
std::array<WeightedColour, 4> texels_around(const Image& image, const Eigen::Vector2d& uv);

}  // namespace sherd
