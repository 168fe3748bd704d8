// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/scene/scene_choice.h"
#include "app/sweep/study/study.h"

namespace sherd {

/// A row of a study's table, which is one run.
struct StudyRow {
    std::vector<std::string> values;  ///< values of the parameters, as the table shows them
    std::size_t point = 0;            ///< number of the point in design_points(), which its repeats share
    std::int64_t seed = 0;            ///< seed of the scene
    SceneChoice choice;
    std::uint64_t scene = 0;     ///< hash of the scene's settings, with variant and overrides
    std::uint64_t files = 0;     ///< hash of the content of the scene's files
    std::uint64_t identity = 0;  ///< hash of `scene`, `files`, variant and options of measuring; results
                                 ///< refer to it
    double duration = 0;         ///< duration of the scene, in its unit of time
};

/// Rows of a study, and their common data.
struct StudyRows {
    std::filesystem::path scene;   ///< absolute path of the scene file
    std::filesystem::path python;  ///< absolute path of the study's Python file; empty: none
    std::uint64_t program = 0;     ///< hash of this program
    std::vector<StudyRow> rows;
};

/// Reads the scene of each row. build: whether to build also the scenes of the first row and, for each
/// parameter, of rows with its smallest and its largest number and with each value that is no number. Throws
/// Error (input) with the mistakes in the scenes, each listed once.
StudyRows study_rows(const Study& study, bool build);

/// Returns the arguments of the program with which it repeats a row, without options for the recording.
std::vector<std::string> row_arguments(const StudyRows& rows, const StudyRow& row);

/// Returns the command line that repeats a row, to be typed into a shell.
std::string row_command(const StudyRows& rows, const StudyRow& row);

}  // namespace sherd
