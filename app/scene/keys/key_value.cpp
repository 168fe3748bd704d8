// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/keys/key_value.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace sherd {
namespace {

template <class Integer>
void read_integer(TomlTable& table, const KeyInfo& key, Integer& value) {
    constexpr std::int64_t smallest = std::numeric_limits<int>::min(),
                           largest = std::numeric_limits<int>::max();
    const Range& range = key.rules.range;
    const auto least = range.has_least() ? static_cast<std::int64_t>(range.least) : smallest;
    const auto most = range.has_most() ? static_cast<std::int64_t>(range.most) : largest;
    value = static_cast<Integer>(table.integer(key.name, least, most, value));
}

/// Returns a number as TOML. A large one has an exponent, so that nobody has to count its zeros: 3e10.
std::string toml_number(double value) {
    if (std::abs(value) < 1e6) return fmt::format("{}", value);
    double digits = value;
    int exponent = 0;
    for (; std::fmod(digits, 10) == 0; ++exponent) digits /= 10;
    return exponent < 3 ? fmt::format("{}", value) : fmt::format("{}e{}", digits, exponent);
}

template <class Vector>
std::string array_text(const Vector& value) {
    return value.allFinite() ? fmt::format("[{}]", fmt::join(value, ", ")) : "";
}

template <class Value>
std::optional<Value> fallback(const KeyInfo& key, const Value& value) {
    return key.rules.required ? std::nullopt : std::optional<Value>(value);
}

}  // namespace

bool is_retired(TomlTable& table, const KeyInfo& key) {
    const auto& [name, instead] = key.rules.retired;
    return !instead.empty() && table.retired(key.name, name, instead);
}

void read_value(TomlTable& table, const KeyInfo& key, double& value) {
    if (!key.rules.required && !table.has(key.name)) return;
    const bool is_told = key.rules.otherwise.empty();
    value = table.number(key.name, key.rules.unit, key.rules.range,
                         is_told ? fallback(key, value) : std::nullopt);
}
void read_value(TomlTable& table, const KeyInfo& key, bool& value) {
    if (key.rules.choices.empty())
        value = table.flag(key.name, value);
    else if (table.has(key.name))
        value = table.choice_number(key.name, key.rules.choices) == 0;
}
void read_value(TomlTable& table, const KeyInfo& key, int& value) {
    read_integer(table, key, value);
}
void read_value(TomlTable& table, const KeyInfo& key, std::int64_t& value) {
    read_integer(table, key, value);
}
void read_value(TomlTable& table, const KeyInfo& key, std::string& value) {
    if (key.rules.required || table.has(key.name)) value = table.string(key.name, key.rules.what);
}
void read_value(TomlTable& table, const KeyInfo& key, std::filesystem::path& value) {
    if (key.rules.required || table.has(key.name)) value = table.file(key.name, key.rules.what);
}
void read_value(TomlTable& table, const KeyInfo& key, Eigen::Vector3d& value) {
    value = table.vector(key.name, key.rules.unit, fallback(key, value));
}
void read_value(TomlTable& table, const KeyInfo& key, Eigen::Vector2d& value) {
    if (key.rules.required || table.has(key.name))
        value = table.pair(key.name, key.rules.unit, key.rules.range, false);
}

std::string as_toml(const KeyInfo& /*key*/, double value) {
    return std::isfinite(value) ? toml_number(value) : "";
}
std::string as_toml(const KeyInfo& key, bool value) {
    if (!key.rules.choices.empty()) return as_toml(key, std::string(key.rules.choices[value ? 0 : 1]));
    return value ? "true" : "false";
}
std::string as_toml(const KeyInfo& key, int value) {
    return as_toml(key, std::int64_t{value});
}
std::string as_toml(const KeyInfo& /*key*/, std::int64_t value) {
    return fmt::format("{}", value);
}
std::string as_toml(const KeyInfo& /*key*/, const std::string& value) {
    return value.empty() ? "" : fmt::format("\"{}\"", value);
}
std::string as_toml(const KeyInfo& key, const std::filesystem::path& value) {
    return as_toml(key, value.string());
}
std::string as_toml(const KeyInfo& /*key*/, const Eigen::Vector3d& value) {
    return array_text(value);
}
std::string as_toml(const KeyInfo& /*key*/, const Eigen::Vector2d& value) {
    return array_text(value);
}

}  // namespace sherd
