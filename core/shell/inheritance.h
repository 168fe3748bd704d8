// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <concepts>
#include <span>

#include "core/shell_change.h"

namespace sherd {

/// What an element that is born gets of an attribute that its parents have; of positions and numbers it gets
/// the mean by weights.
enum class Inheritance {
    common,  ///< what all parents agree on
    first,   ///< that of the first parent
    none     ///< nothing: whoever made the change sets it
};

/// Appends to an array of columns, or of numbers, what each heir gets; zero without parents.
void append(Positions& columns, std::span<const Heir> heirs);
void append(VectorXd& values, std::span<const Heir> heirs);

/// The same of a list, by `rule`; `missing` where there is nothing to get.
template <class T>
void append(std::vector<T>& values, std::span<const Heir> heirs, Inheritance rule, const T& missing) {
    const auto agree = [&values](const std::vector<Heir::Parent>& parents) {
        if constexpr (std::equality_comparable<T>)
            return std::ranges::all_of(parents, [&](const Heir::Parent& parent) {
                return values[parent.element] == values[parents.front().element];
            });
        else
            return parents.size() == 1;
    };
    for (const auto& [element, parents] : heirs) {
        const bool inherits =
            !parents.empty() && rule != Inheritance::none && (rule == Inheritance::first || agree(parents));
        values.push_back(inherits ? T(values[parents.front().element]) : missing);
    }
}

}  // namespace sherd
