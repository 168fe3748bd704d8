// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "core/vector.h"

namespace sherd {

// Okabe and Ito's palette.
inline constexpr const char *blue = "#0072b2", *vermillion = "#d55e00", *green = "#009e73",
                            *purple = "#cc79a7", *yellow = "#f0e442", *orange = "#e69f00", *black = "#000000",
                            *sky = "#56b4e9";

/// Colours of several lines, in this order.
inline constexpr std::array series_colours{blue, vermillion, green, purple, orange, black};

/// A line of a chart.
struct ChartSeries {
    std::string name;
    std::string colour;            ///< as in SVG
    std::vector<Vector2d> points;  ///< in order, in the axes' units; a point that is not finite is a gap
    bool stepped = false;          ///< whether the line keeps its value until the next point
    bool dashed = false;
    bool dotted = false;                   ///< whether there is a dot at each point
    bool joined = true;                    ///< whether a line joins the points
    bool faint = false;                    ///< whether dots are pale, behind more important ones
    std::vector<Vector2d> intervals = {};  ///< lower and upper end of a bar at each point; empty: no bars
};

/// An axis. Its labels add a prefix to the SI unit `unit`, such that their numbers are short.
struct ChartAxis {
    std::string name;
    std::string unit = {};  ///< empty: values without a unit
    bool logarithmic = false;
    bool whole = false;      ///< whether labels are whole numbers only
    bool from_zero = false;  ///< whether the axis begins at zero, unless there are negative values
};

struct Chart {
    std::string title;
    ChartAxis x, y;
    std::vector<ChartSeries> series;
    bool has_legend = true;  ///< whether the names of the lines are above the chart if there are several
};

/// Width that a line of this name takes in a legend, pixels.
double legend_width(const std::string& name);

/// SVG of a legend: samples and names of the lines in a row, which starts at (left, y), in pixels.
std::string legend_svg(std::span<const ChartSeries> series, double left, double y);

/// Returns the points that a line needs if it is drawn over a width of `columns` pixels: about the first, the
/// last, the lowest and the highest point in each column.
std::vector<Vector2d> thinned(const std::vector<Vector2d>& points, int columns);

/// An SVG group that shows the chart with its top left corner at (left, top), in pixels.
std::string chart_svg(const Chart& chart, double left, double top, double width, double height);

}  // namespace sherd
