// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/files/picture_file.h"

namespace sherd {

/// Pictures that are part of a page, each once.
class PagePictures {
  public:
    /// The number of a picture. Throws Error naming the file if it cannot be read.
    std::int32_t add(const std::filesystem::path& file);

    /// Halves the largest, as often as it takes, until all of them take at most so many bytes of the page;
    /// `warnings` gets a sentence for each that is smaller then.
    void fit(std::size_t most_bytes, std::vector<std::string>& warnings);

    std::size_t bytes() const;              ///< of the page
    std::vector<std::string> urls() const;  ///< with all that is in them ("data:")

  private:
    struct Picture {
        std::filesystem::path file;
        PictureFile content;
        Image smaller = {};  ///< what is in `content`, if it is not the file
    };
    static void halve(Picture& picture);

    std::vector<Picture> pictures;
};

}  // namespace sherd
