// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/table/study_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "app/chart/chart.h"
#include "app/messages/number_list.h"
#include "app/sweep/table/bootstrap.h"
#include "meshops/error.h"

namespace sherd {
namespace {

ChartAxis axis_of(const StudyColumn& column, bool logarithmic) {
    return {.name = column.name, .unit = column.unit, .logarithmic = logarithmic};
}

/// Adds a series of dots, one for each row (x, y), and a series of means if several rows have the same x.
void add_series(Chart& chart, const std::string& name, const char* colour,
                const std::vector<Vector2d>& rows) {
    std::map<double, std::vector<double>> by_x;
    for (const Vector2d& row : rows) by_x[row.x()].push_back(row.y());
    ChartSeries dots{.name = name, .colour = colour, .points = rows, .dotted = true, .joined = false};
    if (by_x.size() == rows.size()) {
        chart.series.push_back(std::move(dots));
        return;
    }
    dots.faint = true;
    dots.name.clear();
    ChartSeries means{.name = name, .colour = colour, .points = {}, .dotted = true};
    for (const auto& [x, values] : by_x) {
        const MeanEstimate estimate = estimated_mean(values);
        means.points.emplace_back(x, estimate.mean);
        means.intervals.emplace_back(estimate.low, estimate.high);
    }
    chart.series.push_back(std::move(dots));
    chart.series.push_back(std::move(means));
}

/// Returns the different values of a column, sorted as numbers if they are numbers.
std::vector<std::string> sorted_values(const StudyColumn& column) {
    const std::set<std::string> different(column.cells.begin(), column.cells.end());
    std::vector<std::string> values(different.begin(), different.end());
    std::ranges::stable_sort(values, {},
                             [](const std::string& value) { return number_of(value).value_or(0); });
    return values;
}

}  // namespace

Chart study_chart(const StudyTable& table, const StudyAxes& axes) {
    const StudyColumn &x = find_column(table, axes.x), &y = find_column(table, axes.y);
    const StudyColumn* by = axes.by.empty() ? nullptr : &find_column(table, axes.by);
    const std::vector<double> xs = x.numbers(), ys = y.numbers();
    Chart chart{
        fmt::format("{} over {}", y.name, x.name), axis_of(x, axes.log_x), axis_of(y, axes.log_y), {}};
    const std::vector<std::string> values = by ? sorted_values(*by) : std::vector<std::string>{""};
    for (std::size_t v = 0; v < values.size(); ++v) {
        std::vector<Vector2d> rows;
        for (std::size_t i = 0; i < xs.size(); ++i)
            if (std::isfinite(xs[i]) && std::isfinite(ys[i]) && (!by || by->cells[i] == values[v]))
                rows.emplace_back(xs[i], ys[i]);
        if (!rows.empty())
            add_series(chart, by ? fmt::format("{} = {}", by->name, values[v]) : "",
                       series_colours[v % series_colours.size()], rows);
    }
    if (chart.series.empty())
        throw Error(fmt::format("no row has a number for both '{}' and '{}'", x.name, y.name));
    chart.has_legend = by != nullptr;
    return chart;
}

std::string summary_svg(const Study& study, const StudyTable& table) {
    const auto parameter = std::ranges::find_if(table, [](const StudyColumn& column) {
        std::set<double> numbers;
        for (const double number : column.numbers())
            if (std::isfinite(number)) numbers.insert(number);
        return column.group == "parameters" && numbers.size() > 1;
    });
    std::vector<Chart> charts;
    for (const StudyColumn& column : table) {
        const bool measured = column.group == "measures" || column.group == "python";
        if (!measured || parameter == table.end()) continue;
        const std::vector<double> numbers = column.numbers();
        if (std::ranges::none_of(numbers, [](double number) { return std::isfinite(number); })) continue;
        charts.push_back(study_chart(table, {.x = parameter->name, .y = column.name}));
    }
    if (charts.empty()) return "";
    return page_svg(
        {study.file.filename().string() + ": rows, and means with 95 % intervals", std::move(charts)});
}

}  // namespace sherd
