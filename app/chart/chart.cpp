// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/chart/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>

#include "app/files/xml_text.h"
#include "app/render/legend/axis_ticks.h"

namespace sherd {
namespace {

constexpr double left_margin = 62, right_margin = 16, top_margin = 50, bottom_margin = 42;  // pixels

/// Scale of an axis, which shows values from `low` to `high` at places from `begin` to `end`.
struct Scale {
    UnitPrefix prefix;  ///< prefix of the unit in the labels
    double low, high;   ///< in the unit of the labels
    bool logarithmic;
    double begin, end;          ///< pixels
    std::vector<double> ticks;  ///< in the unit of the labels

    double place(double value) const {
        const double v = value * prefix.factor;
        const double share = logarithmic
                                 ? (std::log10(v) - std::log10(low)) / (std::log10(high) - std::log10(low))
                                 : (v - low) / (high - low);
        return begin + share * (end - begin);
    }
};

std::pair<double, double> extent(const Chart& chart, int coordinate, bool logarithmic) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const ChartSeries& series : chart.series)
        for (const Vector2d& point : series.points) {
            if (!point.allFinite() || (logarithmic && point[coordinate] <= 0)) continue;
            low = std::min(low, point[coordinate]);
            high = std::max(high, point[coordinate]);
        }
    for (const ChartSeries& series : chart.series)
        for (const Vector2d& interval : series.intervals) {
            if (coordinate == 0 || !interval.allFinite() || (logarithmic && interval[0] <= 0)) continue;
            low = std::min(low, interval[0]);
            high = std::max(high, interval[1]);
        }
    if (low > high) return logarithmic ? std::pair{1.0, 10.0} : std::pair{0.0, 1.0};
    return {low, high};
}

/// Smallest of 1, 2, 5, 10, ... that is not below `value`.
double rounded_up(double value) {
    const double power = std::pow(10, std::floor(std::log10(value) + 1e-9));
    for (const double digit : {1.0, 2.0, 5.0})
        if (digit * power >= value * (1 - 1e-9)) return digit * power;
    return 10 * power;
}

Scale make_scale(const Chart& chart, int coordinate, double begin, double end) {
    const ChartAxis& axis = coordinate == 0 ? chart.x : chart.y;
    auto [low, high] = extent(chart, coordinate, axis.logarithmic);
    if (axis.from_zero) low = std::min(low, 0.0);
    Scale scale{
        prefixed(axis.unit, std::max(std::abs(low), std::abs(high))), 0, 0, axis.logarithmic, begin, end, {}};
    low *= scale.prefix.factor;
    high *= scale.prefix.factor;
    if (axis.logarithmic) {
        scale.low = std::pow(10, std::floor(std::log10(low) + 1e-9));
        scale.high = std::max(rounded_up(high), 10 * scale.low);
        scale.ticks = logarithmic_ticks(scale.low, scale.high);
        return scale;
    }
    if (high - low <= 1e-12 * std::max(std::abs(high), 1e-30)) high = low + std::max(1.0, std::abs(low));
    scale.ticks = round_ticks(low, high, 6, axis.whole);
    const double spacing = scale.ticks[1] - scale.ticks[0];
    // The vertical axis ends at round numbers, the horizontal axis at the outermost points.
    scale.low = coordinate == 0 ? low : std::floor(low / spacing + 1e-9) * spacing;
    scale.high = coordinate == 0 ? high : std::ceil(high / spacing - 1e-9) * spacing;
    if (coordinate == 1) scale.ticks = round_ticks(scale.low, scale.high, 6, axis.whole);
    return scale;
}

std::string text(double x, double y, const std::string& words, const std::string& attributes) {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", x, y, attributes,
                       xml_escaped(words));
}

std::string line(double x0, double y0, double x1, double y1, const std::string& attributes) {
    return fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" {}/>\n", x0, y0, x1, y1, attributes);
}

std::string axis_words(const ChartAxis& axis, const Scale& scale) {
    return scale.prefix.unit.empty() ? axis.name : fmt::format("{} ({})", axis.name, scale.prefix.unit);
}

std::string frame_svg(const Chart& chart, const Scale& x, const Scale& y) {
    const std::string grid = "stroke=\"#e4e4e4\" stroke-width=\"1\"",
                      small = "font-size=\"11\" fill=\"#444\"";
    std::string svg;
    for (const double tick : y.ticks) {
        const double at = y.place(tick / y.prefix.factor);
        svg += line(x.begin, at, x.end, at, grid);
        svg += text(x.begin - 7, at + 4, tick_text(tick), small + " text-anchor=\"end\"");
    }
    for (const double tick : x.ticks) {
        const double at = x.place(tick / x.prefix.factor);
        svg += line(at, y.begin, at, y.begin + 4, "stroke=\"#888\"");
        svg += text(at, y.begin + 17, tick_text(tick), small + " text-anchor=\"middle\"");
    }
    svg += line(x.begin, y.begin, x.end, y.begin, "stroke=\"#888\"");
    svg += text((x.begin + x.end) / 2, y.begin + 34, axis_words(chart.x, x),
                "font-size=\"12\" fill=\"#222\" text-anchor=\"middle\"");
    svg += fmt::format(
        "<text transform=\"translate({:.1f} {:.1f}) rotate(-90)\" font-size=\"12\" fill=\"#222\" "
        "text-anchor=\"middle\">{}</text>\n",
        x.begin - 48, (y.begin + y.end) / 2, xml_escaped(axis_words(chart.y, y)));
    return svg;
}

/// Whether the axes can show a point.
bool is_shown(const Vector2d& point, const Scale& x, const Scale& y) {
    return point.allFinite() && (!x.logarithmic || point.x() > 0) && (!y.logarithmic || point.y() > 0);
}

std::string series_path(const ChartSeries& series, const Scale& x, const Scale& y) {
    std::string path;
    bool joined = false;
    double last_y = 0;
    for (const Vector2d& point : thinned(series.points, static_cast<int>(x.end - x.begin))) {
        const bool shown = is_shown(point, x, y);
        if (shown) {
            const double px = x.place(point.x()), py = y.place(point.y());
            if (joined && series.stepped) path += fmt::format("L{:.1f} {:.1f}", px, last_y);
            path += fmt::format("{}{:.1f} {:.1f}", joined ? 'L' : 'M', px, py);
            last_y = py;
        }
        joined = shown;
    }
    return path;
}

/// Bars of the intervals, with a stroke across each end.
std::string intervals_svg(const ChartSeries& series, const Scale& x, const Scale& y) {
    constexpr double half = 4;  // pixels
    std::string path;
    for (std::size_t i = 0; i < series.intervals.size(); ++i) {
        const double at = series.points[i].x();
        const auto [low, high] = std::pair(series.intervals[i][0], series.intervals[i][1]);
        if (!is_shown({at, low}, x, y) || !is_shown({at, high}, x, y)) continue;
        const double px = x.place(at), lower = y.place(low), upper = y.place(high);
        path += fmt::format("M{0:.1f} {3:.1f}H{2:.1f}M{1:.1f} {3:.1f}V{4:.1f}M{0:.1f} {4:.1f}H{2:.1f}",
                            px - half, px, px + half, lower, upper);
    }
    if (path.empty()) return "";
    return fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.2\"/>\n", path,
                       series.colour);
}

std::string series_svg(const ChartSeries& series, const Scale& x, const Scale& y) {
    std::string svg = intervals_svg(series, x, y);
    if (series.joined)
        svg += fmt::format(
            "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.8\" stroke-linejoin=\"round\"{}/>\n",
            series_path(series, x, y), series.colour, series.dashed ? " stroke-dasharray=\"5 3\"" : "");
    if (!series.dotted) return svg;
    std::set<std::string> dots;  // each dot once
    for (const Vector2d& point : series.points)
        if (is_shown(point, x, y))
            dots.insert(fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.6\" fill=\"{}\"{}/>\n",
                                    x.place(point.x()), y.place(point.y()), series.colour,
                                    series.faint ? " fill-opacity=\"0.3\"" : ""));
    for (const std::string& dot : dots) svg += dot;
    return svg;
}

}  // namespace

std::string legend_svg(std::span<const ChartSeries> all, double left, double y) {
    std::string svg;
    for (const ChartSeries& series : all) {
        if (series.name.empty()) continue;
        svg += line(left, y - 4, left + 18, y - 4,
                    fmt::format("stroke=\"{}\" stroke-width=\"2.5\"{}", series.colour,
                                series.dashed ? " stroke-dasharray=\"5 3\"" : ""));
        svg += text(left + 23, y, series.name, "font-size=\"11\" fill=\"#222\"");
        left += legend_width(series.name);
    }
    return svg;
}

double legend_width(const std::string& name) {
    return 36 + 6.4 * static_cast<double>(name.size());
}

std::vector<Vector2d> thinned(const std::vector<Vector2d>& points, int columns) {
    const auto most = static_cast<std::size_t>(4 * std::max(1, columns));
    if (points.size() <= most) return points;
    std::vector<Vector2d> kept;
    const std::size_t buckets = most / 4;
    for (std::size_t b = 0; b < buckets; ++b) {
        const auto begin = points.begin() + static_cast<std::ptrdiff_t>(b * points.size() / buckets);
        const auto end = points.begin() + static_cast<std::ptrdiff_t>((b + 1) * points.size() / buckets);
        const auto lower = [](const Vector2d& a, const Vector2d& c) { return a.y() < c.y(); };
        std::vector chosen{begin, std::min_element(begin, end, lower), std::max_element(begin, end, lower),
                           end - 1};
        std::ranges::sort(chosen);
        chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
        for (const auto& point : chosen) kept.push_back(*point);
    }
    return kept;
}

std::string chart_svg(const Chart& chart, double left, double top, double width, double height) {
    const Scale x = make_scale(chart, 0, left + left_margin, left + width - right_margin);
    const Scale y = make_scale(chart, 1, top + height - bottom_margin, top + top_margin);
    std::string svg = "<g>\n" + frame_svg(chart, x, y);
    for (const ChartSeries& series : chart.series) svg += series_svg(series, x, y);
    svg += text(x.begin, top + 20, chart.title, "font-size=\"14\" font-weight=\"bold\" fill=\"#111\"");
    // A single line has no legend: the title suffices.
    if (chart.has_legend && chart.series.size() > 1) svg += legend_svg(chart.series, x.begin, top + 39);
    return svg + "</g>\n";
}

}  // namespace sherd
