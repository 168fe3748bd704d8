// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/files/picture_file.h"

namespace sherd {

/// Pictures embedded in a page, each once.
class PagePictures {
  public:
    /// Returns the index of a picture, and adds it if it is new. Throws Error naming the file if it cannot be
    /// read.
    std::int32_t add(const std::filesystem::path& file);

    /// Halves the largest picture repeatedly, until all take at most `most_bytes` of the page; `warnings`
    /// gets a sentence for each that is smaller then.
    void fit(std::size_t most_bytes, std::vector<std::string>& warnings);

    std::size_t bytes() const;              ///< size of all in the page
    std::vector<std::string> urls() const;  ///< with their content ("data:")

  private:
    struct Picture {
        std::filesystem::path file;
        PictureFile content;
        Image smaller = {};  ///< image in `content`, if it has been halved
    };
    static void halve(Picture& picture);

    std::vector<Picture> pictures;
};

}  // namespace sherd
