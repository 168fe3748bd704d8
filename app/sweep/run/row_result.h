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
    std::map<std::string, double> values;                ///< measure_values()
    std::vector<std::pair<std::string, double>> python;  ///< values of the study's Python file, in its order
};

/// Returns a line of JSON, without its end.
std::string to_line(const RowResult& result);
/// Reads a line of to_line(); none if it is not one.
std::optional<RowResult> row_result(const std::string& line);

}  // namespace sherd
