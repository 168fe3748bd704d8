// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace sherd {

/// Value of an option or an argument, as far as a shell can complete it.
struct OptionValue {
    enum class Kind {
        none,      ///< a flag
        anything,  ///< a number, a name: nothing to offer
        words,
        file,   ///< also a folder
        scene,  ///< a .toml file, or the name of a shipped scene
        shipped_scene,
        setting  ///< KEY=VALUE of a scene
    };

    Kind kind = Kind::anything;
    std::vector<std::string> words;  ///< words, or the extensions of a file; empty: any extension
};

/// Derives the value from the help, so that it is declared in one place: words are those of an option text
/// like `rigid|morph`; a file's option text ends in an extension (`RUN.h5`) or is PATH, FILE, FOLDER, OUT or
/// MESH, or its description has extensions in brackets, `(.obj, .ply)`; SCENE.toml and SCENE are scenes, and
/// KEY=VALUE is a setting.
OptionValue option_value(const CLI::Option& option);

/// Names of an option as they are typed: -o, --output; empty for an argument.
std::vector<std::string> typed_names(const CLI::Option& option);

/// Placeholder of the value in the help; empty for a flag.
std::string value_name(const CLI::Option& option);

/// The options that the help shows; with `positional` the arguments, in their order.
std::vector<const CLI::Option*> shown_options(const CLI::App& command, bool positional);

/// The commands that the help shows.
std::vector<const CLI::App*> shown_commands(const CLI::App& program);

}  // namespace sherd
