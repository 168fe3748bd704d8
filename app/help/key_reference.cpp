// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/help/key_reference.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "app/messages/nearest_name.h"
#include "app/messages/wrapped.h"
#include "app/scene/read/scene.h"
#include "meshops/error.h"

namespace sherd {
namespace {

constexpr std::string_view any_name = "NAME", scene_name = "scene";

std::string dotted(const std::string& place, std::string_view name) {
    return place.empty() ? std::string(name) : fmt::format("{}.{}", place, name);
}

void add_sections(std::vector<PlacedSection>& all, const std::string& place, const SectionText& section) {
    all.push_back({place, section});
    for (const KeyText& key : section.keys) {
        std::string inner = dotted(place, key.info.name);
        if (has_form(key.info.forms, Form::named)) inner = dotted(inner, any_name);
        for (const SectionText& kind : key.inside) add_sections(all, inner, kind);
    }
}

/// Returns "sheet.fracture" for "sheet.NAME.fracture".
std::string short_place(std::string place) {
    for (std::size_t at = 0; (at = place.find(".NAME")) != std::string::npos;) place.erase(at, 5);
    return place;
}

/// Returns the name by which a user finds the table at `place`.
std::string name_of_table(const std::string& place) {
    return place.empty() ? std::string(scene_name) : short_place(place);
}

std::string joined_words(const std::vector<std::string>& words) {
    if (words.size() < 2) return words.empty() ? "" : words[0];
    const std::vector<std::string> first(words.begin(), words.end() - 1);
    return fmt::format("{} or {}", fmt::join(first, ", "), words.back());
}

std::vector<std::string> quoted(std::span<const std::string_view> names) {
    std::vector<std::string> result;
    for (const std::string_view name : names) result.push_back(fmt::format("\"{}\"", name));
    return result;
}

std::string integer_words(const Range& range) {
    if (range.has_most()) return fmt::format("an integer from {:.0f} to {:.0f}", range.least, range.most);
    return range.has_least() ? fmt::format("an integer of {:.0f} or more", range.least) : "an integer";
}

std::string key_lines(const std::string& name, const KeyText& key, std::size_t width, std::size_t columns) {
    std::string note = default_text(key);
    if (!note.empty()) note = (key.info.rules.required ? "; " : "; default: ") + note;
    std::string text = fmt::format("{}{}. {}", value_text(key.info), note, key.info.sentence);
    std::erase(text, '`');  // Markdown's quotes around code
    const std::size_t indent = width + 4;
    return fmt::format("  {:<{}}  {}\n", name, width,
                       columns < indent + 20 ? text : wrapped(text, columns - indent - 1, indent));
}

std::string section_lines(const PlacedSection& placed, std::size_t columns) {
    std::size_t width = 0;
    for (const KeyText& key : placed.section.keys) width = std::max(width, key.info.name.size());
    std::string lines = fmt::format("{}{}\n", placed.place.empty() ? "" : fmt::format("[{}] ", placed.place),
                                    placed.section.title);
    for (const KeyText& key : placed.section.keys)
        lines += key_lines(std::string(key.info.name), key, width, columns);
    return lines;
}

/// Returns `text` as a cell of a Markdown table, in which `|` must be escaped.
std::string cell(std::string text) {
    for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2)
        text.insert(at, 1, '\\');
    return text;
}

std::string section_table(const PlacedSection& placed) {
    std::string table = placed.place.empty() ? "" : fmt::format("`[{}]` ", placed.place);
    table += fmt::format("{}:\n\n| key | value | default | meaning |\n| --- | --- | --- | --- |\n",
                         placed.section.title);
    for (const KeyText& key : placed.section.keys)
        table += fmt::format("| `{}` | {} | {} | {} |\n", key.info.name, cell(value_text(key.info)),
                             cell(default_text(key)), cell(std::string(key.info.sentence)));
    return table;
}

/// Returns the words that a shell can offer as value of a key, each after a blank.
std::string words_of(const KeyInfo& key) {
    std::string words;
    if (has_form(key.forms, Form::choice))
        for (const std::string_view name : key.rules.choices) words += fmt::format(" {}", name);
    return has_form(key.forms, Form::flag) ? words + " true false" : words;
}

/// Whether `typed` names the table at `place`: by the whole place, by the place without ".NAME", or by the
/// last parts of the latter. "scene" names the scene itself, whose place is empty.
bool is_meant(const std::string& place, const std::string& typed) {
    if (place.empty()) return typed == scene_name;
    const std::string bare = short_place(place);
    return place == typed || bare == typed || bare.ends_with("." + typed);
}

/// Throws Error (input): what a user has `typed` does not exist. The message suggests the table or key whose
/// name is nearest to `wanted`, the same without brackets and names that users choose.
[[noreturn]] void throw_unknown(const std::string& typed, const std::string& wanted,
                                const std::vector<PlacedSection>& sections) {
    std::vector<std::string> known;
    for (const PlacedSection& placed : sections) {
        known.push_back(name_of_table(placed.place));
        for (const KeyText& key : placed.section.keys)
            known.push_back(dotted(short_place(placed.place), key.info.name));
    }
    // nearest_name() takes the beginning of a name as near to the whole name. Names without a dot are
    // excluded if `wanted` has one, as otherwise "solver" would be suggested for "solver.stpe".
    if (wanted.find('.') != std::string::npos)
        std::erase_if(known, [](const std::string& name) { return name.find('.') == std::string::npos; });
    const std::string nearest = nearest_name(wanted, known);
    throw Error(fmt::format("--keys {}: scenes have no table and no key of this name; {}", typed,
                            nearest.empty() ? "'sherd scenes --keys' lists all of them"
                                            : fmt::format("did you mean '{}'?", nearest)));
}

/// If `wanted` is a key of earlier versions, or a word that a key could have then ("solver.midpoint"), throws
/// Error (input) with its replacement.
void throw_if_retired(const std::string& wanted, const std::vector<PlacedSection>& sections) {
    for (const PlacedSection& placed : sections) {
        const auto is_wanted = [&](std::string_view name) {
            return !name.empty() && (name == wanted || dotted(short_place(placed.place), name) == wanted);
        };
        for (const Retired& key : placed.section.retired)
            if (is_wanted(key.name))
                throw Error(fmt::format("--keys {}: is no key any more: {}", wanted, key.instead));
        for (const KeyText& key : placed.section.keys)
            if (const auto& [name, instead] = key.info.rules.retired; is_wanted(name))
                throw Error(fmt::format("--keys {}: {} has no \"{}\" any more: {}", wanted, key.info.name,
                                        name, instead));
    }
}

/// Returns the tables that `wanted` names. If it names none, returns the tables that have a key of this name,
/// each with only this key.
std::vector<PlacedSection> named_sections(const std::string& wanted,
                                          const std::vector<PlacedSection>& sections) {
    std::vector<PlacedSection> found;
    std::ranges::copy_if(sections, std::back_inserter(found),
                         [&](const PlacedSection& placed) { return is_meant(placed.place, wanted); });
    if (!found.empty()) return found;
    const std::size_t dot = wanted.rfind('.');
    const std::string table = dot == std::string::npos ? "" : wanted.substr(0, dot),
                      name = dot == std::string::npos ? wanted : wanted.substr(dot + 1);
    for (const PlacedSection& placed : sections)
        for (const KeyText& key : placed.section.keys)
            if (key.info.name == name && (table.empty() || is_meant(placed.place, table)))
                found.push_back({placed.place, {placed.section.title, {key}}});
    return found;
}

/// Returns "solver" for "[solver]" and "gauge" for "[[gauge]]".
std::string without_brackets(std::string heading) {
    while (heading.size() > 2 && heading.front() == '[' && heading.back() == ']')
        heading = heading.substr(1, heading.size() - 2);
    return heading;
}

/// Returns "sheet.fracture" for "sheet.plate.fracture", where "plate" is a name that a user has chosen for a
/// table; other texts stay as they are.
std::string without_chosen_name(const std::string& typed) {
    const std::size_t dot = typed.find('.'), end = typed.find('.', dot + 1);
    if (dot == std::string::npos || end == std::string::npos) return typed;
    for (const KeyText& key : scene_reference().keys)
        if (has_form(key.info.forms, Form::named) && typed.substr(0, dot) == key.info.name)
            return typed.substr(0, dot) + typed.substr(end);
    return typed;
}

/// Returns the tables, or the tables with one key, that a user asks for; all tables if `typed` is empty.
/// Throws Error (input) if there are none.
std::vector<PlacedSection> wanted_sections(const std::string& typed) {
    const std::string wanted = without_brackets(typed), bare = without_chosen_name(wanted);
    std::vector<PlacedSection> sections = scene_sections();
    if (wanted.empty()) return sections;
    for (const std::string& name : {wanted, bare})
        if (std::vector<PlacedSection> found = named_sections(name, sections); !found.empty()) return found;
    throw_if_retired(wanted, sections);
    throw_unknown(typed, bare, sections);
}

/// Returns the texts of sections without repetitions: different kinds of a table may contain the same table.
template <class Text>
std::string joined_texts(const std::vector<PlacedSection>& sections, Text text_of_section) {
    std::vector<std::string> texts;
    for (const PlacedSection& placed : sections)
        if (std::string text = text_of_section(placed); std::ranges::find(texts, text) == texts.end())
            texts.push_back(std::move(text));
    return fmt::format("{}", fmt::join(texts, "\n"));
}

}  // namespace

std::vector<PlacedSection> scene_sections() {
    std::vector<PlacedSection> all;
    add_sections(all, "", scene_reference());
    return all;
}

std::string value_text(const KeyInfo& key) {
    const KeyRules& rules = key.rules;
    const std::vector<std::string> names = quoted(rules.choices);
    std::vector<std::string> words;
    const auto add = [&](Form form, std::string text) {
        if (has_form(key.forms, form)) words.push_back(std::move(text));
    };
    add(Form::number, rules.range.words());
    add(Form::integer, integer_words(rules.range));
    add(Form::choice, joined_words(names));
    add(Form::names, fmt::format("an array of some of {}", fmt::join(names, ", ")));
    add(Form::text, fmt::format("{} in quotes", rules.what));
    add(Form::name, fmt::format("{} in quotes", rules.what));
    add(Form::file, fmt::format("{} in quotes", rules.what));
    add(Form::vector, "an array of 3 numbers");
    add(Form::pair, "an array of 2 numbers");
    add(Form::rows,
        fmt::format("an array of {}{} arrays of {} numbers",
                    rules.least_rows == rules.most_rows ? "" : "at least ", rules.least_rows, rules.columns));
    add(Form::lists_of_rows, fmt::format("an array of arrays of at least {} arrays of {} numbers",
                                         rules.least_rows, rules.columns));
    add(Form::flag, "true or false");
    add(Form::table, "a table");
    add(Form::tables, "an array of tables");
    add(Form::named, "tables with names of your own");
    return joined_words(words) + (rules.unit.empty() ? "" : fmt::format(" ({})", rules.unit));
}

std::string default_text(const KeyText& key) {
    if (key.info.rules.required) return "required";
    return key.info.rules.otherwise.empty() ? key.fallback : std::string(key.info.rules.otherwise);
}

std::string key_reference(const std::string& wanted, std::size_t columns) {
    return joined_texts(wanted_sections(wanted),
                        [columns](const PlacedSection& placed) { return section_lines(placed, columns); });
}

std::string key_tables(const std::string& wanted) {
    return joined_texts(wanted_sections(wanted), section_table);
}

std::vector<std::string> table_names() {
    std::vector<std::string> names;
    for (const PlacedSection& placed : scene_sections())
        if (const std::string name = name_of_table(placed.place);
            std::ranges::find(names, name) == names.end())
            names.push_back(name);
    return names;
}

std::vector<std::string> settable_lines(const std::vector<std::string>& sheets,
                                        const std::vector<std::string>& obstacles) {
    // Words of each key. If several kinds of a table have the key, their words are joined.
    std::map<std::string, std::string> words;
    const auto add = [&](const std::string& key, const std::string& more) {
        std::string& all = words[key];
        if (all.find(more) == std::string::npos) all += more;
    };
    for (const auto& [place, section] : scene_sections()) {
        if (place == variant_key) continue;  // --set cannot add a variant
        const std::size_t at = place.find(any_name);
        const std::vector<std::string> names = at == std::string::npos         ? std::vector<std::string>{""}
                                               : place.starts_with("obstacle") ? obstacles
                                                                               : sheets;
        for (const std::string& name : names)
            for (const KeyText& key : section.keys)
                if (key.inside.empty())
                    add(dotted(at == std::string::npos
                                   ? place
                                   : std::string(place).replace(at, any_name.size(), name),
                               key.info.name),
                        words_of(key.info));
    }
    std::vector<std::string> lines;
    for (const auto& [key, more] : words) lines.push_back(key + more);
    return lines;
}

}  // namespace sherd
