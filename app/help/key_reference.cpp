// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/help/key_reference.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "app/scene/read/scene.h"
#include "app/words/nearest_name.h"
#include "app/words/wrapped.h"
#include "meshops/error.h"

namespace sherd {
namespace {

constexpr std::string_view any_name = "NAME";

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
    const std::string without = default_words(key);
    const std::string text =
        fmt::format("{}{}. {}", value_words(key.info),
                    without.empty() ? "" : fmt::format("; default: {}", without), key.info.sentence);
    const std::size_t indent = width + 4;
    return fmt::format("  {:<{}}  {}\n", name, width,
                       columns < indent + 20 ? text : wrapped(text, columns - indent - 1, indent));
}

std::string section_lines(const PlacedSection& placed, const std::string& only, std::size_t columns) {
    std::size_t width = 0;
    for (const KeyText& key : placed.section.keys) width = std::max(width, key.info.name.size());
    std::string lines = fmt::format("{}{}\n", placed.place.empty() ? "" : fmt::format("[{}] ", placed.place),
                                    placed.section.title);
    for (const KeyText& key : placed.section.keys)
        if (only.empty() || key.info.name == only)
            lines += key_lines(std::string(key.info.name), key, width, columns);
    return lines;
}

/// Words that a shell can offer for a value, each after a blank.
std::string words_of(const KeyInfo& key) {
    std::string words;
    if (has_form(key.forms, Form::choice))
        for (const std::string_view name : key.rules.choices) words += fmt::format(" {}", name);
    return has_form(key.forms, Form::flag) ? words + " true false" : words;
}

bool has_key(const PlacedSection& placed, const std::string& name) {
    return std::ranges::any_of(placed.section.keys,
                               [&](const KeyText& key) { return key.info.name == name; });
}

/// Whether `typed` names a place: in full, without ".NAME", or by its end.
bool is_meant(const std::string& place, const std::string& typed) {
    const std::string bare = short_place(place);
    return place == typed || bare == typed || bare.ends_with("." + typed);
}

}  // namespace

std::vector<PlacedSection> scene_sections() {
    std::vector<PlacedSection> all;
    add_sections(all, "", scene_reference());
    return all;
}

std::string value_words(const KeyInfo& key) {
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
    add(Form::file, fmt::format("{} in quotes", rules.what));
    add(Form::vector, "an array of 3 numbers");
    add(Form::pair, "an array of 2 numbers");
    add(Form::rows,
        fmt::format("an array of at least {} arrays of {} numbers", rules.least_rows, rules.columns));
    add(Form::lists_of_rows, fmt::format("an array of arrays of at least {} arrays of {} numbers",
                                         rules.least_rows, rules.columns));
    add(Form::flag, "true or false");
    add(Form::table, "a table");
    add(Form::tables, "an array of tables");
    add(Form::named, "tables with names of your own");
    return joined_words(words) + (rules.unit.empty() ? "" : fmt::format(" ({})", rules.unit));
}

std::string default_words(const KeyText& key) {
    if (key.info.rules.required) return "required";
    return key.info.rules.otherwise.empty() ? key.fallback : std::string(key.info.rules.otherwise);
}

std::string key_reference(const std::string& wanted, std::size_t columns) {
    const std::vector<PlacedSection> sections = scene_sections();
    const std::size_t dot = wanted.rfind('.');
    const std::string table = dot == std::string::npos ? "" : wanted.substr(0, dot),
                      key = dot == std::string::npos ? wanted : wanted.substr(dot + 1);
    std::string text;
    const auto add = [&](const PlacedSection& placed, const std::string& only) {
        text += (text.empty() ? "" : "\n") + section_lines(placed, only, columns);
    };
    for (const PlacedSection& placed : sections)
        if (wanted.empty() || (!placed.place.empty() && is_meant(placed.place, wanted))) add(placed, "");
    if (!text.empty()) return text;
    for (const PlacedSection& placed : sections)
        if (has_key(placed, key) && (table.empty() || is_meant(placed.place, table))) add(placed, key);
    if (!text.empty()) return text;
    std::vector<std::string> known;
    for (const PlacedSection& placed : sections) {
        if (!placed.place.empty()) known.push_back(short_place(placed.place));
        for (const KeyText& one : placed.section.keys)
            known.push_back(dotted(short_place(placed.place), one.info.name));
    }
    const std::string nearest = nearest_name(wanted, known);
    throw Error(fmt::format("--keys {}: scenes have no table and no key of this name; {}", wanted,
                            nearest.empty() ? "'sherd scenes --keys' lists all of them"
                                            : fmt::format("did you mean '{}'?", nearest)));
}

std::vector<std::string> settable_lines(const std::vector<std::string>& sheets,
                                        const std::vector<std::string>& obstacles) {
    std::set<std::string> lines;
    for (const auto& [place, section] : scene_sections()) {
        const std::size_t at = place.find(any_name);
        const std::vector<std::string> names = at == std::string::npos         ? std::vector<std::string>{""}
                                               : place.starts_with("obstacle") ? obstacles
                                                                               : sheets;
        for (const std::string& name : names)
            for (const KeyText& key : section.keys)
                if (key.inside.empty())
                    lines.insert(dotted(at == std::string::npos
                                            ? place
                                            : std::string(place).replace(at, any_name.size(), name),
                                        key.info.name) +
                                 words_of(key.info));
    }
    return {lines.begin(), lines.end()};
}

}  // namespace sherd
