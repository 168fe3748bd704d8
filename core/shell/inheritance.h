// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <concepts>
#include <span>

#include "core/shell_change.h"

namespace sherd {

/// Rule by which a new element inherits an attribute that is a std::vector. Attributes that are Eigen arrays
/// (Positions and VectorXd) are always the weighted mean of the parents' values.
enum class Inheritance {
    common,  ///< the parents' value if all parents have the same value
    first,   ///< the value of the first parent
    copies,  ///< copies (elements with a single parent) get the parent's value
    around,  ///< copies get the parent's value, other edges a mean: see follow_around()
    none     ///< nothing: the code that makes the change sets the value
};

/// Appends the values of new elements to an array of columns, or of numbers: the weighted mean of the
/// parents' values, and zero for an element without parents.
void append(Positions& columns, std::span<const IndexWithParents> inserted);
void append(VectorXd& values, std::span<const IndexWithParents> inserted);

/// Lets positions or velocities of vertices [3, V] follow a change: inserted vertices are appended, and moved
/// vertices get the mean of their parents.
void follow(Positions& of_vertices, const ShellChange& change);

/// Gives moved vertices the mean of their parents' values.
void follow_moves(VectorXd& of_vertices, std::span<const IndexWithParents> moved);

/// Lets a list with a number for each edge follow a change. A copy gets its parent's number. An edge across
/// old faces gets the mean of the finite numbers of the edges around these faces, or `missing` if none of
/// them is finite.
void follow_around(std::vector<double>& of_edges, const ShellChange& change, double missing);

/// Appends the values of new elements to a list by `rule`; `missing` for an element that inherits nothing.
template <class T>
void append(std::vector<T>& values, std::span<const IndexWithParents> inserted, Inheritance rule,
            const T& missing) {
    const auto agree = [&](const std::vector<IndexWithParents::Parent>& parents) {
        if constexpr (std::equality_comparable<T>)
            return std::ranges::all_of(parents, [&](const IndexWithParents::Parent& parent) {
                return values[parent.element] == values[parents.front().element];
            });
        else
            return parents.size() == 1;
    };
    for (const auto& [element, parents] : inserted) {
        const bool inherits = rule == Inheritance::copies
                                  ? parents.size() == 1
                                  : !parents.empty() && rule != Inheritance::none &&
                                        (rule == Inheritance::first || agree(parents));
        values.push_back(inherits ? T(values[parents.front().element]) : missing);
    }
}

}  // namespace sherd
