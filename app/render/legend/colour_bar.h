// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/files/picture/image.h"

namespace sherd {

/// A tick of a colour bar.
struct BarTick {
    double share;  ///< 0: at the darkest colour, 1: at the brightest
    std::string words;
};

/// A colour bar, which explains the colours of a scalar.
struct ColourBar {
    std::string title;           ///< with the unit
    std::vector<BarTick> ticks;  ///< upwards: the low end, round numbers, the high end
    bool below = false;          ///< whether there are values below the low end, drawn in its colour
    bool above = false;          ///< whether there are values above the high end
};

/// range: values of the darkest and the brightest colour; extent: the smallest and the largest value; both in
/// the SI unit, which is empty for plain numbers.
ColourBar make_colour_bar(const std::string& name, const std::string& unit,
                          const std::pair<double, double>& range, const std::pair<double, double>& extent);

/// Caption of a moment of a run that ends at `end` (s), such as `t = 12.50 ms, step 125`, with the same
/// number of decimals at all moments. unit: of the times, RecordingHeader::time_unit.
std::string time_caption(double time, std::int64_t step, double end, const std::string& unit = "s");

/// Rectangle of pixels.
struct PixelBox {
    int left = 0, top = 0, right = 0, bottom = 0;  ///< right and bottom: the first ones outside
};

/// Whether a picture of that many pixels is large enough for a bar and a caption.
bool fits_colour_bar(int width, int height);

/// Draws the bar into the top right corner, on a panel that keeps it legible on any background. Its size
/// follows the picture's, which must be large enough. Returns the panel.
PixelBox draw_colour_bar(Image& image, const ColourBar& bar);

/// Writes a line into the bottom left corner, on such a panel. Returns the panel.
PixelBox draw_caption(Image& image, const std::string& words);

}  // namespace sherd
