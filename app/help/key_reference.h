// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/scene/keys/key_info.h"

namespace sherd {

/// A table of scenes and its place: "sheet.NAME.fracture", empty for the scene itself. Several tables with
/// one place are the kinds of table that are allowed there.
struct PlacedSection {
    std::string place;
    SectionText section;
};

/// All tables of scenes: the scene itself, then each table before those in it.
std::vector<PlacedSection> scene_sections();

/// Allowed values of a key: "a positive number (m)", "\"hue\" or \"vector\"".
std::string value_text(const KeyInfo& key);

/// Default of a key: "required", "0.3"; empty: not documented.
std::string default_text(const KeyText& key);

/// Reference of the keys of scenes in lines of at most `columns` characters; 0: of any length. wanted: a
/// table, "solver" or "sheet.fracture", "scene" for the outermost, or a key of it, "solver.step"; empty: all.
/// Throws Error (input) with the nearest name if there is no such table or key.
std::string key_reference(const std::string& wanted, std::size_t columns);

/// Tables of these keys in Markdown, for pages. Throws Error like key_reference().
std::string key_tables(const std::string& wanted);

/// Lines for completion, one for each key that `--set` can set: the dotted key, with the names of these
/// sheets and obstacles, and its allowed words.
std::vector<std::string> settable_lines(const std::vector<std::string>& sheets,
                                        const std::vector<std::string>& obstacles);

}  // namespace sherd
