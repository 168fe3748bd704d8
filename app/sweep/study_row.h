// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/scene/scene_choice.h"
#include "app/sweep/study.h"

namespace sherd {

/// One run of a study.
struct StudyRow {
    std::vector<std::string> values;  ///< of the parameters, as they stand in the table
    std::size_t point = 0;            ///< rows of the same values have the same
    std::int64_t seed = 0;            ///< of the scene
    SceneChoice choice;
    std::uint64_t scene = 0;     ///< hash of the settings that variant and overrides make of the file
    std::uint64_t files = 0;     ///< hash of what the scene's files hold
    std::uint64_t identity = 0;  ///< hash of both, and of how the run is measured: what a result belongs to
    double duration = 0;         ///< of the scene
};

/// The rows of a study and what is common to them.
struct StudyRows {
    std::filesystem::path scene;   ///< absolute
    std::filesystem::path python;  ///< absolute; empty: none
    std::uint64_t program = 0;     ///< hash of this program
    std::vector<StudyRow> rows;
};

/// Reads the scene of each row. build: also looks at the meshes and all else that a scene is built of, of
/// rows that have the first, the smallest and the largest value of each parameter, and each value that is no
/// number. Throws Error (input) with what the scenes are refused for, each reason once.
StudyRows study_rows(const Study& study, bool build);

/// The command line that repeats a row, but for its recording: arguments of the program.
std::vector<std::string> row_arguments(const StudyRows& rows, const StudyRow& row);

/// The same to be typed into a shell.
std::string row_command(const StudyRows& rows, const StudyRow& row);

}  // namespace sherd
