// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <png.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <vector>

namespace sherd::test {

using Colour16 = std::array<std::uint16_t, 3>;  ///< red, green, blue, each 0 to 65535

/// Writes a PNG file with 16 bits per channel. colours: of the pixels, row by row from the top left.
inline void write_png(const std::filesystem::path& file, png_uint_32 width, png_uint_32 height,
                      const std::vector<Colour16>& colours) {
    std::vector<png_byte> bytes;
    for (const Colour16& colour : colours)
        for (const std::uint16_t channel : colour) {
            bytes.push_back(static_cast<png_byte>(channel >> 8));
            bytes.push_back(static_cast<png_byte>(channel & 255));
        }
    std::FILE* stream = std::fopen(file.c_str(), "wb");
    if (!stream) throw std::runtime_error("cannot write " + file.string());
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, stream);
    png_set_IHDR(png, info, width, height, 16, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    for (png_uint_32 y = 0; y < height; ++y) png_write_row(png, &bytes[6 * width * y]);
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    std::fclose(stream);
}

/// Writes a PNG file of a single colour.
inline void write_png(const std::filesystem::path& file, png_uint_32 width, png_uint_32 height,
                      const Colour16& colour) {
    write_png(file, width, height, std::vector<Colour16>(width * height, colour));
}

}  // namespace sherd::test
