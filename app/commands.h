// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace sherd {

/// What the chosen subcommand does once the command line is parsed; returns the exit code.
using Command = std::function<int()>;

/// Each adds its subcommand to `program`; parsing it sets `chosen`, which must outlive the parsing.
void add_run(CLI::App& program, Command& chosen);
void add_check(CLI::App& program, Command& chosen);
void add_info(CLI::App& program, Command& chosen);
void add_export(CLI::App& program, Command& chosen);
void add_cut(CLI::App& program, Command& chosen);
void add_probe(CLI::App& program, Command& chosen);
void add_render(CLI::App& program, Command& chosen);
void add_plot(CLI::App& program, Command& chosen);
void add_view(CLI::App& program, Command& chosen);

/// A scene as the command line gives it.
struct SceneOptions {
    std::filesystem::path file;
    std::vector<std::string> overrides;  ///< KEY=VALUE
};

/// Adds SCENE.toml and --set to a subcommand; `options` must outlive the parsing.
void add_scene_options(CLI::App& command, SceneOptions& options);

}  // namespace sherd
