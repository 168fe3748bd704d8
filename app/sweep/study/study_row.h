// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/scene/scene_choice.h"
#include "app/sweep/study/study.h"

namespace sherd {

/// A run of a study.
struct StudyRow {
    std::vector<std::string> values;  ///< values of the parameters, as in the table
    std::size_t point = 0;            ///< number of the point; rows of the same values have the same
    std::int64_t seed = 0;            ///< seed of the scene
    SceneChoice choice;
    std::uint64_t scene = 0;     ///< hash of the scene's settings, with variant and overrides
    std::uint64_t files = 0;     ///< hash of the content of the scene's files
    std::uint64_t identity = 0;  ///< hash of `scene`, `files` and the way of measuring; results refer to it
    double duration = 0;         ///< duration of the scene, in its unit of time
};

/// Rows of a study, and their common data.
struct StudyRows {
    std::filesystem::path scene;   ///< absolute path
    std::filesystem::path python;  ///< absolute path; empty: none
    std::uint64_t program = 0;     ///< hash of this program
    std::vector<StudyRow> rows;
};

/// Reads the scene of each row. build: also builds the scenes of rows that have the first, the smallest and
/// the largest value of each parameter, and each value that is no number. Throws Error (input) with the
/// mistakes in the scenes, each once.
StudyRows study_rows(const Study& study, bool build);

/// Returns the command line that repeats a row, without its recording: arguments of the program.
std::vector<std::string> row_arguments(const StudyRows& rows, const StudyRow& row);

/// Returns the command line that repeats a row, to be typed into a shell.
std::string row_command(const StudyRows& rows, const StudyRow& row);

}  // namespace sherd
