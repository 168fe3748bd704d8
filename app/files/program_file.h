// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace sherd {

/// A bundle's launcher (app/bundle) starts libexec/NAME, which is the loader, as this process; the code is in
/// libexec/NAME.program.
struct BundledProgram {
    std::filesystem::path code;
    std::filesystem::path launcher;  ///< bin/NAME, which starts the program once more
};

/// Takes `running`, the file that this process is, for that of a bundle if the code lies beside it.
std::optional<BundledProgram> bundled_program(const std::filesystem::path& running);

/// The file of this program's code, by whose checksum one build is told from another.
std::filesystem::path program_file();

/// Starts this program once more: in a bundle its launcher, else /proc/self/exe, which is there also when
/// PATH has changed.
std::filesystem::path program_to_start();

/// The bundle's own Python; elsewhere `python3` on the PATH.
std::string python_to_start();

/// The words of this program's command line, each with a '\0' at its end, without the bundle's loader.
std::string command_words();

}  // namespace sherd
