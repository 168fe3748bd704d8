// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shell/inheritance.h"

#include <cmath>

namespace sherd {
namespace {

/// Weighted mean of `part(element)` over the parents; a single parent's value is copied exactly.
template <class Value, class Part>
Value mean(const std::vector<IndexWithParents::Parent>& parents, const Value& zero, Part part) {
    if (parents.size() == 1) return part(parents.front().element);
    Value sum = zero;
    for (const auto& [element, weight] : parents) sum += weight * part(element);
    return sum;
}

Vector3d mean_column(const std::vector<IndexWithParents::Parent>& parents, const Positions& columns) {
    return mean(parents, Vector3d(Vector3d::Zero()),
                [&](Index parent) { return Vector3d(columns.col(parent)); });
}

}  // namespace

void append(Positions& columns, std::span<const IndexWithParents> inserted) {
    Eigen::Index next = columns.cols();
    columns.conservativeResize(3, next + static_cast<Eigen::Index>(inserted.size()));
    for (const IndexWithParents& element : inserted)
        columns.col(next++) = mean_column(element.parents, columns);
}

void follow(Positions& of_vertices, const ShellChange& change) {
    std::vector<Vector3d> moved;  // computed from the parents' values before the change
    for (const IndexWithParents& vertex : change.moved)
        moved.push_back(mean_column(vertex.parents, of_vertices));
    append(of_vertices, change.vertices);
    for (std::size_t i = 0; i < moved.size(); ++i) of_vertices.col(change.moved[i].element) = moved[i];
}

void append(VectorXd& values, std::span<const IndexWithParents> inserted) {
    Eigen::Index next = values.size();
    values.conservativeResize(next + static_cast<Eigen::Index>(inserted.size()));
    for (const IndexWithParents& element : inserted)
        values[next++] = mean(element.parents, 0.0, [&](Index parent) { return values[parent]; });
}

void follow_around(std::vector<double>& of_edges, const ShellChange& change, double missing) {
    std::vector<double> crossing;  // computed from the values before the change
    for (const auto& [edge, around] : change.crossing) {
        double sum = 0;
        int count = 0;
        for (const Index other : around)
            if (std::isfinite(of_edges[other])) {
                sum += of_edges[other];
                ++count;
            }
        crossing.push_back(count > 0 ? sum / count : missing);
    }
    append(of_edges, change.edges, Inheritance::copies, missing);
    for (std::size_t i = 0; i < crossing.size(); ++i) of_edges[change.crossing[i].edge] = crossing[i];
}

void follow_moves(VectorXd& of_vertices, std::span<const IndexWithParents> moved) {
    const VectorXd before = of_vertices;
    for (const auto& [vertex, parents] : moved)
        of_vertices[vertex] = mean(parents, 0.0, [&](Index parent) { return before[parent]; });
}

}  // namespace sherd
