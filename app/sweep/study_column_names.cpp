// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/study_column_names.h"

#include <algorithm>
#include <array>
#include <string>

#include "app/sweep/study_measures.h"

namespace sherd {
namespace {

/// Columns of every table, apart from those of the study.
constexpr std::array<std::string_view, 11> fixed_columns{
    "row",     "seed",       "exit",       "wall_seconds", "cpu_seconds", "message",
    "command", "scene_hash", "files_hash", "program_hash", "recording"};

}  // namespace

bool is_study_column(std::string_view name) {
    return std::ranges::find(fixed_columns, name) != fixed_columns.end() ||
           measure_error(std::string(name)).empty();
}

}  // namespace sherd
