// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/picture_file.h"

#include <fstream>
#include <iterator>

#include "meshops/error.h"

namespace sherd {

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

}  // namespace sherd
