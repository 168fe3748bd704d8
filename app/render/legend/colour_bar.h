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
    std::string title;           ///< name of the scalar, with the unit
    std::vector<BarTick> ticks;  ///< upwards: the low end, round numbers, the high end
    bool below = false;          ///< whether there are values below the low end, drawn in its colour
    bool above = false;          ///< whether there are values above the high end
};

/// Returns the bar for the scalar `name`. range: values of the darkest and the brightest colour; extent:
/// smallest and largest value of the scalar; both are in the SI unit `unit`, which is empty for plain
/// numbers.
ColourBar make_colour_bar(const std::string& name, const std::string& unit,
                          const std::pair<double, double>& range, const std::pair<double, double>& extent);

/// Returns the caption of a moment of a run that ends at `end` (s), such as `t = 12.50 ms, step 125`, with
/// the same number of decimals at all moments of the run. unit: RecordingHeader::time_unit.
std::string time_caption(double time, std::int64_t step, double end, const std::string& unit = "s");

/// Rectangle of pixels.
struct PixelBox {
    int left = 0, top = 0, right = 0, bottom = 0;  ///< right and bottom are the first column and row outside
};

/// Whether a picture of that many pixels is large enough for a bar and a caption.
bool fits_colour_bar(int width, int height);

/// Draws the bar into the top right corner of a picture, on a panel that keeps the bar legible on any
/// background. The size of the bar follows the size of the picture, which must be large enough
/// (fits_colour_bar()). Returns the rectangle of the panel.
PixelBox draw_colour_bar(Image& image, const ColourBar& bar);

/// Writes a line of text into the bottom left corner of a picture, on a panel as for the colour bar. Returns
/// the rectangle of the panel.
PixelBox draw_caption(Image& image, const std::string& words);

}  // namespace sherd
