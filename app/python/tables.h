// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/stl.h>

#include "app/python/arrays.h"
#include "app/recording/recording_table.h"

namespace sherd::python {

/// Returns the columns of a table of a recording, as arrays by the columns' names.
template <class Row>
py::dict columns_by_name(const std::vector<Row>& rows) {
    using namespace recording_format;
    py::dict columns;
    Table<Row>::visit([&]<class T>(const char* name, hdf5::Meaning, T Row::*member) {
        std::vector<Stored<T>> values;
        for (const Row& row : rows) values.push_back(static_cast<Stored<T>>(row.*member));
        columns[name] = array_of(values);
    });
    return columns;
}

/// Returns the columns of all events, by the kind of event.
inline py::dict events_by_kind(const CrackEvents& events) {
    py::dict by_kind;
    visit_kinds([&]<class Event>(std::vector<Event> CrackEvents::*kind) {
        const std::string group = recording_format::Table<Event>::group;
        by_kind[group.substr(group.find('/') + 1).c_str()] = columns_by_name(events.*kind);
    });
    return by_kind;
}

/// Returns an entry of a table's row as a Python object.
template <class T>
py::object value_of(const T& value) {
    if constexpr (std::same_as<T, Vector3d>)
        return numbers(value.data(), 3, 1);
    else if constexpr (std::is_enum_v<T>)
        return py::cast(static_cast<int>(value));
    else
        return py::cast(value);
}

}  // namespace sherd::python
