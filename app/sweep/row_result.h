// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace sherd {

/// What became of a row that has been run to its end.
struct RowResult {
    std::uint64_t identity = 0;  ///< StudyRow::identity
    std::uint64_t program = 0;   ///< StudyRows::program
    int exit_code = 0;
    double wall_seconds = 0, processor_seconds = 0;
    std::string message;                                 ///< why it failed; empty: it did not
    std::map<std::string, double> values;                ///< measure_values()
    std::vector<std::pair<std::string, double>> python;  ///< of the study's own file, in its order
};

/// One line of JSON, without its end.
std::string to_line(const RowResult& result);
/// None when the line is not one of to_line().
std::optional<RowResult> row_result(const std::string& line);

}  // namespace sherd
