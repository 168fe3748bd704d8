// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace sherd {

/// A script for bash (4 and later, nothing else needed) that completes commands, options, their values,
/// files by extension and shipped scenes of `program`.
std::string bash_completion(const CLI::App& program);

/// A script for zsh that completes the same, as a file `_sherd` on its fpath, or sourced after compinit.
std::string zsh_completion(const CLI::App& program);

}  // namespace sherd
