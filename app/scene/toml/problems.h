// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <toml++/toml.h>

#include <string>
#include <string_view>
#include <vector>

namespace sherd {

/// Returns the place of something in a scene: "plate.toml:12", or the override "--set KEY=VALUE".
std::string place_of(const toml::source_region& source);

/// Collects the mistakes of a scene, so that a user sees them all at once.
class Problems {
  public:
    /// Adds a problem. key: dotted; what: the mistake and its remedy.
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
