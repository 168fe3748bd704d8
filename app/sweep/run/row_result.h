// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace sherd {

/// Result of a row that has been run to its end.
struct RowResult {
    std::uint64_t identity = 0;  ///< StudyRow::identity
    std::uint64_t program = 0;   ///< StudyRows::program
    int exit_code = 0;
    double wall_seconds = 0, processor_seconds = 0;
    std::string message;                                 ///< why it failed; empty: no failure
    std::map<std::string, double> values;                ///< values of measures: measure_values()
    std::vector<std::pair<std::string, double>> python;  ///< values of the study's Python file, in the file's
                                                         ///< order
};

/// Returns a result as a line of JSON, without a line feed.
std::string to_line(const RowResult& result);
/// Returns the result in a line that to_line() made; none if the line is not of this kind.
std::optional<RowResult> row_result(const std::string& line);

}  // namespace sherd
