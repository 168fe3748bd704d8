// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "app/files/image.h"

namespace sherd {

/// A picture as a file has it, for files that pictures are put into.
struct PictureFile {
    std::string bytes;
    bool is_jpeg = false;  ///< else it is a PNG file

    const char* media_type() const { return is_jpeg ? "image/jpeg" : "image/png"; }
};

/// Throws Error naming the file if it cannot be read or is neither PNG nor JPEG by its first bytes.
PictureFile read_picture_file(const std::filesystem::path& file);

/// The image as a file of that kind.
PictureFile picture_file(const Image& image, bool is_jpeg);

}  // namespace sherd
