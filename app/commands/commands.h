// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/scene/scene_choice.h"

namespace sherd {

struct Scene;

/// Runs the chosen subcommand once the command line is parsed; returns the exit code.
using Command = std::function<int()>;

/// Functions that each add a subcommand to `program`. If the subcommand is on the command line, parsing sets
/// `chosen`, which must outlive the parsing.
void add_run(CLI::App& program, Command& chosen);
void add_sweep(CLI::App& program, Command& chosen);
void add_check(CLI::App& program, Command& chosen);
void add_modes(CLI::App& program, Command& chosen);
void add_info(CLI::App& program, Command& chosen);
void add_export(CLI::App& program, Command& chosen);
void add_cut(CLI::App& program, Command& chosen);
void add_probe(CLI::App& program, Command& chosen);
void add_converge(CLI::App& program, Command& chosen);
void add_render(CLI::App& program, Command& chosen);
void add_plot(CLI::App& program, Command& chosen);
void add_view(CLI::App& program, Command& chosen);
void add_mesh(CLI::App& program, Command& chosen);
void add_scenes(CLI::App& program, Command& chosen);
/// Functions that each add a subcommand, whose output describes all commands that `program` has when it runs.
void add_completion(CLI::App& program, Command& chosen);
void add_manual(CLI::App& program, Command& chosen);

/// Choice of a scene on the command line.
struct SceneOptions {
    std::filesystem::path file;  ///< result of find_scene()
    SceneChoice choice;
};

/// Adds SCENE.toml, --variant and --set to a subcommand. `options` must outlive the parsing. Parsing throws
/// Error if there is no such scene.
void add_scene_options(CLI::App& command, SceneOptions& options);

/// Returns NAME-PART.ext for NAME.ext, for a file of one variant or of one sheet; `file` itself without a
/// part.
std::filesystem::path part_file(const std::filesystem::path& file, const std::string& part);

/// Throws Error if `output` is the scene's file or a mesh that it reads, which not even --force may replace.
void require_no_input(const std::filesystem::path& output, const Scene& scene);

/// Returns the scene in the chosen variant. If none is chosen, returns the scene in each of its variants, or
/// as it is if it has no variants. Throws Error with the mistakes of all variants.
std::vector<Scene> read_scenes(const SceneOptions& options);

}  // namespace sherd
