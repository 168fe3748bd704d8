// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace sherd {

/// Value of an option or an argument, described for completion by a shell.
struct OptionValue {
    enum class Kind {
        none,           ///< no value: the option is a flag
        anything,       ///< for example a number or a name; a shell can offer nothing
        words,          ///< a word out of a given list
        file,           ///< a file or a folder
        scene,          ///< a .toml file, or the name of a shipped scene
        shipped_scene,  ///< the name of a shipped scene
        setting         ///< a setting KEY=VALUE of a scene
    };

    Kind kind = Kind::anything;
    std::vector<std::string> words;  ///< Kind::words: the words; Kind::file: extensions, empty: any
};

/// Returns the value of an option or argument, derived from its help, so that it is declared in one place. An
/// option text like `rigid|morph` lists words. A value is a file if the option text ends in an extension
/// (`RUN.h5`) or is PATH, FILE, FOLDER, OUT or MESH, if the description has extensions in brackets, `(.obj,
/// .ply)`, or if it is an argument without any of these signs. SCENE.toml and SCENE are scenes, KEY=VALUE is
/// a setting, and [TABLE] is a table of scenes.
OptionValue option_value(const CLI::Option& option);

/// Returns the names of an option as users type them, for example -o and --output; empty for an argument.
std::vector<std::string> typed_names(const CLI::Option& option);

/// Returns the placeholder of an option's value in the help; empty for a flag.
std::string value_name(const CLI::Option& option);

/// Returns the options of `command` that the help shows; if `positional` is true, instead its arguments, in
/// their order.
std::vector<const CLI::Option*> shown_options(const CLI::App& command, bool positional);

/// Returns the commands of `program` that the help shows.
std::vector<const CLI::App*> shown_commands(const CLI::App& program);

}  // namespace sherd
