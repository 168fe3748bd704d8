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
    std::string name;                   ///< name of its column
    std::vector<std::string> patterns;  ///< assignments of `sherd run --set`, with {} for the value
    std::vector<std::string> values;    ///< as TOML; empty if they are drawn
    std::optional<Distribution> drawn;  ///< distribution of drawn values
};

/// How the values of several parameters are combined in rows.
enum class Design {
    grid,    ///< each with each, the last parameter fastest
    zip,     ///< the first values of all, the second ones of all, ...
    latin,   ///< samples; each parameter has one in each of as many equal shares
    random,  ///< samples, each drawn independently
};

/// Rows whose recordings are kept.
enum class Keep { none, failed, all };

/// A study file that has been read and checked, except for its scene.
struct Study {
    std::filesystem::path file;
    std::string scene;             ///< as in the file
    std::string variant;           ///< variant of the scene; empty: none
    std::vector<std::string> set;  ///< assignments for all rows
    Design design = Design::grid;
    std::int64_t samples = 0;  ///< number of rows of `latin` and `random`
    std::int64_t seed = 1;     ///< seed of drawn values
    std::int64_t repeats = 1;  ///< rows of each point, with consecutive seeds of the scene
    std::vector<StudyParameter> parameters;
    std::vector<std::string> measures;  ///< names of all_measures(); empty: all
    double over = 0;                    ///< kg, largest mass of fragments that do not count
    CrackCentre centre;                 ///< point about which radial and ring cracks are counted
    std::string python;                 ///< file with measure(recording); empty: none
    Keep keep = Keep::none;
    SlurmOptions slurm;
};

/// Reads a study; docs/commands.md describes its keys. quick: whether the keys of its table `quick` replace
/// the others. Throws Error (input) with file, line and key for each mistake. The scene is not opened.
Study read_study(const std::filesystem::path& file, bool quick);

/// Reads a study from its text; `file` is for messages.
Study parse_study(const std::string& text, const std::filesystem::path& file, bool quick);

}  // namespace sherd
