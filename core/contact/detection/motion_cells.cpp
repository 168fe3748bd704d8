// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/detection/motion_cells.h"

namespace sherd {
namespace {

/// Number of vertices in a cell: few, so that they move almost alike; more than one, so that the vertices of
/// a block of pairs are in few cells.
constexpr std::size_t cell_size = 48;

}  // namespace

void MotionCells::cover(const Positions& x) {
    const auto vertices = static_cast<std::size_t>(x.cols());
    if (cell.empty()) {
        std::vector<Box> places;
        for (std::size_t v = 0; v < vertices; ++v) places.push_back({x.col(v), x.col(v)});
        const BoxTree tree(places);
        cell.resize(vertices);
        for (std::size_t i = 0; i < vertices; ++i) cell[tree.order()[i]] = static_cast<Index>(i / cell_size);
        count = static_cast<Index>((vertices + cell_size - 1) / cell_size);
    }
    while (cell.size() < vertices) cell.push_back(count++);
}

std::vector<Box> MotionCells::boxes(const Positions& motions) const {
    std::vector<Box> boxes(count);
    for (std::size_t v = 0; v < cell.size(); ++v) boxes[cell[v]].include({motions.col(v), motions.col(v)});
    return boxes;
}

double spread(const Box& motions) {
    return (motions.upper - motions.lower).matrix().norm();
}

}  // namespace sherd
