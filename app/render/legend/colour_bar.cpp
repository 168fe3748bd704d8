// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/legend/colour_bar.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "app/messages/time_text.h"
#include "app/render/legend/axis_ticks.h"
#include "app/render/legend/render_colour.h"
#include "app/render/legend/text.h"

namespace sherd {
namespace {

using Eigen::Vector3f;

// Height of letters and length of a bar, as shares of the picture's smaller side, unless letters would be too
// small to read.
constexpr double letter_share = 0.026, bar_share = 0.4;
constexpr double smallest_letter = 11;  // pixels
constexpr int smallest_side = 220;      // pixels, smaller side of the smallest picture with a bar
// Smallest distance of a tick from the ends of the bar, as a share of the bar's length. The texts of closer
// ticks would touch the texts at the ends.
constexpr double end_gap = 0.11;
const Vector3f ink(0.08f, 0.08f, 0.09f), paper(1, 1, 1);

/// Returns a value, rounded to so many significant digits.
double rounded(double value, int digits) {
    if (value == 0 || !std::isfinite(value)) return value;
    const double power = std::pow(10, digits - 1 - std::floor(std::log10(std::abs(value))));
    return std::round(value * power) / power;
}

/// Returns the share of a pixel, which extends from i to i + 1, that lies between low and high.
float covered(int i, double low, double high) {
    return static_cast<float>(std::max(0.0, std::min<double>(i + 1, high) - std::max<double>(i, low)));
}

/// Mixes a colour into a rectangle, whose sides may lie inside pixels.
void fill(Image& image, double left, double top, double right, double bottom, const Vector3f& colour,
          float opacity = 1) {
    const int first_row = std::max(0, static_cast<int>(std::floor(top))),
              first_column = std::max(0, static_cast<int>(std::floor(left)));
    for (int row = first_row; row < std::min<double>(image.height, bottom); ++row)
        for (int column = first_column; column < std::min<double>(image.width, right); ++column) {
            auto pixel = image.colours.col(static_cast<Eigen::Index>(row) * image.width + column);
            const float share = opacity * covered(row, top, bottom) * covered(column, left, right);
            pixel += share * (colour - pixel);
        }
}

Vector3f bar_colour(double share) {
    const std::uint32_t rgb = map_colour(share);
    return Vector3f(static_cast<float>(rgb >> 16 & 255), static_cast<float>(rgb >> 8 & 255),
                    static_cast<float>(rgb & 255)) /
           255;
}

Text text_for(const Image& image) {
    return Text(std::max(smallest_letter, std::round(letter_share * std::min(image.width, image.height))));
}

PixelBox panel(Image& image, double left, double top, double right, double bottom) {
    const PixelBox box{static_cast<int>(std::floor(left)), static_cast<int>(std::floor(top)),
                       static_cast<int>(std::ceil(right)), static_cast<int>(std::ceil(bottom))};
    fill(image, box.left, box.top, box.right, box.bottom, paper, 0.78f);
    return box;
}

/// Draws a tip, which shows that there are values beyond an end of the bar. The tip is as wide as the bar at
/// the row `base`, and a point at the row `tip`.
void draw_tip(Image& image, double left, double right, double base, double tip, const Vector3f& colour) {
    for (double row = std::min(base, tip); row < std::max(base, tip); ++row) {
        const double inset = (right - left) / 2 * (row + 0.5 - base) / (tip - base);
        fill(image, left + inset, row, right - inset, row + 1, colour);
    }
}

/// Places of the parts of a bar, in pixels.
struct BarPlace {
    double left, right, top, bottom;  ///< rectangle of the bar's colours
    double tip, stroke;               ///< height of the bar's tips; width of lines
};

void draw_colours(Image& image, const ColourBar& bar, const BarPlace& at) {
    fill(image, at.left - at.stroke, at.top - at.stroke, at.right + at.stroke, at.bottom + at.stroke, ink);
    for (double row = at.top; row < at.bottom; ++row)
        fill(image, at.left, row, at.right, row + 1,
             bar_colour((at.bottom - row - 0.5) / (at.bottom - at.top)));
    const auto draw_outlined_tip = [&](double base, double direction, const Vector3f& colour) {
        draw_tip(image, at.left - at.stroke, at.right + at.stroke, base,
                 base + direction * (at.tip + 2 * at.stroke), ink);
        draw_tip(image, at.left, at.right, base, base + direction * at.tip, colour);
    };
    if (bar.above) draw_outlined_tip(at.top - at.stroke, -1, bar_colour(1));
    if (bar.below) draw_outlined_tip(at.bottom + at.stroke, 1, bar_colour(0));
}

void draw_ticks(Image& image, const ColourBar& bar, const BarPlace& at, const Text& text) {
    const double em = text.size();
    for (const BarTick& tick : bar.ticks) {
        const double row = std::round(at.bottom - tick.share * (at.bottom - at.top) - at.stroke / 2);
        fill(image, at.right, row, at.right + 0.4 * em, row + at.stroke, ink);
        text.write(image, at.right + 0.7 * em, row + at.stroke / 2 + 0.36 * em, tick.words, ink);
    }
}

}  // namespace

ColourBar make_colour_bar(const std::string& name, const std::string& unit,
                          const std::pair<double, double>& range, const std::pair<double, double>& extent) {
    const auto [low, high] = range;
    const UnitPrefix prefix = prefixed(unit, std::max(std::abs(low), std::abs(high)));
    ColourBar bar{.title = prefix.unit.empty() ? name : fmt::format("{} ({})", name, prefix.unit),
                  .ticks = {},
                  .below = extent.first<low, .above = extent.second> high};
    const auto end_words = [&](double value, const char* beyond) {
        return beyond + tick_text(rounded(value * prefix.factor, 4));
    };
    bar.ticks.push_back({0, end_words(low, bar.below ? "\xe2\x89\xa4 " : "")});
    for (const double tick : round_ticks(low * prefix.factor, high * prefix.factor, 5, false)) {
        const double share = (tick / prefix.factor - low) / (high - low);
        if (share > end_gap && share < 1 - end_gap) bar.ticks.push_back({share, tick_text(tick)});
    }
    bar.ticks.push_back({1, end_words(high, bar.above ? "\xe2\x89\xa5 " : "")});
    return bar;
}

std::string time_caption(double time, std::int64_t step, double end, const std::string& unit) {
    if (unit != "s") return fmt::format("{}, step {}", time_text(fmt::format("{:.3f}", time), unit), step);
    const UnitPrefix prefix = prefixed("s", end);
    const double shown = end * prefix.factor;
    const int decimals = shown >= 100 ? 1 : shown >= 10 ? 2 : 3;
    return fmt::format("t = {:.{}f} {}, step {}", time * prefix.factor, decimals, prefix.unit, step);
}

bool fits_colour_bar(int width, int height) {
    return std::min(width, height) >= smallest_side;
}

PixelBox draw_colour_bar(Image& image, const ColourBar& bar) {
    const Text text = text_for(image);
    const double em = text.size(), pad = std::round(0.7 * em), margin = std::round(em);
    const double length = std::round(std::max(bar_share * std::min(image.width, image.height), 9.5 * em));
    double words = 0;
    for (const BarTick& tick : bar.ticks) words = std::max(words, text.width(tick.words));
    const double inner = std::ceil(std::max(text.width(bar.title), 1.7 * em + words));
    BarPlace at{};
    at.tip = std::round(0.7 * em);
    at.stroke = std::max(1.0, std::round(em / 14));
    at.left = image.width - margin - pad - inner;
    at.right = at.left + std::round(em);
    at.top = margin + pad + std::round(1.6 * em) + at.tip;
    at.bottom = at.top + length;
    const PixelBox box = panel(image, at.left - pad, margin, at.left + inner + pad, at.bottom + at.tip + pad);
    text.write(image, at.left, margin + pad + 0.8 * em, bar.title, ink);
    draw_colours(image, bar, at);
    draw_ticks(image, bar, at, text);
    return box;
}

PixelBox draw_caption(Image& image, const std::string& words) {
    const Text text = text_for(image);
    const double em = text.size(), pad = std::round(0.5 * em), left = std::round(em);
    const double bottom = image.height - std::round(em), top = bottom - std::round(em) - 2 * pad;
    const PixelBox box = panel(image, left, top, left + text.width(words) + 2 * pad, bottom);
    text.write(image, left + pad, bottom - pad - 0.16 * em, words, ink);
    return box;
}

}  // namespace sherd
