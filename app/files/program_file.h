// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace sherd {

/// Files of a bundle. Its launcher (app/bundle) starts libexec/NAME, which is the loader, as this process;
/// the code is in libexec/NAME.program.
struct BundledProgram {
    std::filesystem::path code;
    std::filesystem::path launcher;  ///< bin/NAME, which starts the program again
};

/// Returns the bundle of `running`, the executable of this process, if the code is beside it; otherwise none.
std::optional<BundledProgram> bundled_program(const std::filesystem::path& running);

/// Returns the file of this program's code, whose checksum identifies the build.
std::filesystem::path program_file();

/// Returns the file that starts this program again: in a bundle its launcher, otherwise /proc/self/exe, which
/// is valid also when PATH has changed.
std::filesystem::path program_to_start();

/// Returns the bundle's own Python; without a bundle `python3`, from the PATH.
std::string python_to_start();

/// Returns the words of this program's command line, each followed by '\0', without the bundle's loader.
std::string command_words();

}  // namespace sherd
