// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/measures/measures.h"
#include "app/sweep/distribution.h"
#include "app/sweep/slurm_options.h"

namespace sherd {

/// What is varied in a study: keys of its scene.
struct StudyParameter {
    std::string name;                   ///< of its column
    std::vector<std::string> patterns;  ///< assignments of `sherd run --set`, with {} for the value
    std::vector<std::string> values;    ///< as TOML; none where they are drawn
    std::optional<Distribution> drawn;  ///< from this
};

/// How the values of several parameters make rows.
enum class Design {
    grid,    ///< each with each, the last parameter fastest
    zip,     ///< the first of all, the second of all, ...
    latin,   ///< samples, of which each parameter has one in each of as many equal shares
    random,  ///< samples, each drawn by itself
};

/// Whose recordings are kept.
enum class Keep { none, failed, all };

/// A study file, read and checked but for its scene.
struct Study {
    std::filesystem::path file;
    std::string scene;             ///< as in the file
    std::string variant;           ///< of the scene; empty: none
    std::vector<std::string> set;  ///< assignments for all rows
    Design design = Design::grid;
    std::int64_t samples = 0;  ///< of `latin` and `random`
    std::int64_t seed = 1;     ///< of what is drawn
    std::int64_t repeats = 1;  ///< of each point, with seeds of the scene that follow each other
    std::vector<StudyParameter> parameters;
    std::vector<std::string> measures;  ///< names of study_measures(); empty: all
    double over = 0;                    ///< kg, of fragments that count
    CrackCentre centre;                 ///< where radial and ring cracks are counted
    std::string python;                 ///< file with measure(recording); empty: none
    Keep keep = Keep::none;
    SlurmOptions slurm;
};

/// Reads a study; app/README.md has its keys. quick: with the keys of its table `quick` over the others.
/// Throws Error (input) with file, line and key for each mistake. The scene is not opened.
Study read_study(const std::filesystem::path& file, bool quick);

/// Does so with its text; `file` is for messages.
Study parse_study(const std::string& text, const std::filesystem::path& file, bool quick);

}  // namespace sherd
