// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/detection/collider_trees.h"

namespace sherd {
namespace {

template <std::size_t N>
BoxTree tree(const std::vector<std::array<Index, N>>& elements, Index from, Index to, Index first_vertex,
             const std::vector<Box>& of_vertices, BoxTree::Division& known) {
    std::vector<Box> boxes(to - from);
    for (Index i = from; i < to; ++i)
        for (const Index vertex : elements[i]) boxes[i - from].include(of_vertices[vertex - first_vertex]);
    return BoxTree(boxes, known);
}

Box box_around(const Positions& from, const Positions& to) {
    return {from.rowwise().minCoeff().cwiseMin(to.rowwise().minCoeff()),
            from.rowwise().maxCoeff().cwiseMax(to.rowwise().maxCoeff())};
}

}  // namespace

const ColliderTrees::Trees* ColliderTrees::within_reach(const Box& reach, std::size_t collider,
                                                        const ContactSurface& surface,
                                                        const Neighbourhood& within) {
    const ContactSurface::Start first = surface.collider_starts()[collider],
                                end = surface.collider_starts()[collider + 1];
    const Positions from = within.start.middleCols(first.vertex, end.vertex - first.vertex);
    const Positions to = from + within.motion.middleCols(first.vertex, end.vertex - first.vertex);
    if (from.cols() == 0 || !box_around(from, to).meets(reach)) return nullptr;
    while (cached.size() <= collider)
        cached.push_back({Positions(3, 0), Positions(3, 0), {BoxTree({}), BoxTree({}), BoxTree({})}, {}});
    Cached& known = cached[collider];
    if (known.from.cols() == from.cols() && known.from == from && known.to == to) return &known.trees;
    std::vector<Box> boxes;
    for (Eigen::Index v = 0; v < from.cols(); ++v)
        boxes.push_back(
            {from.col(v).array().min(to.col(v).array()), from.col(v).array().max(to.col(v).array())});
    auto& [points, edges, triangles] = known.divisions;
    known.trees = {
        BoxTree(boxes, points),
        tree(surface.collider_edges(), first.edge, end.edge, first.vertex, boxes, edges),
        tree(surface.collider_triangles(), first.triangle, end.triangle, first.vertex, boxes, triangles)};
    known.from = from;
    known.to = to;
    return &known.trees;
}

}  // namespace sherd
