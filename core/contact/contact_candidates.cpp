// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/contact_candidates.h"

#include <algorithm>

#include "core/contact/box_tree.h"
#include "core/contact/continuous_collision.h"

namespace sherd {
namespace {

constexpr double rounding = 1e-12;  // relative, far above that of any sum made here

/// Boxes around what each vertex can reach, half of its sheet's thickness included.
std::vector<Box> vertex_boxes(const ContactSurface& surface, const Positions& x, const Positions& motion,
                              double margin) {
    std::vector<Box> boxes(x.cols());
    for (Index v = 0; v < surface.vertices(); ++v) {
        const Eigen::Array3d from = x.col(v), to = x.col(v) + motion.col(v);
        const double size = from.abs().maxCoeff() + to.abs().maxCoeff();
        const double inflation = surface.half_thickness(v) + margin + rounding * size;
        boxes[v] = {from.min(to) - inflation, from.max(to) + inflation};
    }
    return boxes;
}

double margin_of(const ContactSurface& surface) {
    double thinnest = std::numeric_limits<double>::infinity();
    for (Index v = 0; v < surface.vertices(); ++v) thinnest = std::min(thinnest, surface.half_thickness(v));
    return 0.25 * thinnest;
}

}  // namespace

ContactCandidates::ContactCandidates(const ContactSurface& surface, const Positions& x,
                                     const Positions& motion)
    : start(x), motion(motion), margin(margin_of(surface)) {
    const std::vector<Box> vertices = vertex_boxes(surface, x, motion, margin);
    const BoxTree tree(vertices), triangles(element_boxes(vertices, surface.triangles()));
    const BoxTree edges(element_boxes(vertices, surface.edges()));
    tree.meet(triangles, [&](Index vertex, Index triangle) {
        if (!surface.apart(vertex, triangle)) add(surface.vertex_triangle(vertex, triangle));
    });
    edges.meet_itself([&](Index a, Index b) {
        if (!surface.edges_apart(a, b)) add(surface.edge_edge(std::min(a, b), std::max(a, b)));
    });
    std::sort(pair.begin(), pair.end(), [](const ContactPair& a, const ContactPair& b) {
        return a.kind != b.kind ? a.kind < b.kind : a.vertices < b.vertices;
    });
}

void ContactCandidates::add(const ContactPair& candidate) {
    const PairPositions from = pair_positions(start, candidate.vertices);
    const double nearer = approach(candidate.kind, pair_positions(motion, candidate.vertices)) + 2 * margin;
    const double size = from.cwiseAbs().maxCoeff() + nearer;
    if (distance(candidate, from) <= candidate.touching + nearer + rounding * size) pair.push_back(candidate);
}

bool ContactCandidates::cover(const Positions& x) const {
    if (x.cols() != start.cols()) return false;
    const double way = motion.squaredNorm();
    const double time = way > 0 ? std::clamp((x - start).cwiseProduct(motion).sum() / way, 0.0, 1.0) : 0;
    // Each vertex within the margin of the same moment of the motion.
    return ((x - start - time * motion).colwise().squaredNorm().array() <= margin * margin).all();
}

}  // namespace sherd
