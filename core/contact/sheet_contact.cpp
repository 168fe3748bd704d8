// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/sheet_contact.h"

#include <stdexcept>
#include <string>

#include "core/contact/continuous_collision.h"

namespace sherd {

void SheetContact::surface_changed() {
    surface = ContactSurface(sheet);
    found = {};
}

const std::vector<ContactPair>& SheetContact::candidates(const Positions& x, const Positions& motion) const {
    if (!found.cover(x) || !found.cover(x + motion)) found = ContactCandidates(surface, x, motion);
    return found.pairs();
}

const std::vector<ContactPair>& SheetContact::candidates(const Positions& x) const {
    if (!found.cover(x)) found = ContactCandidates(surface, x, Positions::Zero(3, x.cols()));
    return found.pairs();
}

double SheetContact::value(const Positions& x) const {
    double sum = 0;
    for (const ContactPair& pair : candidates(x)) sum += sherd::value(pair, pair_positions(x, pair.vertices));
    return sum;
}

void SheetContact::add_gradient(const Positions& x, Positions& gradient) const {
    for (const ContactPair& pair : candidates(x)) {
        const PairPositions local = sherd::gradient(pair, pair_positions(x, pair.vertices));
        for (int i = 0; i < 4; ++i) gradient.col(pair.vertices[i]) += local.col(i);
    }
}

void SheetContact::add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const {
    for (const ContactPair& pair : touching(x))
        add_element(hessian, pair.vertices,
                    sherd::hessian(pair, pair_positions(x, pair.vertices), curvature == Curvature::convex));
}

void SheetContact::add_contacts(const Positions& x, bool ahead,
                                std::vector<std::pair<Index, Index>>& pairs) const {
    for (const ContactPair& pair : candidates(x)) {
        const double near = ahead ? 1.5 * pair.touching : pair.touching;
        if (distance(pair, pair_positions(x, pair.vertices)) < near) add_pairs(pairs, pair.vertices);
    }
}

double SheetContact::safe_fraction(const Positions& x, const Positions& motion) const {
    double fraction = 1;
    for (const ContactPair& pair : candidates(x, motion)) {
        const PairPositions local = pair_positions(motion, pair.vertices);
        fraction *= sherd::safe_fraction(pair.kind, pair_positions(x, pair.vertices), fraction * local,
                                         pair.minimum(), 0.5 * pair.barrier().range);
    }
    return fraction;
}

std::vector<ContactPair> SheetContact::touching(const Positions& x) const {
    std::vector<ContactPair> pairs;
    for (const ContactPair& pair : candidates(x))
        if (distance(pair, pair_positions(x, pair.vertices)) < pair.touching) pairs.push_back(pair);
    return pairs;
}

void SheetContact::require_apart(const Positions& x) const {
    for (const ContactPair& pair : touching(x)) {
        const double apart = distance(pair, pair_positions(x, pair.vertices));
        if (apart > pair.minimum()) continue;
        std::string vertices;
        for (const Index vertex : pair.vertices) vertices += " " + std::to_string(vertex);
        throw std::runtime_error(
            std::string("contact: ") +
            (pair.kind == PairKind::edge_edge ? "the edges of vertices"
                                              : "a vertex and the triangle of vertices") +
            vertices + " are " + std::to_string(apart) + " m apart, which must be more than " +
            std::to_string(pair.minimum()) + " m; move the sheets apart, or make them thinner");
    }
}

}  // namespace sherd
