// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solver/elimination_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace sherd {
namespace {

/// Entries of a factor below which threads cost more time than they save.
constexpr double least_entries = 2e5;
/// Largest share of all operations that a subtree in a part may have. With a smaller one, more operations
/// would be above the parts, where only strips of dense matrices are shared.
constexpr double largest_part = 1.0 / 6;

/// Operations of each supernode's subtree, as in Supernodes::operations(), but of blocks.
std::vector<double> subtree_operations(const Supernodes& pattern) {
    std::vector<double> all(pattern.size());
    for (Index node = 0; node < pattern.size(); ++node) {
        all[node] += std::pow(static_cast<double>(pattern.rows(node).size()), 2) * pattern.columns(node);
        if (pattern.parent[node] >= 0) all[pattern.parent[node]] += all[node];
    }
    return all;
}

/// Operations that the largest subtree in a part may have.
double most_in_a_subtree(const Supernodes& pattern) {
    if (pattern.factor_entries() < least_entries) return std::numeric_limits<double>::infinity();
    return largest_part * pattern.operations() / 27;
}

EliminationPart part_of(const Supernodes& pattern, Index begin, Index end) {
    EliminationPart part{begin, end, pattern.first[begin], pattern.first[end] - pattern.first[begin], {}};
    for (Index node = begin; node < end; ++node) {
        if (pattern.parent[node] < end && pattern.parent[node] >= 0) continue;
        // A root in the part: its rows include all rows of its subtree outside of the part.
        const std::span<const Index> rows = pattern.rows_below(node);
        part.outside.insert(part.outside.end(), rows.begin(), rows.end());
    }
    std::ranges::sort(part.outside);
    part.outside.erase(std::unique(part.outside.begin(), part.outside.end()), part.outside.end());
    return part;
}

void find_places(const Supernodes& pattern, const EliminationPart& part, std::vector<Index>& place) {
    for (std::size_t i = pattern.start[part.first]; i < pattern.start[part.end]; ++i) {
        const Index row = pattern.row[i];
        if (row < part.first_column + part.columns)
            place[i] = row - part.first_column;
        else
            place[i] = part.columns +
                       static_cast<Index>(std::ranges::lower_bound(part.outside, row) - part.outside.begin());
    }
}

}  // namespace

EliminationParts::EliminationParts(const Supernodes& pattern)
    : is_above(pattern.size(), 0), place(pattern.row) {
    const std::vector<double> operations = subtree_operations(pattern);
    const double most = most_in_a_subtree(pattern);
    for (Index node = 0; node < pattern.size(); ++node) is_above[node] = operations[node] > most;
    Index begin = 0;
    double in_part = 0;
    const auto end_part = [&](Index end) {
        if (begin < end) parts.push_back(part_of(pattern, begin, end));
        begin = end;
        in_part = 0;
    };
    // Subtrees come one after the other, and the supernodes above them come last.
    for (Index node = 0; node < pattern.size(); ++node) {
        const Index parent = pattern.parent[node];
        if (is_above[node] != 0) {
            end_part(node);
            above.push_back(begin++);
        } else if (parent < 0 || is_above[parent] != 0) {
            in_part += operations[node];
            if (in_part > most / 2) end_part(node + 1);
        }
    }
    end_part(pattern.size());
    for (const EliminationPart& part : parts) find_places(pattern, part, place);
}

}  // namespace sherd
