// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/measures/measures.h"
#include "app/sweep/study/distribution.h"
#include "app/sweep/study/slurm_options.h"

namespace sherd {

/// A parameter of a study, which varies keys of its scene.
struct StudyParameter {
    std::string name;                   ///< name of its column in the table
    std::vector<std::string> patterns;  ///< assignments for `sherd run --set`, with {} in place of the value
    std::vector<std::string> values;    ///< values as TOML; empty if they are drawn
    std::optional<Distribution> drawn;  ///< distribution of values that are drawn; none: `values`
};

/// Rule by which values of several parameters are combined into points.
enum class Design {
    grid,    ///< each value with each value of the other parameters; the last parameter changes fastest
    zip,     ///< the first values of all parameters, the second values of all, and so on
    latin,   ///< `samples` points; a parameter has one value in each of `samples` equally probable ranges
    random,  ///< `samples` points, whose values are drawn independently
};

/// Rows whose recordings are kept: no rows, failed ones, or all.
enum class Keep { none, failed, all };

/// A study file that has been read and checked, except for its scene.
struct Study {
    std::filesystem::path file;
    std::string scene;             ///< scene as named in the study file
    std::string variant;           ///< variant of the scene; empty: none
    std::vector<std::string> set;  ///< assignments KEY=VALUE for the scenes of all rows
    Design design = Design::grid;
    std::int64_t samples = 0;  ///< number of points of the designs `latin` and `random`
    std::int64_t seed = 1;     ///< seed of drawn values
    std::int64_t repeats = 1;  ///< number of rows of each point, which have consecutive seeds of the scene
    std::vector<StudyParameter> parameters;
    std::vector<std::string> measures;  ///< names that measure_error() accepts; empty: all measures
    double over = 0;                    ///< kg, largest mass of fragments that are not counted
    CrackCentre centre;                 ///< point about which radial and ring cracks are counted
    std::string python;                 ///< Python file with measure(recording); empty: none
    Keep keep = Keep::none;
    SlurmOptions slurm;
};

/// Reads a study; docs/commands.md describes its keys. quick: whether the keys of the study's table `quick`
/// replace its other keys. Throws Error (input) with file, line and key for each mistake. The scene is not
/// opened.
Study read_study(const std::filesystem::path& file, bool quick);

/// Reads a study from its text, like read_study(); `file` is for messages.
Study parse_study(const std::string& text, const std::filesystem::path& file, bool quick);

}  // namespace sherd
