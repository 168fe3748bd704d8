// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <vector>

namespace sherd {

/// The distinct values of a list and, for each entry of the list, the number of its value.
template <class T>
struct SharedValues {
    std::vector<T> rows = {};               ///< distinct values, in the order of their first entries
    std::vector<std::int32_t> number = {};  ///< number in `rows` of the value of each entry; -1: none
};

template <class T>
SharedValues<T> shared_values(const std::vector<std::shared_ptr<const T>>& values) {
    SharedValues<T> shared;
    std::map<T, std::int32_t> known;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!values[i]) {
            shared.number.push_back(-1);
        } else if (i > 0 && values[i] == values[i - 1]) {
            shared.number.push_back(shared.number.back());
        } else {
            const auto next = static_cast<std::int32_t>(shared.rows.size());
            const auto [entry, is_new] = known.try_emplace(*values[i], next);
            if (is_new) shared.rows.push_back(*values[i]);
            shared.number.push_back(entry->second);
        }
    }
    return shared;
}

/// Returns the list again: entries with the same number point to the same value, and entries with the number
/// -1 are null.
template <class T>
std::vector<std::shared_ptr<const T>> listed(const SharedValues<T>& shared) {
    std::vector<std::shared_ptr<const T>> rows, values;
    for (const T& row : shared.rows) rows.push_back(std::make_shared<const T>(row));
    for (const std::int32_t number : shared.number) values.push_back(number < 0 ? nullptr : rows[number]);
    return values;
}

}  // namespace sherd
