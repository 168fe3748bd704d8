// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/sheet_contact.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/contact/continuous_collision.h"

namespace sherd {
namespace {

/// A distance that the pair is not nearer than, m: that of boxes around the elements.
double distance_of_boxes(PairKind kind, const PairPositions& x) {
    const int first = vertices_of_first(kind);
    const auto one = x.leftCols(first), other = x.rightCols(4 - first);
    const Vector3d above = one.rowwise().minCoeff() - other.rowwise().maxCoeff();
    const Vector3d below = other.rowwise().minCoeff() - one.rowwise().maxCoeff();
    return std::max(above.maxCoeff(), below.maxCoeff());
}

/// Whether the pair is nearer than `limit`, m.
bool within(double limit, const ContactPair& pair, const Positions& x) {
    const PairPositions local = pair_positions(x, pair.vertices);
    return distance_of_boxes(pair.kind, local) < limit && distance(pair, local) < limit;
}

/// By which vertices may depart from the motion until candidates are looked for again, in half thicknesses of
/// the thinnest sheet: where the sheet is going to be for some time, and in one step.
constexpr double margin_of_all = 0.5, margin_of_step = 0.1;

/// How many steps like this one to look for candidates for, unless they lead far. motion: less its mean, m.
double lookahead(const Positions& motion, double unit) {
    return std::clamp(12 * unit / motion.colwise().norm().maxCoeff(), 1.0, 10.0);
}

double thinnest_half(const ContactSurface& surface) {
    double thinnest = std::numeric_limits<double>::infinity();
    for (Index v = 0; v < surface.vertices(); ++v) thinnest = std::min(thinnest, surface.half_thickness(v));
    return thinnest;
}

}  // namespace

void SheetContact::surface_changed() {
    const ContactSurface before = std::exchange(surface, ContactSurface(sheet));
    found.follow(before, surface);
    near = {};
    last.resize(3, 0);
}

const std::vector<ContactPair>& SheetContact::candidates(const Positions& x, const Positions& motion) const {
    if (near.contains(x) && near.contains(x + motion)) return pairs;
    const double unit = thinnest_half(surface);
    near = Neighbourhood(x, motion, margin_of_step * unit);
    if (!found.neighbourhood().contains(near))
        found = ContactCandidates(
            surface, Neighbourhood(x, lookahead(near.motion, unit) * motion, margin_of_all * unit));
    pairs = found.pick(surface, near);
    return pairs;
}

double SheetContact::value(const Positions& x) const {
    double sum = 0;
    for (const ContactPair& pair : touching(x)) sum += sherd::value(pair, pair_positions(x, pair.vertices));
    return sum;
}

void SheetContact::add_gradient(const Positions& x, Positions& gradient) const {
    for (const ContactPair& pair : touching(x)) {
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
    for (const ContactPair& pair : ahead ? candidates(x, Positions::Zero(3, x.cols())) : touching(x))
        if (!ahead || within(ContactCandidates::nearness * pair.touching, pair, x))
            add_pairs(pairs, pair.vertices);
}

double SheetContact::safe_fraction(const Positions& x, const Positions& motion) const {
    double fraction = 1;
    for (const ContactPair& pair : candidates(x, motion)) {
        const PairPositions from = pair_positions(x, pair.vertices);
        const PairPositions way = fraction * pair_positions(motion, pair.vertices);
        const double clearance = 0.5 * pair.barrier().range, kept = pair.minimum() + clearance;
        if (distance_of_boxes(pair.kind, from) < kept + approach(pair.kind, way))
            fraction *= sherd::safe_fraction(pair.kind, from, way, pair.minimum(), clearance);
    }
    return fraction;
}

const std::vector<ContactPair>& SheetContact::touching(const Positions& x) const {
    if (last.cols() == x.cols() && last == x) return active;
    active.clear();
    for (const ContactPair& pair : candidates(x, Positions::Zero(3, x.cols())))
        if (within(pair.touching, pair, x)) active.push_back(pair);
    last = x;
    return active;
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
