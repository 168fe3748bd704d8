// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/scene/keys/key_info.h"

namespace sherd {

/// A table of scenes, and its place, for example "sheet.NAME.fracture". The place of the outermost table, the
/// scene itself, is empty. Several tables with equal places are the kinds of table that are allowed there.
struct PlacedSection {
    std::string place;
    SectionText section;
};

/// Returns all tables of scenes. Each table comes before the tables inside it, so that the scene itself is
/// first.
std::vector<PlacedSection> scene_sections();

/// Returns the allowed values of a key in words, for example "a positive number (m)" or "\"hue\" or
/// \"vector\"".
std::string value_text(const KeyInfo& key);

/// Returns the default of a key, for example "0.3"; "required" if the scene must have the key; empty if no
/// default is documented.
std::string default_text(const KeyText& key);

/// Returns the reference of the keys of scenes as text, in lines of at most `columns` characters; 0: of any
/// length. wanted: a table, for example "solver", "[solver]", "sheet.fracture", "sheet.plate.fracture" (with
/// any name of a sheet), or "scene" for the outermost table; or a key, for example "solver.step"; or empty
/// for all tables. Throws Error (input) if there is no such table or key: with the replacement of a key of
/// earlier versions, or the nearest name.
std::string key_reference(const std::string& wanted, std::size_t columns);

/// Returns the reference of the keys that `wanted` names as tables in Markdown. wanted and errors: see
/// key_reference().
std::string key_tables(const std::string& wanted);

/// Returns the names by which key_reference() finds each table, for example "solver" and "sheet.fracture".
std::vector<std::string> table_names();

/// Returns a line for completion for each key that `--set` can set: the dotted key, followed by its allowed
/// words. In a key of a sheet or an obstacle, each of the given names in turn takes the place of NAME.
std::vector<std::string> settable_lines(const std::vector<std::string>& sheets,
                                        const std::vector<std::string>& obstacles);

}  // namespace sherd
