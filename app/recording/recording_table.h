// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include "app/recording/recording_format.h"
#include "meshops/error.h"

/// Tables of a recording. A row of a table is a plain struct; each member of the struct is a column, stored
/// as a dataset.
namespace sherd::recording_format {

/// Stored type of a member: bools and enumerations become numbers, since HDF5 has no bool that all readers
/// support.
template <class T>
using Stored = std::conditional_t<std::same_as<T, bool> || std::is_enum_v<T>, std::uint8_t, T>;

inline std::string column(const std::string& group, const char* name) {
    return fmt::format("{}/{}", group, name);
}

/// Creates a table with the columns for whose names wanted(name) is true.
template <class Row, class Wanted>
void create_table(hid_t file, const std::string& group, Wanted wanted) {
    Table<Row>::visit([&]<class T>(const char* name, hdf5::Meaning meaning, T Row::*) {
        if (wanted(name)) hdf5::create_column<Stored<T>>(file, column(group, name), meaning);
    });
}

template <class Row>
void create_table(hid_t file, const std::string& group = Table<Row>::group) {
    create_table<Row>(file, group, [](const char*) { return true; });
}

/// Calls visit(column name, member) for every column of a table, except for columns that the file may lack
/// and does lack.
template <class Row, class Visit>
void visit_columns(hid_t file, const std::string& group, Visit visit) {
    Table<Row>::visit([&]<class T>(const char* name, hdf5::Meaning, T Row::*member) {
        if constexpr (requires { Table<Row>::may_lack(name); })
            if (Table<Row>::may_lack(name) && !hdf5::contains(file, column(group, name))) return;
        visit(name, member);
    });
}

template <class Row>
void append_table(hid_t file, std::span<const Row> rows, const std::string& group = Table<Row>::group) {
    visit_columns<Row>(file, group, [&]<class T>(const char* name, T Row::*member) {
        std::vector<Stored<T>> values;
        for (const Row& row : rows) values.push_back(static_cast<Stored<T>>(row.*member));
        hdf5::append<Stored<T>>(file, column(group, name), values);
    });
}

/// Returns the number of complete rows, that is, of rows that are in all columns.
template <class Row>
std::size_t table_rows(hid_t file, const std::string& group = Table<Row>::group) {
    std::size_t rows = SIZE_MAX;
    visit_columns<Row>(file, group, [&]<class T>(const char* name, T Row::*) {
        rows = std::min<std::size_t>(
            rows, hdf5::row_count(file, column(group, name), hdf5::Element<Stored<T>>::width));
    });
    if (rows == SIZE_MAX) throw Error(group + " has no columns");
    return rows;
}

/// Reads a table; members whose column is missing keep their default.
template <class Row>
std::vector<Row> read_table(hid_t file, const std::string& group = Table<Row>::group) {
    std::vector<Row> rows(table_rows<Row>(file, group));
    visit_columns<Row>(file, group, [&]<class T>(const char* name, T Row::*member) {
        const std::vector<Stored<T>> values = hdf5::read<Stored<T>>(file, column(group, name));
        for (std::size_t i = 0; i < rows.size(); ++i) rows[i].*member = static_cast<T>(values[i]);
    });
    return rows;
}

/// Truncates a table to its first `rows` rows.
template <class Row>
void shorten_table(hid_t file, std::size_t rows, const std::string& group = Table<Row>::group) {
    Table<Row>::visit([&]<class T>(const char* name, hdf5::Meaning, T Row::*) {
        if (hdf5::contains(file, column(group, name))) hdf5::resize_table(file, column(group, name), rows);
    });
}

}  // namespace sherd::recording_format
