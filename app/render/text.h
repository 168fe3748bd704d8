// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "app/files/image.h"

struct FT_LibraryRec_;
struct FT_FaceRec_;

namespace sherd {

/// Writes words into images, in DejaVu Sans by FreeType: the same pixels for the same words. Both throw
/// Error (run) when FreeType fails.
class Text {
  public:
    /// size: pixels that a line of text takes (the font's em).
    explicit Text(double size);

    double size() const { return em; }
    double width(const std::string& words) const;  ///< pixels
    /// column, row: pixels, where the words begin on their base line. words: UTF-8.
    void write(Image& image, double column, double row, const std::string& words,
               const Eigen::Vector3f& colour) const;

  private:
    double em;
    std::unique_ptr<FT_LibraryRec_, int (*)(FT_LibraryRec_*)> library;
    std::unique_ptr<FT_FaceRec_, int (*)(FT_FaceRec_*)> face;
};

}  // namespace sherd
