// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/chart/chart_page.h"

#include <fmt/format.h>

#include "app/files/xml_text.h"

namespace sherd {
namespace {

constexpr double heading_height = 44, legend_left = 62, legend_height = 18;  // pixels

/// Returns SVG of a legend in as many rows as it needs in this width, and its height; lengths are in pixels.
std::pair<std::string, double> legend_lines(std::span<const ChartSeries> series, double width, double top) {
    std::string svg;
    double y = top;
    while (!series.empty()) {
        std::size_t count = 1;
        double used = legend_left + legend_width(series[0].name);
        while (count < series.size() && used + legend_width(series[count].name) <= width)
            used += legend_width(series[count++].name);
        svg += legend_svg(series.first(count), legend_left, y + 10);
        series = series.subspan(count);
        y += legend_height;
    }
    return {svg, y - top};
}

}  // namespace

std::string page_svg(ChartPage page) {
    const double width = static_cast<double>(page.columns) * page.panel_width;
    double top = heading_height;
    std::string legend;
    if (page.shares_legend) {
        for (Chart& chart : page.charts) chart.has_legend = false;
        const auto [lines, height] = legend_lines(page.charts.front().series, width, top);
        legend = lines;
        top += height;
    }
    const std::size_t rows = (page.charts.size() + page.columns - 1) / page.columns;
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
        "font-family=\"Helvetica, Arial, sans-serif\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"white\"/>\n"
        "<text x=\"62\" y=\"30\" font-size=\"15\" fill=\"#444\">{2}</text>\n",
        width, top + static_cast<double>(rows) * page.panel_height, xml_escaped(page.heading));
    svg += legend;
    for (std::size_t i = 0; i < page.charts.size(); ++i) {
        const std::size_t row = i / page.columns, column = i % page.columns;
        svg += chart_svg(page.charts[i], static_cast<double>(column) * page.panel_width,
                         top + static_cast<double>(row) * page.panel_height, page.panel_width,
                         page.panel_height);
    }
    return svg + "</svg>\n";
}

}  // namespace sherd
