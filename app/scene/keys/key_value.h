// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <type_traits>

#include "app/scene/keys/key_info.h"
#include "app/scene/toml/toml_table.h"

namespace sherd {

template <class Value>
concept Enumeration = std::is_enum_v<Value>;

/// The form of a plain value.
template <class Value>
struct FormOf;
template <>
struct FormOf<double> {
    static constexpr Form form = Form::number;
};
template <>
struct FormOf<bool> {
    static constexpr Form form = Form::flag;
};
template <>
struct FormOf<int> {
    static constexpr Form form = Form::integer;
};
template <>
struct FormOf<std::int64_t> {
    static constexpr Form form = Form::integer;
};
template <>
struct FormOf<std::string> {
    static constexpr Form form = Form::text;
};
template <>
struct FormOf<std::filesystem::path> {
    static constexpr Form form = Form::file;
};
template <>
struct FormOf<Eigen::Vector3d> {
    static constexpr Form form = Form::vector;
};
template <>
struct FormOf<Eigen::Vector2d> {
    static constexpr Form form = Form::pair;
};
template <Enumeration Enum>
struct FormOf<Enum> {
    static constexpr Form form = Form::choice;
};
template <class Value>
struct FormOf<std::optional<Value>> : FormOf<Value> {};

/// Whether a table has the retired choice of a key, which is then reported.
bool is_retired(TomlTable& table, const KeyInfo& key);

// read_value() reads a value, which stays if the key is missing and not required.
void read_value(TomlTable& table, const KeyInfo& key, double& value);
void read_value(TomlTable& table, const KeyInfo& key, bool& value);
void read_value(TomlTable& table, const KeyInfo& key, int& value);
void read_value(TomlTable& table, const KeyInfo& key, std::int64_t& value);
void read_value(TomlTable& table, const KeyInfo& key, std::string& value);
void read_value(TomlTable& table, const KeyInfo& key, std::filesystem::path& value);
void read_value(TomlTable& table, const KeyInfo& key, Eigen::Vector3d& value);
void read_value(TomlTable& table, const KeyInfo& key, Eigen::Vector2d& value);
template <Enumeration Enum>
void read_value(TomlTable& table, const KeyInfo& key, Enum& value) {
    if ((key.rules.required || table.has(key.name)) && !is_retired(table, key))
        value = static_cast<Enum>(table.choice_number(key.name, key.rules.choices));
}
template <class Value>
void read_value(TomlTable& table, const KeyInfo& key, std::optional<Value>& value) {
    if (!key.rules.required && !table.has(key.name)) return;
    KeyInfo given = key;
    given.rules.required = true;
    read_value(table, given, value.emplace());
}

// as_toml() returns a value as TOML; empty if a user could not write it.
std::string as_toml(const KeyInfo& key, double value);
std::string as_toml(const KeyInfo& key, bool value);
std::string as_toml(const KeyInfo& key, int value);
std::string as_toml(const KeyInfo& key, std::int64_t value);
std::string as_toml(const KeyInfo& key, const std::string& value);
std::string as_toml(const KeyInfo& key, const std::filesystem::path& value);
std::string as_toml(const KeyInfo& key, const Eigen::Vector3d& value);
std::string as_toml(const KeyInfo& key, const Eigen::Vector2d& value);
template <Enumeration Enum>
std::string as_toml(const KeyInfo& key, Enum value) {
    return as_toml(key, std::string(key.rules.choices[static_cast<std::size_t>(value)]));
}
template <class Value>
std::string as_toml(const KeyInfo& key, const std::optional<Value>& value) {
    return value ? as_toml(key, *value) : "";
}

}  // namespace sherd
