// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <csetjmp>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <memory>
#include <system_error>
#include <vector>

// jpeglib.h needs <cstdio>, and does not include it.
#include <jpeglib.h>

#include "app/files/picture/image.h"
#include "meshops/error.h"

namespace sherd {
namespace {

using FilePointer = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// Owner of libjpeg's structure while a file is read.
class JpegReader {
  public:
    JpegReader() {
        jpeg.err = jpeg_std_error(&errors);
        jpeg.client_data = this;
        errors.error_exit = [](j_common_ptr failed) {
            auto* reader = static_cast<JpegReader*>(failed->client_data);
            failed->err->format_message(failed, reader->message.data());
            std::longjmp(reader->before, 1);
        };
        errors.output_message = [](j_common_ptr) {};
        jpeg_create_decompress(&jpeg);
    }
    ~JpegReader() { jpeg_destroy_decompress(&jpeg); }
    JpegReader(const JpegReader&) = delete;
    JpegReader& operator=(const JpegReader&) = delete;

    /// read_head() and read_row() return false and set `message` if libjpeg fails. libjpeg then jumps back
    /// into the function, in which therefore nothing may need a destructor.
    bool read_head(std::FILE* file) {
        if (setjmp(before)) return false;
        jpeg_stdio_src(&jpeg, file);
        jpeg_read_header(&jpeg, TRUE);
        jpeg.out_color_space = JCS_RGB;
        jpeg_start_decompress(&jpeg);
        return true;
    }
    bool read_row(JSAMPROW row) {
        if (setjmp(before)) return false;
        jpeg_read_scanlines(&jpeg, &row, 1);
        return true;
    }

    jpeg_decompress_struct jpeg{};
    std::array<char, JMSG_LENGTH_MAX> message{};

  private:
    jpeg_error_mgr errors{};
    std::jmp_buf before;
};

/// Owner of libjpeg's structure while an image is written.
class JpegWriter {
  public:
    JpegWriter() {
        jpeg.err = jpeg_std_error(&errors);
        jpeg.client_data = this;
        errors.error_exit = [](j_common_ptr failed) {
            auto* writer = static_cast<JpegWriter*>(failed->client_data);
            failed->err->format_message(failed, writer->message.data());
            std::longjmp(writer->before, 1);
        };
        jpeg_create_compress(&jpeg);
    }
    ~JpegWriter() {
        jpeg_destroy_compress(&jpeg);
        std::free(bytes);  // NOLINT(cppcoreguidelines-no-malloc): libjpeg has allocated it
    }
    JpegWriter(const JpegWriter&) = delete;
    JpegWriter& operator=(const JpegWriter&) = delete;

    /// Returns false and sets `message` if libjpeg fails, like JpegReader::read_head(). pixels: red, green
    /// and blue byte of each pixel, row by row from the top.
    bool write(int width, int height, JSAMPLE* pixels) {
        if (setjmp(before)) return false;
        jpeg_mem_dest(&jpeg, &bytes, &size);
        jpeg.image_width = static_cast<JDIMENSION>(width);
        jpeg.image_height = static_cast<JDIMENSION>(height);
        jpeg.input_components = 3;
        jpeg.in_color_space = JCS_RGB;
        jpeg_set_defaults(&jpeg);
        jpeg_set_quality(&jpeg, 90, TRUE);
        jpeg_start_compress(&jpeg, TRUE);
        while (jpeg.next_scanline < jpeg.image_height) {
            JSAMPROW row = pixels + 3 * static_cast<std::size_t>(width) * jpeg.next_scanline;
            jpeg_write_scanlines(&jpeg, &row, 1);
        }
        jpeg_finish_compress(&jpeg);
        return true;
    }

    jpeg_compress_struct jpeg{};
    std::array<char, JMSG_LENGTH_MAX> message{};
    unsigned char* bytes = nullptr;
    unsigned long size = 0;

  private:
    jpeg_error_mgr errors{};
    std::jmp_buf before;
};

}  // namespace

Image read_jpeg(const std::filesystem::path& file) {
    const FilePointer stream(std::fopen(file.c_str(), "rb"), std::fclose);
    if (!stream) throw Error(file.string() + ": " + std::system_category().message(errno));
    JpegReader reader;
    const auto fail = [&] {
        throw Error(
            fmt::format("{}: cannot be read as a JPEG image: {}", file.string(), reader.message.data()));
    };
    if (!reader.read_head(stream.get())) fail();
    Image image;
    image.width = static_cast<int>(reader.jpeg.output_width);
    image.height = static_cast<int>(reader.jpeg.output_height);
    if (image.width > largest_image || image.height > largest_image)
        throw Error(fmt::format("{}: the image is {} x {}, larger than {} x {}; make it smaller",
                                file.string(), image.width, image.height, largest_image, largest_image));
    image.colours.resize(3, static_cast<Eigen::Index>(image.width) * image.height);
    std::vector<JSAMPLE> row(3 * static_cast<std::size_t>(image.width));
    for (int y = 0; y < image.height; ++y) {
        if (!reader.read_row(row.data())) fail();
        for (std::size_t i = 0; i < row.size(); ++i)
            image.colours(static_cast<Eigen::Index>(i % 3),
                          static_cast<Eigen::Index>(y) * image.width + static_cast<Eigen::Index>(i / 3)) =
                static_cast<float>(row[i]) / 255;
    }
    return image;
}

std::string jpeg_bytes(const Image& image) {
    std::vector<std::uint8_t> pixels = channel_bytes(image);
    JpegWriter writer;
    if (!writer.write(image.width, image.height, pixels.data()))
        throw Error(fmt::format("cannot make a JPEG image: {}", writer.message.data()), Fault::run);
    return {reinterpret_cast<const char*>(writer.bytes), writer.size};
}

Image read_picture(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    const bool is_jpeg = stream.get() == 0xff && stream.get() == 0xd8;
    return is_jpeg ? read_jpeg(file) : read_png(file);
}

}  // namespace sherd
