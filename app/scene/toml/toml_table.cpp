// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/toml/toml_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/messages/nearest_name.h"
#include "app/scene/toml/override.h"
#include "meshops/error.h"

namespace sherd {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
/// Bounds of the magnitudes of numbers: products of a few numbers beyond them would overflow or underflow.
constexpr double largest = 1e30, smallest = 1e-30;

std::string_view type_name(const toml::node& node) {
    switch (node.type()) {
        case toml::node_type::table:
            return "a table";
        case toml::node_type::array:
            return "an array";
        case toml::node_type::string:
            return "a string";
        case toml::node_type::integer:
            return "an integer";
        case toml::node_type::floating_point:
            return "a number";
        case toml::node_type::boolean:
            return "true or false";
        default:
            return "a date or time";
    }
}

/// Returns a number that is written with a point or an exponent. A small whole number keeps its point, as it
/// may be the point for which the number is refused.
std::string told_float(double value) {
    const bool is_small_whole = std::abs(value) < 1e6 && value == std::round(value);
    return is_small_whole ? fmt::format("{:.1f}", value) : fmt::format("{}", value);
}

/// Returns the value of a node for messages, or its type if the value may be long.
std::string told(const toml::node& node) {
    if (const auto* text = node.as_string()) return fmt::format("the string \"{}\"", text->get());
    if (const auto* number = node.as_floating_point()) return told_float(number->get());
    if (const auto* number = node.as_integer()) return fmt::format("{}", number->get());
    if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
    if (const auto* array = node.as_array()) return fmt::format("an array of {}", array->size());
    return std::string(type_name(node));
}

bool is_in_bounds(double value) {
    const double size = std::abs(value);
    return size == 0 || (size >= smallest && size <= largest);
}

std::optional<double> finite_number(const toml::node& node) {
    const std::optional<double> value = node.is_number() ? node.value<double>() : std::nullopt;
    return value && std::isfinite(*value) && is_in_bounds(*value) ? value : std::nullopt;
}

/// Whether the node is a number, or an array with a number, that is finite but out of bounds.
bool is_out_of_bounds(const toml::node& node) {
    if (const toml::array* array = node.as_array())
        return std::any_of(array->begin(), array->end(),
                           [](const toml::node& item) { return is_out_of_bounds(item); });
    const std::optional<double> value = node.is_number() ? node.value<double>() : std::nullopt;
    return value && std::isfinite(*value) && !is_in_bounds(*value);
}

std::string with_unit(std::string_view words, std::string_view unit) {
    return unit.empty() ? std::string(words) : fmt::format("{} ({})", words, unit);
}

/// Returns "an array of at least 2 arrays of 3 finite numbers" and the like.
std::string row_words(std::size_t least, std::size_t columns, std::size_t most) {
    return fmt::format("an array of {}{} arrays of {} finite numbers", least == most ? "" : "at least ",
                       least, columns);
}

/// Returns the element of `names` that is nearest to a word; empty if none is similar.
std::string nearest_word(const std::string& word, std::span<const std::string_view> names) {
    const std::vector<std::string> known(names.begin(), names.end());
    return word.empty() ? "" : nearest_name(word, known);
}

/// Returns the question whether one of `names` was meant by a word; empty if none is similar.
std::string suggestion(const std::string& word, std::span<const std::string_view> names) {
    const std::string nearest = nearest_word(word, names);
    return nearest.empty() ? "" : fmt::format("; did you mean \"{}\"?", nearest);
}

/// Returns the question whether an array with one of `names` was meant by a word; empty if none is similar.
std::string suggested_array(const std::string& word, std::span<const std::string_view> names) {
    const std::string nearest = nearest_word(word, names);
    return nearest.empty() ? "" : fmt::format("; did you mean [\"{}\"]?", nearest);
}

std::string left_out(double fallback) {
    return std::isfinite(fallback) ? fmt::format("; left out, it is {}", fallback) : "";
}

}  // namespace

std::string place_of(const toml::source_region& source) {
    const std::string path = source.path ? *source.path : "scene";
    return is_override(path) ? path : fmt::format("{}:{}", path, source.begin.line);
}

void Problems::add(const toml::source_region& source, std::string_view key, const std::string& what) {
    const bool overridden = source.path && is_override(*source.path);
    const std::string line = fmt::format("{}: {}: {}", place_of(source), key, what);
    const bool is_known = std::ranges::any_of(problems, [&](const Problem& p) { return p.line == line; });
    if (!is_known) problems.push_back({overridden, source.begin, line});
}

void Problems::throw_if_any() const {
    if (problems.empty()) return;
    std::vector<Problem> sorted = problems;
    std::stable_sort(sorted.begin(), sorted.end(), [](const Problem& a, const Problem& b) {
        return a.overridden != b.overridden ? b.overridden : a.position < b.position;
    });
    std::vector<std::string> lines;
    for (const Problem& problem : sorted) lines.push_back(problem.line);
    throw Error(fmt::format("{}", fmt::join(lines, "\n")));
}

TomlTable::TomlTable(const toml::table& table, std::string path, Problems& problems,
                     std::filesystem::path directory)
    : content(&table), path(std::move(path)), problems(&problems), directory(std::move(directory)) {}

bool TomlTable::has(std::string_view key) {
    return find(key) != nullptr;
}

double TomlTable::number(std::string_view key, std::string_view unit, const Range& range,
                         std::optional<double> fallback) {
    const toml::node* node = find(key);
    if (!node && fallback) return *fallback;
    const std::optional<double> value = node ? finite_number(*node) : std::nullopt;
    if (value && range.contains(*value)) return *value;
    reject(key, with_unit(range.words(), unit), fallback ? left_out(*fallback) : "");
    return not_a_number;
}

std::int64_t TomlTable::integer(std::string_view key, std::int64_t smallest, std::int64_t largest,
                                std::int64_t fallback) {
    const toml::node* node = find(key);
    if (!node) return fallback;
    const auto* value = node->as_integer();
    if (value && value->get() >= smallest && value->get() <= largest) return value->get();
    reject(key, fmt::format("an integer from {} to {}", smallest, largest),
           fmt::format("; left out, it is {}", fallback));
    return fallback;
}

bool TomlTable::flag(std::string_view key, bool fallback) {
    const toml::node* node = find(key);
    if (!node) return fallback;
    if (node->is_boolean()) return node->as_boolean()->get();
    reject(key, "true or false", fmt::format("; left out, it is {}", fallback));
    return fallback;
}

std::string TomlTable::string(std::string_view key, std::string_view what) {
    const toml::node* node = find(key);
    if (node && node->is_string() && !node->as_string()->get().empty()) return node->as_string()->get();
    reject(key, fmt::format("{} in quotes", what));
    return {};
}

std::filesystem::path TomlTable::file(std::string_view key, std::string_view what) {
    const std::string name = string(key, what);
    return name.empty() ? std::filesystem::path() : directory / name;
}

std::string TomlTable::choice(std::string_view key, std::span<const std::string_view> names) {
    const toml::node* node = find(key);
    std::string value = node && node->is_string() ? node->as_string()->get() : "";
    if (std::find(names.begin(), names.end(), value) != names.end()) return value;
    reject(key, fmt::format("one of \"{}\"", fmt::join(names, "\", \"")), suggestion(value, names));
    return {};
}

std::size_t TomlTable::choice_number(std::string_view key, std::span<const std::string_view> names) {
    const auto found = std::find(names.begin(), names.end(), choice(key, names));
    return found == names.end() ? 0 : static_cast<std::size_t>(found - names.begin());
}

void TomlTable::retired(std::string_view key, std::string_view instead) {
    // has() makes the key a known one, which messages list, so it is called only if the table has the key.
    if (content->contains(key) && has(key)) report(key, fmt::format("is no key any more: {}", instead));
}

bool TomlTable::retired(std::string_view key, std::string_view name, std::string_view instead) {
    if (!has(key) || (*content)[key].value<std::string_view>() != name) return false;
    report(key, fmt::format("has no \"{}\" any more: {}", name, instead));
    return true;
}

Eigen::Vector3d TomlTable::vector(std::string_view key, std::string_view unit,
                                  std::optional<Eigen::Vector3d> fallback) {
    const toml::node* node = find(key);
    if (!node && fallback) return *fallback;
    const std::optional<Eigen::VectorXd> value = node ? numbers(*node) : std::nullopt;
    if (value && value->size() == 3) return *value;
    reject(key, with_unit("an array of 3 finite numbers", unit),
           fallback ? fmt::format("; left out, it is [{}]", fmt::join(*fallback, ", ")) : "");
    return Eigen::Vector3d::Constant(not_a_number);
}

Eigen::Vector2d TomlTable::pair(std::string_view key, std::string_view unit, const Range& range,
                                bool or_one) {
    const toml::node* node = find(key);
    const std::optional<Eigen::VectorXd> value = node ? numbers(*node) : std::nullopt;
    if (value && value->size() == 2 && range.contains((*value)[0]) && range.contains((*value)[1]))
        return *value;
    const std::string words = or_one ? fmt::format("{}, or an array of 2 of them", range.words())
                                     : fmt::format("an array of 2, each {}", range.words());
    reject(key, with_unit(words, unit));
    return Eigen::Vector2d::Constant(not_a_number);
}

std::vector<std::string> TomlTable::choices(std::string_view key, std::span<const std::string_view> names,
                                            bool or_flag) {
    const toml::node* node = find(key);
    const toml::array* array = node ? node->as_array() : nullptr;
    const std::string wanted = fmt::format("an array of one or more of \"{}\", each once{}",
                                           fmt::join(names, "\", \""), or_flag ? ", or true or false" : "");
    if (!array || array->empty()) {
        const std::string word = node ? node->value_or(std::string()) : "";
        reject(key, wanted, suggested_array(word, names));
        return {};
    }
    std::vector<std::string> chosen;
    for (const toml::node& item : *array) {
        const std::string value = item.value_or(std::string());
        const bool is_known = std::ranges::find(names, value) != names.end();
        if (!is_known || std::ranges::find(chosen, value) != chosen.end()) {
            report(key, fmt::format("must be {}, not an array with {}{}", wanted, told(item),
                                    is_known ? " twice" : suggestion(value, names)));
            return {};
        }
        chosen.push_back(value);
    }
    return chosen;
}

std::optional<std::vector<Eigen::VectorXd>> TomlTable::rows(const toml::node& node, std::size_t least,
                                                            std::size_t columns, std::size_t most) const {
    const toml::array* array = node.as_array();
    if (!array || array->size() < least || (most > 0 && array->size() > most)) return std::nullopt;
    std::vector<Eigen::VectorXd> result;
    for (const toml::node& item : *array) {
        const std::optional<Eigen::VectorXd> row = numbers(item);
        if (!row || static_cast<std::size_t>(row->size()) != columns) return std::nullopt;
        result.push_back(*row);
    }
    return result;
}

std::vector<Eigen::VectorXd> TomlTable::rows(std::string_view key, std::string_view unit, std::size_t least,
                                             std::size_t columns, std::size_t most) {
    const toml::node* node = find(key);
    if (node)
        if (std::optional<std::vector<Eigen::VectorXd>> good = rows(*node, least, columns, most))
            return *good;
    reject(key, with_unit(row_words(least, columns, most), unit));
    return {};
}

std::vector<std::vector<Eigen::VectorXd>> TomlTable::lists_of_rows(std::string_view key,
                                                                   std::string_view unit, std::size_t least,
                                                                   std::size_t columns) {
    const toml::node* node = find(key);
    const toml::array* array = node ? node->as_array() : nullptr;
    std::vector<std::vector<Eigen::VectorXd>> result;
    bool good = array != nullptr;
    for (std::size_t i = 0; good && i < array->size(); ++i) {
        std::optional<std::vector<Eigen::VectorXd>> list = rows(*array->get(i), least, columns, 0);
        good = list.has_value();
        if (good) result.push_back(std::move(*list));
    }
    if (good) return result;
    reject(key, with_unit(fmt::format("an array of arrays of at least {} arrays of {} finite numbers", least,
                                      columns),
                          unit));
    return {};
}

std::optional<TomlTable> TomlTable::table(std::string_view key) {
    const toml::node* node = find(key);
    if (!node) return std::nullopt;
    if (const toml::table* inner = node->as_table())
        return TomlTable(*inner, dotted(key), *problems, directory);
    reject(key, "a table");
    return std::nullopt;
}

std::vector<TomlTable> TomlTable::tables(std::string_view key) {
    const toml::node* node = find(key);
    if (!node) return {};
    if (const toml::table* only = node->as_table())
        return {TomlTable(*only, dotted(key), *problems, directory)};
    std::vector<TomlTable> result;
    const toml::array* array = node->as_array();
    for (std::size_t i = 0; array && i < array->size(); ++i)
        if (const toml::table* item = array->get(i)->as_table())
            result.emplace_back(*item, fmt::format("{}[{}]", dotted(key), i), *problems, directory);
    if (!array || result.size() != array->size()) reject(key, "a table or an array of tables");
    return result;
}

std::vector<std::pair<std::string, TomlTable>> TomlTable::entries() {
    std::vector<std::string> names;
    for (const auto& [key, node] : *content) names.emplace_back(key.str());
    // Keys of overrides have no position in the file and come last.
    const auto order = [this](const std::string& key) {
        const toml::source_region& source = content->get(key)->source();
        return std::pair(source.path != content->source().path, source.begin);
    };
    std::stable_sort(names.begin(), names.end(),
                     [&](const std::string& a, const std::string& b) { return order(a) < order(b); });
    std::vector<std::pair<std::string, TomlTable>> result;
    for (const std::string& key : names)
        if (auto entry = table(key)) result.emplace_back(key, std::move(*entry));
    return result;
}

void TomlTable::report(std::string_view key, const std::string& what) {
    problems->add(source(key), dotted(key), what);
}

std::string TomlTable::where(std::string_view key) const {
    return fmt::format("{}: {}", place_of(source(key)), dotted(key));
}

void TomlTable::finish() {
    for (const auto& [key, node] : *content) {
        const std::string name(key.str());
        if (std::find(known.begin(), known.end(), name) != known.end()) continue;
        const std::string nearest = nearest_name(name, known);
        const std::string hint = nearest.empty() ? "" : fmt::format("did you mean '{}'? ", nearest);
        problems->add(key.source(), dotted(name),
                      fmt::format("unknown key; {}known here: {}", hint, fmt::join(known, ", ")));
    }
}

const toml::node* TomlTable::find(std::string_view key) {
    if (std::find(known.begin(), known.end(), key) == known.end()) known.emplace_back(key);
    return content->get(key);
}

const toml::source_region& TomlTable::source(std::string_view key) const {
    const toml::node* node = content->get(key);
    return node ? node->source() : content->source();
}

std::string TomlTable::dotted(std::string_view key) const {
    if (key.empty()) return path;
    return path.empty() ? std::string(key) : fmt::format("{}.{}", path, key);
}

void TomlTable::reject(std::string_view key, std::string_view wanted, std::string_view hint) {
    const toml::node* node = content->get(key);
    const std::string bounds =
        node && is_out_of_bounds(*node)
            ? fmt::format("; numbers other than 0 are from {} to {}", smallest, largest)
            : "";
    report(key, node ? fmt::format("must be {}, not {}{}{}", wanted, told(*node), bounds, hint)
                     : fmt::format("is missing: give {}", wanted));
}

std::optional<Eigen::VectorXd> TomlTable::numbers(const toml::node& node) const {
    const toml::array* array = node.as_array();
    if (!array) return std::nullopt;
    Eigen::VectorXd values(static_cast<Eigen::Index>(array->size()));
    for (std::size_t i = 0; i < array->size(); ++i) {
        const std::optional<double> value = finite_number(*array->get(i));
        if (!value) return std::nullopt;
        values[static_cast<Eigen::Index>(i)] = *value;
    }
    return values;
}

}  // namespace sherd
