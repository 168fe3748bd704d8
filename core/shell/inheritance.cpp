// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shell/inheritance.h"

namespace sherd {
namespace {

/// Weighted mean of `part(element)` over the parents; a single parent's value is copied exactly.
template <class Value, class Part>
Value mean(const std::vector<Heir::Parent>& parents, const Value& zero, Part part) {
    if (parents.size() == 1) return part(parents.front().element);
    Value sum = zero;
    for (const auto& [element, weight] : parents) sum += weight * part(element);
    return sum;
}

}  // namespace

void append(Positions& columns, std::span<const Heir> heirs) {
    Eigen::Index next = columns.cols();
    columns.conservativeResize(3, next + static_cast<Eigen::Index>(heirs.size()));
    for (const Heir& heir : heirs)
        columns.col(next++) = mean(heir.parents, Vector3d(Vector3d::Zero()),
                                   [&](Index parent) { return Vector3d(columns.col(parent)); });
}

void append(VectorXd& values, std::span<const Heir> heirs) {
    Eigen::Index next = values.size();
    values.conservativeResize(next + static_cast<Eigen::Index>(heirs.size()));
    for (const Heir& heir : heirs)
        values[next++] = mean(heir.parents, 0.0, [&](Index parent) { return values[parent]; });
}

}  // namespace sherd
