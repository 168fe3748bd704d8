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

/// What the chosen subcommand does once the command line is parsed; returns the exit code.
using Command = std::function<int()>;

/// Each adds its subcommand to `program`; parsing it sets `chosen`, which must outlive the parsing.
void add_run(CLI::App& program, Command& chosen);
void add_sweep(CLI::App& program, Command& chosen);
void add_check(CLI::App& program, Command& chosen);
void add_modes(CLI::App& program, Command& chosen);
void add_info(CLI::App& program, Command& chosen);
void add_export(CLI::App& program, Command& chosen);
void add_cut(CLI::App& program, Command& chosen);
void add_probe(CLI::App& program, Command& chosen);
void add_bench(CLI::App& program, Command& chosen);
void add_converge(CLI::App& program, Command& chosen);
void add_render(CLI::App& program, Command& chosen);
void add_plot(CLI::App& program, Command& chosen);
void add_view(CLI::App& program, Command& chosen);
void add_mesh(CLI::App& program, Command& chosen);
void add_scenes(CLI::App& program, Command& chosen);
/// What they print is made of `program` as it is when they run, with all of its commands.
void add_completion(CLI::App& program, Command& chosen);
void add_manual(CLI::App& program, Command& chosen);

/// A scene as the command line gives it: its file has been found (find_scene).
struct SceneOptions {
    std::filesystem::path file;
    SceneChoice choice;
};

/// Adds SCENE.toml, --variant and --set to a subcommand; `options` must outlive the parsing, which throws
/// Error when there is no such scene.
void add_scene_options(CLI::App& command, SceneOptions& options);

/// NAME.ext becomes NAME-PART.ext: a file of one variant, or of one sheet. Without a part it stays as it is.
std::filesystem::path part_file(const std::filesystem::path& file, const std::string& part);

/// Throws Error when `output` is the scene's file or a mesh that it reads: not even --force may replace them.
void require_no_input(const std::filesystem::path& output, const Scene& scene);

/// The scene in the variant that is asked for; else in each of its variants, or as it is when it has none.
/// Throws Error with the mistakes of all of them.
std::vector<Scene> read_scenes(const SceneOptions& options);

}  // namespace sherd
