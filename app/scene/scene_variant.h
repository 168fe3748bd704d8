// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/scene/toml_table.h"

namespace sherd {

/// The names of the `[[variant]]`s of a scene, in the order of the file. A variant without a name, with one
/// that does not do as a part of a file's name, or with that of another one, is a problem.
std::vector<std::string> read_variant_names(TomlTable& root);

/// Takes the variants out of `scene` and lets the keys of the one called `name` replace those of the scene:
/// tables are merged, everything else, inline tables and arrays too, is replaced. Nothing replaces anything
/// when no variant has that name.
void apply_variant(toml::table& scene, const std::string& name);

/// The mistakes of several variants: what all of them share is told once.
class VariantMistakes {
  public:
    /// lines: the message of an Error; empty: the variant has no mistake.
    void add(const std::string& variant, const std::string& lines);
    /// Throws Error with a line for each mistake, with the names of its variants unless all have it.
    void throw_if_any() const;

  private:
    std::size_t variants = 0;
    std::vector<std::pair<std::string, std::vector<std::string>>> mistakes;  ///< a line, who has it
};

}  // namespace sherd
