// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <toml++/toml.h>

#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/scene/toml/range.h"

namespace sherd {

/// Returns the place of something in a scene: "plate.toml:12", or the override "--set KEY=VALUE".
std::string place_of(const toml::source_region& source);

/// Collects the mistakes of a scene, so that a user sees them all at once.
class Problems {
  public:
    /// Adds a problem. key: dotted; what: the mistake and its remedy.
    void add(const toml::source_region& source, std::string_view key, const std::string& what);

    /// Throws Error with a line for each problem, in the order of the file, those of overrides at the end.
    void throw_if_any() const;

  private:
    struct Problem {
        bool overridden;
        toml::source_position position;
        std::string line;
    };
    std::vector<Problem> problems;
};

/// Reads the keys of one TOML table. A missing key without a fallback, a wrong type, length or range is added
/// to the problems, with the fallback; the caller gets the fallback, an empty value, or NaN, for which no
/// later comparison holds. Every key asked for becomes a known one; finish() reports the others.
class TomlTable {
  public:
    /// directory: to which the names of files are relative.
    TomlTable(const toml::table& table, std::string path, Problems& problems,
              std::filesystem::path directory = {});

    bool has(std::string_view key);
    /// Reads a number. unit: for messages, "m", "kg/m^3".
    double number(std::string_view key, std::string_view unit, const Range& range,
                  std::optional<double> fallback = {});
    std::int64_t integer(std::string_view key, std::int64_t smallest, std::int64_t largest,
                         std::int64_t fallback);
    bool flag(std::string_view key, bool fallback);
    /// Reads a string. what: for messages, "a file name".
    std::string string(std::string_view key, std::string_view what);
    /// Reads the name of a file; it is empty after a problem.
    std::filesystem::path file(std::string_view key, std::string_view what);
    /// Reads one of `names`; the string is empty after a problem.
    std::string choice(std::string_view key, std::span<const std::string_view> names);
    /// Reads a choice() and returns its index in `names`; 0 after a problem.
    std::size_t choice_number(std::string_view key, std::span<const std::string_view> names);
    /// Reports a key of earlier versions. instead: its replacement, "scheme = \"auto\" does that".
    void retired(std::string_view key, std::string_view instead);
    /// Reports a choice that a key had in earlier versions. Returns whether the table makes it; choice()
    /// would then report it again.
    bool retired(std::string_view key, std::string_view name, std::string_view instead);
    /// Reads an array of one or more of `names`, each once; empty after a problem.
    std::vector<std::string> choices(std::string_view key, std::span<const std::string_view> names);
    Eigen::Vector3d vector(std::string_view key, std::string_view unit,
                           std::optional<Eigen::Vector3d> fallback = {});
    /// Reads two numbers. or_one: whether messages offer a single number, too.
    Eigen::Vector2d pair(std::string_view key, std::string_view unit, const Range& range, bool or_one = true);
    /// Reads an array of arrays of `columns` numbers, with at least `least` rows.
    std::vector<Eigen::VectorXd> rows(std::string_view key, std::string_view unit, std::size_t least,
                                      std::size_t columns);
    /// Reads an array of any number of such arrays.
    std::vector<std::vector<Eigen::VectorXd>> lists_of_rows(std::string_view key, std::string_view unit,
                                                            std::size_t least, std::size_t columns);
    /// Returns the table at `key`; none when it is missing or not a table.
    std::optional<TomlTable> table(std::string_view key);
    /// Returns the tables at `key`: one, or an array of them; empty when it is missing.
    std::vector<TomlTable> tables(std::string_view key);
    /// Returns all entries of this table by name, as tables, in the order of the file.
    std::vector<std::pair<std::string, TomlTable>> entries();

    /// Adds a problem at `key`, or at the table itself when the key is missing.
    void report(std::string_view key, const std::string& what);
    /// Returns "FILE:LINE: dotted.key", for errors found later.
    std::string where(std::string_view key) const;
    bool is_string(std::string_view key) const { return content->get_as<std::string>(key) != nullptr; }
    bool is_number(std::string_view key) const { return (*content)[key].is_number(); }
    bool is_table(std::string_view key) const { return content->get_as<toml::table>(key) != nullptr; }
    bool is_array(std::string_view key) const { return content->get_as<toml::array>(key) != nullptr; }
    /// Reports every key that was never asked for, with the nearest one that was.
    void finish();

  private:
    const toml::node* find(std::string_view key);
    const toml::source_region& source(std::string_view key) const;
    std::string dotted(std::string_view key) const;
    void reject(std::string_view key, std::string_view wanted, std::string_view hint = {});
    std::optional<Eigen::VectorXd> numbers(const toml::node& node) const;
    /// None unless the node is an array of at least `least` arrays of `columns` numbers.
    std::optional<std::vector<Eigen::VectorXd>> rows(const toml::node& node, std::size_t least,
                                                     std::size_t columns) const;

    const toml::table* content;
    std::string path;
    Problems* problems;
    std::filesystem::path directory;
    std::vector<std::string> known;
};

}  // namespace sherd
