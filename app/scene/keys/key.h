// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "app/scene/keys/key_value.h"

namespace sherd {

/// Declaration of a key of a TOML table, whose value is read into a Struct. Reading, messages, default,
/// documentation and schema of the key all follow from it.
template <class Struct>
struct Key {
    KeyInfo info;
    void (*read)(TomlTable& table, const KeyInfo& key, Struct& into) = nullptr;
    /// Returns the default, as TOML; null: there is none.
    std::string (*fallback)(const KeyInfo& key, const Struct& defaults) = nullptr;
    /// Returns the kinds of table that the value may be; null: it is no table.
    std::vector<SectionText> (*inside)() = nullptr;
};

/// A kind of table, whose keys are read into a Struct.
template <class Struct_>
struct Section {
    using Struct = Struct_;
    std::string_view title;  ///< heading in the reference
    std::span<const Key<Struct>> keys;
    /// Called when all keys have been read: checks the keys against each other and completes the Struct;
    /// null: there is nothing to do.
    void (*complete)(TomlTable& table, Struct& into) = nullptr;
};

/// Reports conflicts of a key with other keys of its table.
void report_conflicts(TomlTable& table, const KeyInfo& key);

/// Reads the keys of a table, and reports keys that conflict. The caller must call TomlTable::finish()
/// afterwards.
template <class Struct>
void read_keys(TomlTable& table, const Section<Struct>& section, Struct& into) {
    for (const Key<Struct>& key : section.keys) key.read(table, key.info, into);
    for (const Key<Struct>& key : section.keys) report_conflicts(table, key.info);
    if (section.complete != nullptr) section.complete(table, into);
}

/// Reads a whole table, and reports unknown keys.
template <class Struct>
void read_section(TomlTable& table, const Section<Struct>& section, Struct& into) {
    read_keys(table, section, into);
    table.finish();
}

/// Reports the keys of a table that its section does not have. It does not read the others.
template <class Struct>
void report_unknown_keys(TomlTable& table, const Section<Struct>& section) {
    for (const Key<Struct>& key : section.keys)
        if (key.info.forms != Form{}) table.has(key.info.name);
    table.finish();
}

template <class Struct>
SectionText text_of(const Section<Struct>& section) {
    const Struct defaults{};
    SectionText text{section.title, {}};
    for (const auto& [info, read, fallback, inside] : section.keys)
        if (info.forms != Form{})
            text.keys.push_back({info, fallback != nullptr ? fallback(info, defaults) : "",
                                 inside != nullptr ? inside() : std::vector<SectionText>()});
        else if (!info.rules.retired.instead.empty())
            text.retired.push_back({info.name, info.rules.retired.instead});
    return text;
}

namespace keys {

template <class Member>
struct Traits;
template <class Struct_, class Value_>
struct Traits<Value_ Struct_::*> {
    using Struct = Struct_;
    using Value = Value_;
};

/// A path: a sequence of pointers to members, each to a member of the previous member, such as
/// &Scene::simulation, &SimulationOptions::stepper. Struct is the class that has the first member, and Value
/// the type of the last member.
template <auto first, auto... rest>
struct Path {
    using Struct = typename Traits<decltype(first)>::Struct;
    using Value = typename Path<rest...>::Value;
};
template <auto only>
struct Path<only> : Traits<decltype(only)> {};

template <auto first, auto... rest, class Struct>
constexpr auto& at(Struct& all) {
    if constexpr (sizeof...(rest) == 0)
        return all.*first;
    else
        return at<rest...>(all.*first);
}

// read_table() reads a table into a member: a struct, an optional struct, or a list of structs.
template <class Struct>
void read_table(TomlTable& table, const KeyInfo& key, const Section<Struct>& section, Struct& into) {
    if (auto inner = table.table(key.name)) read_section(*inner, section, into);
}
template <class Struct>
void read_table(TomlTable& table, const KeyInfo& key, const Section<Struct>& section,
                std::optional<Struct>& into) {
    if (auto inner = table.table(key.name)) read_section(*inner, section, into.emplace());
}
template <class Struct>
void read_table(TomlTable& table, const KeyInfo& key, const Section<Struct>& section,
                std::vector<Struct>& into) {
    for (TomlTable& inner : table.tables(key.name)) read_section(inner, section, into.emplace_back());
}

template <const auto& list, std::size_t i, auto... path>
constexpr auto embed() {
    using Struct = typename Path<path...>::Struct;
    Key<Struct> key{list[i].info,
                    [](TomlTable& table, const KeyInfo& info, Struct& into) {
                        list[i].read(table, info, at<path...>(into));
                    },
                    nullptr, list[i].inside};
    if (list[i].fallback != nullptr)
        key.fallback = [](const KeyInfo& info, const Struct& defaults) {
            return list[i].fallback(info, at<path...>(defaults));
        };
    return key;
}

template <const auto& list, auto... path, std::size_t... i>
constexpr auto embed_all(std::index_sequence<i...>) {
    return std::array{embed<list, i, path...>()...};
}

template <class Value>
constexpr Form table_form = Form::table;
template <class Value>
constexpr Form table_form<std::vector<Value>> = Form::table | Form::tables;

}  // namespace keys

/// A key of a plain value, which is read into the member at the end of a path (keys::Path).
template <auto... path>
constexpr auto key(std::string_view name, std::string_view sentence, const KeyRules& rules = {}) {
    using Struct = typename keys::Path<path...>::Struct;
    const Form form = rules.choices.empty() ? form_of<typename keys::Path<path...>::Value> : Form::choice;
    return Key<Struct>{{name, form, rules, sentence},
                       [](TomlTable& table, const KeyInfo& info, Struct& into) {
                           read_value(table, info, keys::at<path...>(into));
                       },
                       [](const KeyInfo& info, const Struct& defaults) {
                           return as_toml(info, keys::at<path...>(defaults));
                       }};
}

/// A key whose value is a table that is read into the member at the end of a path (keys::Path): a struct, an
/// optional struct, or a vector of structs. For a vector an array of tables may be written, too.
template <const auto& section, auto... path>
constexpr auto table_key(std::string_view name, std::string_view sentence, const KeyRules& rules = {}) {
    using Struct = typename keys::Path<path...>::Struct;
    return Key<Struct>{{name, keys::table_form<typename keys::Path<path...>::Value>, rules, sentence},
                       [](TomlTable& table, const KeyInfo& info, Struct& into) {
                           keys::read_table(table, info, section, keys::at<path...>(into));
                       },
                       nullptr,
                       [] { return std::vector{text_of(section)}; }};
}

/// A key whose value is a table with keys that are read into the same Struct as the key itself.
template <const auto& section>
constexpr auto part_key(std::string_view name, std::string_view sentence, const KeyRules& rules = {}) {
    using Struct = typename std::remove_cvref_t<decltype(section)>::Struct;
    return Key<Struct>{{name, Form::table, rules, sentence},
                       [](TomlTable& table, const KeyInfo& info, Struct& into) {
                           keys::read_table(table, info, section, into);
                       },
                       nullptr,
                       [] { return std::vector{text_of(section)}; }};
}

/// A key with a reader of its own. Without forms, the reader must refuse the key, and the reference leaves it
/// out. inside: returns the kinds of table that the value may be; null: it is no table.
template <class Struct>
constexpr Key<Struct> special_key(std::string_view name, Form forms, std::string_view sentence,
                                  const KeyRules& rules,
                                  void (*read)(TomlTable& table, const KeyInfo& key, Struct& into),
                                  std::vector<SectionText> (*inside)() = nullptr) {
    return {{name, forms, rules, sentence}, read, nullptr, inside};
}

/// A key of earlier versions, which is reported with its replacement `instead`, and which the reference
/// leaves out.
template <class Struct>
constexpr Key<Struct> retired_key(std::string_view name, std::string_view instead) {
    return {{name, Form{}, {.retired = {{}, instead}}, {}},
            [](TomlTable& table, const KeyInfo& key, Struct& /*into*/) {
                table.retired(key.name, key.rules.retired.instead);
            }};
}

/// Returns the keys of several lists as one list, in their order.
template <class Struct, std::size_t... sizes>
constexpr auto joined(const std::array<Key<Struct>, sizes>&... lists) {
    std::array<Key<Struct>, (sizes + ...)> all{};
    auto end = all.begin();
    ((end = std::copy(lists.begin(), lists.end(), end)), ...);
    return all;
}

/// Returns the keys of a list for another Struct: the struct that they are read into is its member at the end
/// of a path.
template <const auto& list, auto... path>
constexpr auto embedded() {
    return keys::embed_all<list, path...>(std::make_index_sequence<list.size()>());
}

}  // namespace sherd
