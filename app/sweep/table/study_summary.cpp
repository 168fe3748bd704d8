// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/table/study_summary.h"

#include <fmt/format.h>

#include <cmath>

#include "app/sweep/table/bootstrap.h"

namespace sherd {
namespace {

std::string estimate_cell(double value) {
    return std::isfinite(value) ? fmt::format("{:.6g}", value) : "";
}

/// Returns, for each point, the index of its first row and the one after its last row: rows of a point are
/// consecutive.
std::vector<std::pair<std::size_t, std::size_t>> point_ranges(const StudyRows& rows) {
    std::vector<std::pair<std::size_t, std::size_t>> ranges;
    for (std::size_t i = 0; i < rows.rows.size(); ++i) {
        if (i == 0 || rows.rows[i].point != rows.rows[i - 1].point) ranges.emplace_back(i, i);
        ranges.back().second = i + 1;
    }
    return ranges;
}

}  // namespace

CsvRows study_summary(const StudyRows& rows, const StudyTable& table) {
    CsvRows summary(1);
    const std::vector<double> exits = find_column(table, "exit").numbers();
    std::vector<std::pair<const StudyColumn*, std::vector<double>>> measures;
    for (const StudyColumn& column : table) {
        if (column.group == "parameters") summary[0].push_back(column.name);
        if (column.group == "measures" || column.group == "python")
            measures.emplace_back(&column, column.numbers());
    }
    summary[0].insert(summary[0].end(), {"done", "failed"});
    for (const auto& [column, numbers] : measures)
        summary[0].insert(summary[0].end(), {column->name, column->name + ".low", column->name + ".high"});
    for (const auto& [begin, end] : point_ranges(rows)) {
        std::vector<std::string> line;
        for (const StudyColumn& column : table)
            if (column.group == "parameters") line.push_back(column.cells[begin]);
        std::size_t done = 0, failed = 0;
        for (std::size_t i = begin; i < end; ++i) done += exits[i] == 0, failed += exits[i] > 0;
        line.insert(line.end(), {std::to_string(done), std::to_string(failed)});
        for (const auto& [column, numbers] : measures) {
            const MeanEstimate estimate = estimated_mean(std::span(numbers).subspan(begin, end - begin));
            for (const double value : {estimate.mean, estimate.low, estimate.high})
                line.push_back(estimate_cell(value));
        }
        summary.push_back(std::move(line));
    }
    return summary;
}

}  // namespace sherd
