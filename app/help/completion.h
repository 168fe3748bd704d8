// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace sherd {

/// Returns a script that completes, in bash 4 or later and without further programs, the commands of
/// `program`, their options, the values of options, files by extension, and shipped scenes.
std::string bash_completion(const CLI::App& program);

/// Returns a script for zsh that completes the same words as bash_completion(). It works as a file `_sherd`
/// in a folder of the fpath, and when it is sourced after compinit.
std::string zsh_completion(const CLI::App& program);

}  // namespace sherd
