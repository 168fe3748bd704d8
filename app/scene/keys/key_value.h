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

/// Form of a key whose value is read into a Value.
template <class Value>
constexpr Form form_of = Form{};
template <>
inline constexpr Form form_of<double> = Form::number;
template <>
inline constexpr Form form_of<bool> = Form::flag;
template <>
inline constexpr Form form_of<int> = Form::integer;
template <>
inline constexpr Form form_of<std::int64_t> = Form::integer;
template <>
inline constexpr Form form_of<std::string> = Form::text;
template <>
inline constexpr Form form_of<std::filesystem::path> = Form::file;
template <>
inline constexpr Form form_of<Eigen::Vector3d> = Form::vector;
template <>
inline constexpr Form form_of<Eigen::Vector2d> = Form::pair;
template <Enumeration Enum>
constexpr Form form_of<Enum> = Form::choice;
template <class Value>
constexpr Form form_of<std::optional<Value>> = form_of<Value>;

/// Whether a table sets a key to its retired value (KeyRules::retired), which is then reported.
bool is_retired(TomlTable& table, const KeyInfo& key);

// read_value() reads the value of a key. If the key is missing and not required, `value` keeps its value.
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

// as_toml() returns a value as TOML, or "" if a user could not write it, such as an infinite number.
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
