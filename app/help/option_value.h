// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace sherd {

/// What may stand behind an option or in an argument's place, as far as a shell can complete it.
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
    std::vector<std::string> words;  ///< of a file: its extensions, none for any
};

/// Reads it off the help, so that there is one place for either: words are the ones of an option text like
/// `rigid|morph`; a file's option text ends in an extension (`RUN.h5`) or is PATH, FILE, FOLDER, OUT or MESH,
/// or its description has extensions in brackets, `(.obj, .ply)`; SCENE.toml and SCENE are scenes, and
/// KEY=VALUE is a setting.
OptionValue option_value(const CLI::Option& option);

/// Its names as they are typed: -o, --output; none of an argument.
std::vector<std::string> typed_names(const CLI::Option& option);

/// What stands for its value in the help; empty for a flag.
std::string value_name(const CLI::Option& option);

/// The options that the help shows; with `positional` the arguments, in their order.
std::vector<const CLI::Option*> shown_options(const CLI::App& command, bool positional);

/// The commands that the help shows.
std::vector<const CLI::App*> shown_commands(const CLI::App& program);

}  // namespace sherd
