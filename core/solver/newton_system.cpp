// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solver/newton_system.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/solver/linear/supernodes.h"

namespace sherd {
namespace {

/// Weights of the convex Hessian, blended with the exact one, that are tried until the matrix is positive
/// definite. For a sheet that buckles the exact Hessian is nearly definite, and the convex one, which leaves
/// out the softening by compression, is so much stiffer that iterations with it progress slowly.
constexpr std::array shares_of_convex{0.0, 0.25, 1.0};
constexpr int longest_wait = 16;
/// A pattern is rebuilt if fewer than the share `few_left` of its pairs in contact remain, and the number of
/// these pairs was more than the share `many_pairs` of the number of scalar rows.
constexpr double few_left = 0.5, many_pairs = 0.02;
/// Largest cost of a factorization in a kept elimination order, over the cost when the solver chose an order.
constexpr double most_growth = 1.1;

/// Extends an elimination order of vertices and `bodies` columns of bodies by inserted vertices, which take
/// the numbers after the other vertices and before the bodies: see with_children().
std::vector<Index> with_inserted(const std::vector<Index>& order, std::vector<Index> parents, Index bodies) {
    const auto vertices = static_cast<Index>(order.size()) - bodies,
               inserted = static_cast<Index>(parents.size());
    for (Index& parent : parents)
        if (parent >= vertices) parent += bodies;
    std::vector<Index> all = with_children(order, parents);
    for (Index& column : all)
        if (column >= vertices) column += column < vertices + bodies ? inserted : -bodies;
    return all;
}

}  // namespace

void NewtonSystem::analyze(const Potential& potential, const Positions& x) {
    matrix = potential.hessian_pattern(x);
    contact_pairs = potential.contacts(x).size();
    const Stopwatch watch(potential.time_spent(), Task::analysis);
    if (cost_of_own > 0 && keeps_order(potential.body_columns())) return;
    parents.clear();
    order.clear();
    solver->analyze(*matrix, order);
    cost_of_own = solver->cost().factorization;
}

bool NewtonSystem::keeps_order(Index body_columns) {
    std::vector<Index> kept = with_inserted(solver->order(), parents, body_columns);
    if (static_cast<int>(kept.size()) != matrix->size() / 3) return false;
    solver->analyze(*matrix, kept);
    if (solver->cost().factorization > most_growth * cost_of_own) return false;
    order = std::move(kept);
    parents.clear();
    return true;
}

void NewtonSystem::follow(const ShellChange& change) {
    for (const IndexWithParents& inserted : change.vertices)
        parents.push_back(inserted.parents.empty() ? 0 : inserted.parents.front().element);
}

void NewtonSystem::topology_changed(const ShellChange& change, const Potential& potential,
                                    const Positions& x) {
    follow(change);
    analyze(potential, x);
}

void NewtonSystem::fit_pattern(const Potential& potential, const Positions& x) {
    if (!matrix) analyze(potential, x);
    const std::vector<std::pair<Index, Index>> pairs = potential.contacts(x);
    if (pairs.empty() && contact_pairs == 0) return;
    const Stopwatch watch(potential.time_spent(), Task::contact);
    const bool fits =
        std::ranges::all_of(pairs, [&](const auto& pair) { return matrix->has(pair.first, pair.second); });
    const bool is_worn = static_cast<double>(contact_pairs) > many_pairs * matrix->size() &&
                         static_cast<double>(pairs.size()) < few_left * static_cast<double>(contact_pairs);
    if (!fits || is_worn) analyze(potential, x);
}

bool NewtonSystem::has_factor(const Potential& potential) {
    const Stopwatch watch(potential.time_spent(), Task::factorization);
    return solver->factorize(*matrix);
}

bool NewtonSystem::has_factor(const Potential& potential, const Positions& x, int number, bool is_exact) {
    const double convex = shares_of_convex[number];
    if (convex < 1 && !is_exact) potential.hessian(x, Curvature::exact, *matrix);
    if (convex > 0) {
        const std::vector<double> exact(matrix->values().begin(), matrix->values().end());
        potential.hessian(x, Curvature::convex, *matrix);
        if (convex < 1) matrix->blend(exact, matrix->values(), convex);
    }
    return has_factor(potential);
}

void NewtonSystem::factorize(const Potential& potential, const Positions& x) {
    fit_pattern(potential, x);
    const bool lowers = share > 0 && ++tried >= wait;
    if (lowers) --share, tried = 0;
    for (bool first = true; share < static_cast<int>(shares_of_convex.size()); ++share, first = false) {
        const bool is_exact = !first && shares_of_convex[share - 1] == 0;
        if (!has_factor(potential, x, share, is_exact)) continue;
        if (first && lowers) wait = 1;
        if (!first) {  // the failed attempt wasted a factorization: wait longer before the next lower share
            wait = std::min(2 * wait, longest_wait);
            tried = 0;
        }
        return;
    }
    share = 0;
    throw IndefiniteMatrix("Newton's method: the convex Hessian is not positive definite");
}

Positions NewtonSystem::solve(const Potential& potential, const Positions& right_side) {
    const Stopwatch watch(potential.time_spent(), Task::solution);
    return solver->solve(right_side.reshaped()).reshaped(3, right_side.cols());
}

void NewtonSystem::visit_state(StateVisitor& visit) {
    auto& [matrix, solver, share, tried, wait, parents, order, cost_of_own, contact_pairs] = *this;
    bool known = matrix.has_value();
    visit(known, share, tried, wait, parents, order, cost_of_own, contact_pairs);
    if (visit.reads()) matrix.reset();
    if (!known) return;
    if (!matrix) matrix.emplace(0, std::vector<std::pair<Index, Index>>(), std::vector<char>());
    visit(*matrix);
    if (visit.reads()) solver->analyze(*matrix, order);
}

void NewtonSystem::visit_factor(StateVisitor& visit) {
    matrix->visit_values(visit);
    if (visit.reads()) solver->factorize(*matrix);
}

}  // namespace sherd
