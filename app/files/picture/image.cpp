// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/picture/image.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <csetjmp>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include "meshops/error.h"

namespace sherd {
namespace {

using FilePointer = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// Indices of the two texels beside a texture coordinate, and the weight of `high` in a linear interpolation.
struct Neighbours {
    int low, high;
    double weight;
};

Neighbours neighbours(double coordinate, int count) {
    const double at = (coordinate - std::floor(coordinate)) * count - 0.5, low = std::floor(at);
    const auto wrapped = [count](double index) { return (static_cast<int>(index) + count) % count; };
    return {wrapped(low), wrapped(low + 1), at - low};
}

void keep_message(png_structp png, png_const_charp message) {
    *static_cast<std::string*>(png_get_error_ptr(png)) = message;
    png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

/// Owner of libpng's structures while a file is read.
class PngReader {
  public:
    PngReader()
        : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, &message, keep_message, ignore_warning)),
          info(png ? png_create_info_struct(png) : nullptr) {
        if (!info) throw std::bad_alloc();
    }
    ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;

    /// Returns false and sets `message` if libpng fails. libpng then jumps back into this function, in which
    /// therefore nothing may need a destructor.
    bool read(std::FILE* file) {
        if (setjmp(png_jmpbuf(png))) return false;
        png_init_io(png, file);
        png_set_user_limits(png, largest_image, largest_image);
        // Ancillary chunks are skipped, since libpng would trust any length that a damaged file claims.
        png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
        png_read_png(png, info,
                     PNG_TRANSFORM_EXPAND_16 | PNG_TRANSFORM_GRAY_TO_RGB | PNG_TRANSFORM_STRIP_ALPHA,
                     nullptr);
        return true;
    }

    std::string message;
    png_structp png;
    png_infop info;
};

void append_bytes(png_structp png, png_bytep bytes, std::size_t count) {
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
}

void flush_nothing(png_structp) {}

/// Owner of libpng's structures while an image is written.
class PngWriter {
  public:
    PngWriter()
        : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, &message, keep_message, ignore_warning)),
          info(png ? png_create_info_struct(png) : nullptr) {
        if (!info) throw std::bad_alloc();
    }
    ~PngWriter() { png_destroy_write_struct(&png, &info); }
    PngWriter(const PngWriter&) = delete;
    PngWriter& operator=(const PngWriter&) = delete;

    /// Returns false and sets `message` if libpng fails, like PngReader::read(). rows: for each row of the
    /// image, the red, green and blue bytes of its pixels.
    bool write(int width, int height, png_bytepp rows) {
        if (setjmp(png_jmpbuf(png))) return false;
        png_set_write_fn(png, &bytes, append_bytes, flush_nothing);
        png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(height), 8,
                     PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                     PNG_FILTER_TYPE_DEFAULT);
        png_set_rows(png, info, rows);
        png_write_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
        return true;
    }

    std::string message, bytes;
    png_structp png;
    png_infop info;
};

Image image_of(PngReader& reader) {
    Image image;
    image.width = static_cast<int>(png_get_image_width(reader.png, reader.info));
    image.height = static_cast<int>(png_get_image_height(reader.png, reader.info));
    image.colours.resize(3, static_cast<Eigen::Index>(image.width) * image.height);
    const png_bytepp rows = png_get_rows(reader.png, reader.info);
    const auto full = [](png_const_bytep two) {
        return static_cast<float>(two[0] * 256 + two[1]) / 65535;  // most significant byte first
    };
    Eigen::Index pixel = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x, ++pixel)
            for (int channel = 0; channel < 3; ++channel)
                image.colours(channel, pixel) = full(rows[y] + 6 * x + 2 * channel);
    return image;
}

/// The first bytes of a PNG file: its signature, length and name of the first chunk, width and height.
using PngHead = std::array<png_byte, 24>;

PngHead head_of(std::FILE* file) {
    PngHead head{};
    if (std::fread(head.data(), 1, head.size(), file) < 8) head.fill(0);
    std::rewind(file);
    return head;
}

bool is_png(const PngHead& head) {
    return png_sig_cmp(head.data(), 0, 8) == 0;
}

/// Whether a file of so many bytes is too short for an image of the size in `head`. Must be known before
/// reading: libpng allocates all rows before it reads the first one.
bool is_cut_off(const PngHead& head, std::uintmax_t bytes) {
    const std::uintmax_t width = png_get_uint_32(head.data() + 16),
                         height = png_get_uint_32(head.data() + 20);
    return height * (1 + width / 8) / most_of_a_deflated_byte > bytes;
}

}  // namespace

std::array<WeightedColour, 4> texels_around(const Image& image, const Eigen::Vector2d& uv) {
    const Neighbours x = neighbours(uv.x(), image.width), y = neighbours(uv.y(), image.height);
    const auto texel = [&](int column, int row) { return image.colour(column, image.height - 1 - row); };
    return {{{texel(x.low, y.low), (1 - x.weight) * (1 - y.weight)},
             {texel(x.high, y.low), x.weight * (1 - y.weight)},
             {texel(x.low, y.high), (1 - x.weight) * y.weight},
             {texel(x.high, y.high), x.weight * y.weight}}};
}

PictureFile read_picture_file(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    PictureFile picture{{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()}};
    picture.is_jpeg = picture.bytes.starts_with("\xff\xd8\xff");
    if (picture.bytes.empty())
        throw Error(file.string() + ": the picture cannot be read, or is empty; check the path");
    if (!picture.is_jpeg && !picture.bytes.starts_with("\x89PNG\r\n\x1a\n"))
        throw Error(file.string() + ": the picture is neither .png nor .jpg");
    return picture;
}

PictureFile picture_file(const Image& image, bool is_jpeg) {
    return {is_jpeg ? jpeg_bytes(image) : png_bytes(image), is_jpeg};
}

Image read_png(const std::filesystem::path& file) {
    const auto fail = [&](const std::string& what) {
        return Error(fmt::format("{}: {}", file.string(), what));
    };
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored)) throw fail("is a folder, a PNG file is needed");
    const FilePointer stream(std::fopen(file.c_str(), "rb"), std::fclose);
    if (!stream) throw fail("cannot read the image: " + std::generic_category().message(errno));
    const PngHead head = head_of(stream.get());
    if (!is_png(head)) throw fail("is not a PNG file");
    if (is_cut_off(head, std::filesystem::file_size(file, ignored)))
        throw fail("damaged PNG file: it ends before all its pixels");
    PngReader reader;
    if (!reader.read(stream.get())) throw fail("damaged PNG file: " + reader.message);
    return image_of(reader);
}

Image half_size(const Image& image) {
    Image half;
    half.width = std::max(1, image.width / 2);
    half.height = std::max(1, image.height / 2);
    half.colours.resize(3, static_cast<Eigen::Index>(half.width) * half.height);
    for (int y = 0; y < half.height; ++y)
        for (int x = 0; x < half.width; ++x) {
            const int right = std::min(2 * x + 1, image.width - 1),
                      below = std::min(2 * y + 1, image.height - 1);
            half.colours.col(static_cast<Eigen::Index>(y) * half.width + x) =
                (image.colour(2 * x, 2 * y) + image.colour(right, 2 * y) + image.colour(2 * x, below) +
                 image.colour(right, below)) /
                4;
        }
    return half;
}

std::vector<std::uint8_t> channel_bytes(const Image& image) {
    std::vector<std::uint8_t> bytes(image.colours.size());
    for (Eigen::Index i = 0; i < image.colours.size(); ++i)
        bytes[i] = static_cast<std::uint8_t>(std::clamp(image.colours.data()[i], 0.0f, 1.0f) * 255 + 0.5f);
    return bytes;
}

std::string png_bytes(const Image& image) {
    std::vector<png_byte> pixels = channel_bytes(image);
    std::vector<png_bytep> rows;
    for (int y = 0; y < image.height; ++y)
        rows.push_back(&pixels[3 * static_cast<std::size_t>(image.width) * y]);
    PngWriter writer;
    if (!writer.write(image.width, image.height, rows.data()))
        throw Error("cannot make a PNG image: " + writer.message, Fault::run);
    return std::move(writer.bytes);
}

}  // namespace sherd
