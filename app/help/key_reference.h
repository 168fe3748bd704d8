// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/scene/keys/key_info.h"

namespace sherd {

/// A table of a scene, and where it stands: "sheet.NAME.fracture", empty for the scene itself. Several of one
/// place are the kinds of table that may stand there.
struct PlacedSection {
    std::string place;
    SectionText section;
};

/// All tables of scenes: the scene itself, then each table before those in it.
std::vector<PlacedSection> scene_sections();

/// What a value may be: "a positive number (m)", "\"hue\" or \"vector\"".
std::string value_words(const KeyInfo& key);

/// What holds without the key: "required", "0.3 (m)"; empty: nothing is told.
std::string default_words(const KeyText& key);

/// The reference of scenes' keys in lines of at most `columns` characters; 0: of any length. wanted: a table,
/// "solver" or "sheet.fracture", or a key of it, "solver.step"; empty: all. Throws Error (input) with the
/// nearest name when there is none.
std::string key_reference(const std::string& wanted, std::size_t columns);

/// What `--set` may set, a line each: a dotted key, with the names of the scene's own sheets and obstacles,
/// and the words that it may be.
std::vector<std::string> settable_lines(const std::vector<std::string>& sheets,
                                        const std::vector<std::string>& obstacles);

}  // namespace sherd
