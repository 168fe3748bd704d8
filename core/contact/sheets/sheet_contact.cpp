// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/sheets/sheet_contact.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace sherd {
namespace {

std::string message(const ContactSurface& surface, const ContactPair& pair, double apart) {
    std::string of_sheets, of_colliders;
    for (const Index vertex : pair.vertices)
        (surface.of_collider(vertex) ? of_colliders : of_sheets) +=
            " " + std::to_string(vertex - (surface.of_collider(vertex) ? 0 : surface.collider_vertices()));
    const std::string elements =
        pair.kind == PairKind::edge_edge ? "the edges of vertices" : "a vertex and the triangle of vertices";
    const std::string others = of_colliders.empty() ? "" : " and of an obstacle's" + of_colliders;
    return "contact: " + elements + of_sheets + others + " are " + std::to_string(apart) +
           " m apart, which must be more than " + std::to_string(pair.minimum()) +
           " m; move the sheets apart, or make them thinner";
}

}  // namespace

SheetContact::SheetContact(const Shell& shell, std::vector<Obstacle> given, bool sheets_meet, bool springs,
                           Threads team)
    : shell(shell),
      threads(std::move(team)),
      obstacles(std::move(given)),
      colliders(contact_colliders(shell, obstacles)),
      near(ContactSurface(shell, colliders, sheets_meet, springs), threads) {
    for (std::size_t i = 0; i < obstacles.size(); ++i)
        if (obstacles[i].surface) obstacle_of.push_back(i);
    start = end = collider_positions(obstacles, 0);
}

void SheetContact::begin(const StepContext& step) {
    if (std::ranges::none_of(obstacles, &Obstacle::moves)) return;
    start = collider_positions(obstacles, step.begin);
    end = collider_positions(obstacles, step.end());
}

void SheetContact::surface_changed(const ShellChange& change) {
    near.surface_changed(change,
                         ContactSurface(shell, colliders, surface().sheets_meet(), surface().has_springs()));
}

void SheetContact::topology_changed(const ShellChange& change, const StepContext& step) {
    surface_changed(change);
    begin(step);
}

const Positions& SheetContact::with(const Positions& collider, const Positions& x) const {
    if (collider.cols() == 0) return x;
    whole.resize(3, collider.cols() + x.cols());
    whole << collider, x;
    return whole;
}

SheetContact::Pairs SheetContact::pairs_at(const Positions& all) const {
    return {near.active_pairs(all), all, surface().collider_vertices()};
}

double SheetContact::value(const Positions& x) const {
    return sum_of_values(pairs_at(at_end(x)), x);
}

double SheetContact::stored_at_start() const {
    return sum_of_values(pairs_at(with(start, shell.position)), shell.position);
}

void SheetContact::add_gradient(const Positions& x, Positions& gradient) const {
    add_gradients(pairs_at(at_end(x)), x, gradient, threads);
}

void SheetContact::add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const {
    add_hessians(pairs_at(at_end(x)), x, curvature, hessian);
}

void SheetContact::add_contacts(const Positions& x, bool ahead,
                                std::vector<std::pair<Index, Index>>& pairs) const {
    near.add_contacts(at_end(x), ahead, pairs);
}

double SheetContact::safe_fraction(const Positions& x, const Positions& motion) const {
    if (end.cols() == 0) return near.safe_fraction(x, motion);
    Positions way(3, end.cols() + motion.cols());
    way << Positions::Zero(3, end.cols()), motion;
    return near.safe_fraction(at_end(x), way);
}

Positions SheetContact::with_colliders(const Positions& motion) const {
    Positions way(3, end.cols() + motion.cols());
    way << end - start, motion;
    return way;
}

double SheetContact::safe_fraction_of_step(const Positions& x, const Positions& motion) const {
    return near.safe_fraction(with(start, x), with_colliders(motion));
}

Positions SheetContact::push_displacement(const Positions& x) const {
    Positions pushed = Positions::Zero(3, x.cols());
    if (start == end) return pushed;
    Positions way = Positions::Zero(3, end.cols() + x.cols());
    way.leftCols(end.cols()) = end - start;
    const Index first = surface().collider_vertices();
    near.each_nearby(with(start, x), way, [&](const ContactPair& pair) {
        for (const Index of_collider : pair.vertices)
            for (const Index of_sheet : pair.vertices)
                if (of_collider < first && of_sheet >= first && way.col(of_collider).squaredNorm() > 0)
                    pushed.col(of_sheet - first) = way.col(of_collider);
    });
    return pushed;
}

std::optional<std::string> SheetContact::overlap(const Positions& x) const {
    const Positions& all = with(start, x);
    for (const ContactPair& pair : near.active_pairs(all)) {
        const double apart = distance(pair, columns(all, pair.vertices));
        if (!(apart > pair.minimum())) return message(surface(), pair, apart);
    }
    return std::nullopt;
}

bool SheetContact::passes(const StepContext& step, const Positions& x, const Positions& end_of_shell) const {
    double turn = 0;
    for (const Obstacle& obstacle : obstacles)
        turn = std::max(turn, obstacle.motion.turn_between(step.begin, step.end()));
    return near.passes_in_parts(straight_parts(turn), [&](double share) -> Positions {
        const Positions shell_then = x + share * (end_of_shell - x);
        if (share == 0 || share == 1) return with(share == 0 ? start : end, shell_then);
        return with(collider_positions(obstacles, step.begin + share * step.length), shell_then);
    });
}

}  // namespace sherd
