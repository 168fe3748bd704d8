// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "app/files/picture/image.h"

struct FT_LibraryRec_;
struct FT_FaceRec_;

namespace sherd {

/// Writes text into images, in DejaVu Sans by FreeType: equal texts give equal pixels. Members throw Error
/// (run) if FreeType fails.
class Text {
  public:
    /// size: the font's em, that is, the height of a line of text, pixels.
    explicit Text(double size);

    double size() const { return em; }
    double width(const std::string& words) const;  ///< pixels
    /// Writes `words` (UTF-8) into an image. column, row: pixels, beginning of the text on its base line.
    void write(Image& image, double column, double row, const std::string& words,
               const Eigen::Vector3f& colour) const;

  private:
    double em;
    std::unique_ptr<FT_LibraryRec_, int (*)(FT_LibraryRec_*)> library;
    std::unique_ptr<FT_FaceRec_, int (*)(FT_FaceRec_*)> face;
};

}  // namespace sherd
