// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "app/files/image.h"

namespace sherd {

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

}  // namespace sherd
