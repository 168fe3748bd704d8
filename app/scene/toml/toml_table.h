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

/// Returns the place where a user has written a key or a value: "plate.toml:12", or the override "--set
/// KEY=VALUE".
std::string place_of(const toml::source_region& source);

/// Collects the mistakes of a scene, so that a user sees them all at once.
class Problems {
  public:
    /// Adds a problem, unless the same one has been added before: a table may be read more than once. source:
    /// where it is; key: dotted key; what: the mistake and its remedy.
    void add(const toml::source_region& source, std::string_view key, const std::string& what);

    /// If there are problems, throws Error with a line for each: in the order of the file, problems of
    /// overrides last.
    void throw_if_any() const;

  private:
    struct Problem {
        bool overridden;
        toml::source_position position;
        std::string line;
    };
    std::vector<Problem> problems;
};

/// Reads the keys of one TOML table. A missing key without a fallback is added to the problems, and so is a
/// value of wrong type, length or range. The caller then gets an empty value, or NaN, for which all later
/// comparisons are false, so that there is one message for each mistake; flags and integers get their
/// fallback. A key becomes known when it is asked for; finish() reports all other keys.
class TomlTable {
  public:
    /// path: dotted key of the table; directory: folder to which names of files in the table are relative.
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
    /// If the table has `key`, a key of earlier versions, reports it with its replacement `instead`, such as
    /// "scheme = \"auto\" does that".
    void retired(std::string_view key, std::string_view instead);
    /// If `key` is set to `name`, a value of earlier versions, reports it with the replacement `instead` and
    /// returns true; the caller must then not call choice(), which would report it again.
    bool retired(std::string_view key, std::string_view name, std::string_view instead);
    /// Reads an array of one or more of `names`, each once; empty after a problem. or_flag: whether messages
    /// say that true and false are allowed, too.
    std::vector<std::string> choices(std::string_view key, std::span<const std::string_view> names,
                                     bool or_flag = false);
    Eigen::Vector3d vector(std::string_view key, std::string_view unit,
                           std::optional<Eigen::Vector3d> fallback = {});
    /// Reads two numbers. or_one: whether messages say that a single number is allowed, too.
    Eigen::Vector2d pair(std::string_view key, std::string_view unit, const Range& range, bool or_one = true);
    /// Reads an array of arrays of `columns` numbers, with at least `least` rows, and `most` at most; 0: any
    /// number.
    std::vector<Eigen::VectorXd> rows(std::string_view key, std::string_view unit, std::size_t least,
                                      std::size_t columns, std::size_t most = 0);
    /// Reads an array of any number of arrays, each as rows() reads it.
    std::vector<std::vector<Eigen::VectorXd>> lists_of_rows(std::string_view key, std::string_view unit,
                                                            std::size_t least, std::size_t columns);
    /// Returns the table at `key`; none when it is missing or not a table.
    std::optional<TomlTable> table(std::string_view key);
    /// Returns the tables at `key`, which may be a single table or an array of tables; empty when the key is
    /// missing.
    std::vector<TomlTable> tables(std::string_view key);
    /// Returns the tables in this table, with their names, in the order of the file. An entry that is no
    /// table is a problem.
    std::vector<std::pair<std::string, TomlTable>> entries();

    /// Adds a problem at `key`, or at the table itself when the key is missing.
    void report(std::string_view key, const std::string& what);
    /// Returns "FILE:LINE: dotted.key" of a key, for errors that are found later.
    std::string where(std::string_view key) const;
    bool is_string(std::string_view key) const { return content->get_as<std::string>(key) != nullptr; }
    bool is_number(std::string_view key) const { return (*content)[key].is_number(); }
    bool is_flag(std::string_view key) const { return (*content)[key].is_boolean(); }
    bool is_table(std::string_view key) const { return content->get_as<toml::table>(key) != nullptr; }
    bool is_array(std::string_view key) const { return content->get_as<toml::array>(key) != nullptr; }
    /// Reports every key of the table that has never been asked for, with the most similar key that has been.
    void finish();

  private:
    const toml::node* find(std::string_view key);
    const toml::source_region& source(std::string_view key) const;
    std::string dotted(std::string_view key) const;
    void reject(std::string_view key, std::string_view wanted, std::string_view hint = {});
    std::optional<Eigen::VectorXd> numbers(const toml::node& node) const;
    /// Returns the rows of a node that is an array of at least `least` arrays of `columns` numbers, and of
    /// `most` at most (0: any number); none if it is not.
    std::optional<std::vector<Eigen::VectorXd>> rows(const toml::node& node, std::size_t least,
                                                     std::size_t columns, std::size_t most) const;

    const toml::table* content;
    std::string path;
    Problems* problems;
    std::filesystem::path directory;
    std::vector<std::string> known;
};

}  // namespace sherd
