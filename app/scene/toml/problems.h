// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <toml++/toml.h>

#include <string>
#include <string_view>
#include <vector>

namespace sherd {

/// Says in words where something of a scene stands: "plate.toml:12", or the override "--set KEY=VALUE".
std::string place_of(const toml::source_region& source);

/// Collects the mistakes of a scene, so that a user sees them all at once.
class Problems {
  public:
    /// `key` is dotted; `what` says what is wrong and what to do.
    void add(const toml::source_region& source, std::string_view key, const std::string& what);

    /// Throws Error with a line for each problem, in the order of the file, those of overrides at the end.
    void throw_if_any() const;

  private:
    struct Problem {
        bool overridden;
        toml::source_position position;
        std::string line;
    };
    std::vector<Problem> problems;
};

}  // namespace sherd
