// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/files/image.h"

namespace sherd {

/// What stands beside a place of a colour bar.
struct BarTick {
    double share;  ///< 0: where the darkest colour is, 1: the brightest
    std::string words;
};

/// What the colours of numbers mean, as it is drawn beside them.
struct ColourBar {
    std::string title;           ///< with the unit
    std::vector<BarTick> ticks;  ///< upwards: the low end, round numbers, the high end
    bool below = false;          ///< there are values below the low end, drawn in its colour
    bool above = false;          ///< and above the high end
};

/// range: what the darkest and the brightest colour mean, extent: the smallest and the largest value there
/// is, both in the SI unit, which is empty of plain numbers.
ColourBar make_colour_bar(const std::string& name, const std::string& unit,
                          const std::pair<double, double>& range, const std::pair<double, double>& extent);

/// A moment of a run that ends at `end` (s), such as `t = 12.50 ms, step 125`: as many digits in all of them.
/// unit: of the times, RecordingHeader::time_unit.
std::string moment_caption(double time, std::int64_t step, double end, const std::string& unit = "s");

/// Rectangle of pixels.
struct PixelBox {
    int left = 0, top = 0, right = 0, bottom = 0;  ///< right and bottom: the first ones outside
};

/// Whether a picture of that many pixels has room for a bar and a caption.
bool has_room_for_bar(int width, int height);

/// Draws the bar into the top right corner, on a panel that makes it legible before anything; its size
/// follows the picture's, which has room. Returns the panel.
PixelBox draw_colour_bar(Image& image, const ColourBar& bar);

/// Writes a line into the bottom left corner, in the same way.
PixelBox draw_caption(Image& image, const std::string& words);

}  // namespace sherd
