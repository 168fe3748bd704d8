// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace sherd {

/// Files of a program in a bundle. The launcher bin/NAME (app/bundle) starts libexec/NAME, which is the
/// dynamic loader under the program's name, as this process; the loader runs the program's code,
/// libexec/NAME.program.
struct BundledProgram {
    std::filesystem::path code;      ///< libexec/NAME.program
    std::filesystem::path launcher;  ///< bin/NAME, which starts the program again
};

/// Returns the bundle to which `running`, the executable of this process, belongs. Returns none if the
/// program's code is not beside it.
std::optional<BundledProgram> bundled_program(const std::filesystem::path& running);

/// Returns the file of this program's code, whose checksum identifies the build.
std::filesystem::path program_file();

/// Returns the file that starts this program again: in a bundle the launcher, otherwise /proc/self/exe, which
/// is valid even if PATH has changed.
std::filesystem::path program_to_start();

/// Returns the command that starts Python: the bundle's own Python if there is one, otherwise `python3` from
/// the PATH.
std::string python_to_start();

/// Returns the words of this program's command line, each followed by '\0'. In a bundle the launcher takes
/// the place of the loader and the loader's own arguments.
std::string command_words();

}  // namespace sherd
