// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/legend/text.h"

#include <fmt/format.h>
#include <ft2build.h>
#include FT_FREETYPE_H

#include <boost/locale/encoding_utf.hpp>
#include <cmath>
#include <functional>

#include "app/render/legend/font_asset.h"
#include "meshops/error.h"

namespace sherd {
namespace {

void check(FT_Error error) {
    if (error)
        throw Error(fmt::format("text cannot be written into the picture: FreeType error {}", error),
                    Fault::run);
}

FT_Library new_library() {
    FT_Library library = nullptr;
    check(FT_Init_FreeType(&library));
    return library;
}

FT_Face new_face(FT_Library library) {
    FT_Face face = nullptr;
    check(FT_New_Memory_Face(library, reinterpret_cast<const FT_Byte*>(font_asset.data()),
                             static_cast<FT_Long>(font_asset.size()), 0, &face));
    return face;
}

/// Sets `words` in a line that begins at `column`. Calls place(glyph, column at which the glyph begins) for
/// each letter, and returns the column at which the last letter ends.
double set(FT_Face face, double column, const std::string& words,
           const std::function<void(FT_UInt glyph, double column)>& place) {
    FT_UInt before = 0;
    for (const char32_t letter : boost::locale::conv::utf_to_utf<char32_t>(words)) {
        const FT_UInt glyph = FT_Get_Char_Index(face, letter);
        FT_Vector kerning{0, 0};
        check(FT_Get_Kerning(face, before, glyph, FT_KERNING_UNFITTED, &kerning));
        column += static_cast<double>(kerning.x) / 64;
        place(glyph, column);
        check(FT_Load_Glyph(face, glyph, FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP));
        column += static_cast<double>(face->glyph->linearHoriAdvance) / 65536;
        before = glyph;
    }
    return column;
}

/// Mixes `colour` into the pixels of the image that the letter in `bitmap` covers.
void blend(Image& image, const FT_Bitmap& bitmap, int left, int top, const Eigen::Vector3f& colour) {
    for (int y = 0; y < static_cast<int>(bitmap.rows); ++y)
        for (int x = 0; x < static_cast<int>(bitmap.width); ++x) {
            const int column = left + x, row = top + y;
            if (column < 0 || row < 0 || column >= image.width || row >= image.height) continue;
            const float share = static_cast<float>(bitmap.buffer[y * bitmap.pitch + x]) / 255;
            auto pixel = image.colours.col(static_cast<Eigen::Index>(row) * image.width + column);
            pixel += share * (colour - pixel);
        }
}

}  // namespace

Text::Text(double size)
    : em(size), library(new_library(), FT_Done_FreeType), face(new_face(library.get()), FT_Done_Face) {
    check(FT_Set_Char_Size(face.get(), 0, std::lround(64 * size), 72, 72));
}

double Text::width(const std::string& words) const {
    return set(face.get(), 0, words, [](FT_UInt, double) {});
}

void Text::write(Image& image, double column, double row, const std::string& words,
                 const Eigen::Vector3f& colour) const {
    const double base = std::round(row);
    set(face.get(), column, words, [&](FT_UInt glyph, double at) {
        // Letters may begin between two columns of pixels; only their heights are fitted to rows of pixels.
        FT_Vector shift{std::lround(64 * (at - std::floor(at))), 0};
        FT_Set_Transform(face.get(), nullptr, &shift);
        check(FT_Load_Glyph(face.get(), glyph, FT_LOAD_RENDER | FT_LOAD_TARGET_LIGHT));
        FT_Set_Transform(face.get(), nullptr, nullptr);
        const FT_GlyphSlot slot = face->glyph;
        blend(image, slot->bitmap, static_cast<int>(std::floor(at)) + slot->bitmap_left,
              static_cast<int>(base) - slot->bitmap_top, colour);
    });
}

}  // namespace sherd
