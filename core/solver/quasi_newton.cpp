// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solver/quasi_newton.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/shell/mean_edge_length.h"
#include "core/shell/pieces.h"
#include "core/solver/potential.h"

namespace sherd {
namespace {

/// Share of the sum of contact forces on a piece, below which their resultant is round-off.
constexpr double outer_force = 1e-9;

/// Changes the last correction of a step so that the linear momentum of each group of loose pieces and bodies
/// in contact with each other changes by loads and mass damping alone; with an approximate inverse Hessian it
/// has an error. Groups that are held, or touch an obstacle, or would move by more than `tolerance` (m), are
/// left as they are. gradient: N, at x.
void conserve_momentum(const Potential& potential, const Positions& x, const Positions& gradient,
                       double tolerance, Positions& correction) {
    const double hessian_per_mass = potential.hessian_per_mass();
    if (hessian_per_mass == 0) return;
    const Shell& shell = potential.mechanics();
    const Pieces all = pieces(shell, potential.contacts(x), potential.body_columns());
    const Positions contact = potential.contact_gradient(x);
    const VectorXd masses = potential.masses();
    std::vector<char> is_held(all.count, 0);
    VectorXd mass = VectorXd::Zero(all.count), touch = mass;
    Positions lacking = Positions::Zero(3, all.count), outer = lacking;
    for (Index v = 0; v < static_cast<Index>(x.cols()); ++v) {
        if (masses[v] == 0) continue;
        const Index piece = all.of_vertex[v];
        if (v < shell.mass.size() && (shell.fixed[v] || shell.guide[v])) is_held[piece] = 1;
        mass[piece] += masses[v];
        touch[piece] += contact.col(v).norm();
        outer.col(piece) += contact.col(v);
        lacking.col(piece) -= gradient.col(v) / hessian_per_mass + masses[v] * correction.col(v);
    }
    const Positions shift = lacking * mass.cwiseInverse().asDiagonal();
    for (Index piece = 0; piece < all.count; ++piece)
        if (outer.col(piece).norm() > outer_force * touch[piece] ||
            !(shift.col(piece).cwiseAbs().maxCoeff() <= tolerance))
            is_held[piece] = 1;
    for (Index v = 0; v < static_cast<Index>(x.cols()); ++v)
        if (masses[v] > 0 && !is_held[all.of_vertex[v]]) correction.col(v) += shift.col(all.of_vertex[v]);
}

/// Number of iterations that take about as long as an iteration of Newton's method.
constexpr int per_newton_iteration = 4;
/// The slope at the beginning of a step is negative. A step is not too long if the slope at its end is
/// negative, or positive and at most this share of the size of the slope at the beginning: on a parabola such
/// a step lowers the potential (Hager, Zhang 2005, the approximate Wolfe conditions, which are not affected
/// by round-off of the potential).
constexpr double steepest_end = 0.8;
constexpr int most_trials = 30;
/// After a longer step that was too long, a step is not too short if the size of the slope has fallen to the
/// share `least_end` of its size at the beginning, or if the two steps differ by less than the share
/// `narrow`, or after `enough_trials` trials.
constexpr double least_end = 0.5, narrow = 0.2;
constexpr int enough_trials = 4;
/// Share of the slope at the beginning of a step: as long as the slope is steeper, the step has met no
/// contact.
constexpr double nothing_met = 0.9;
/// Largest coordinate of a motion, over the mean edge length, up to which a correction is followed before the
/// slope is evaluated for the first time: contact detection takes more time for longer motions, and most
/// longer corrections are wrong.
constexpr double share_of_edge = 0.1;
/// Number of iterations that a search typically takes with a new factor; and multiple of the cost of a
/// factorization that a search may spend on iterations before it gets a new factor, however fast its
/// corrections fall.
constexpr double typical_with_new_factor = 2, most_with_a_factor = 6;
/// The first corrections with a factor do not show yet how fast corrections fall, unless a correction is far
/// too long: the line search accepts less than the share `far_too_long` of it.
constexpr int first_corrections = 3;
constexpr double far_too_long = 0.5;
/// If the second correction with a new factor is far too long, the Hessian changes as fast as the sheet
/// moves. Each correction then gets a new factor until a correction is below this share of the one before.
constexpr double falls_fast = 0.2;
/// If the first correction with an old factor is far too long, the next searches begin with a new factor: at
/// most this number of searches.
constexpr int most_fresh_searches = 16;
/// Slowest rate (ratio of a correction to the one before) that is assumed. It is assumed until two
/// corrections of the same system are known. Later the slower one of the last two rates is assumed, since a
/// system that is too stiff makes small corrections.
constexpr double slowest_rate = 0.99;
/// Largest distance left to the minimum, over the tolerance; also the distance assumed to be left after a
/// correction with the Hessian at x, over this correction. Newton's method converges quadratically, so that
/// far less than the tolerance is left after its last correction; energy balances would show a larger
/// distance.
constexpr double may_be_left = 0.1;
/// A small correction shows that the minimum is near if it reduces the largest force to the share
/// `forces_fall`. Where the system has a far too stiff contact, corrections are small in any case, and halve
/// the contact force at best. Up to `most_more` corrections follow then, unless a correction is below the
/// share `share_of_round_off` of the tolerance, where only round-off is left.
constexpr double forces_fall = 0.3, share_of_round_off = 1e-3;
constexpr int most_more = 20;
/// Time of an iteration without its solution (mostly of the forces), and time to compute a Hessian, for each
/// vertex, in the unit of FactorCost.
constexpr double entries_of_forces = 1000, entries_of_hessian = 2500;

/// A point along a correction.
struct Place {
    double scale = 0;  ///< share of the correction
    double slope = 0;  ///< J, derivative of the potential along the correction
};

/// Returns the share of the correction to try between `near`, a point that is not too far, and `far`, a point
/// that is. farther: a point beyond `far`; none if its scale is 0. slope: J, at the beginning of the
/// correction.
double between(const Place& near, const Place& far, const Place& farther, double slope) {
    const double secant = std::isfinite(far.slope) ? near.slope / (near.slope - far.slope) : 0;
    const double safe = near.scale + (far.scale - near.scale) * std::clamp(secant, 0.1, 0.6);
    if (farther.scale == 0 || near.slope > nothing_met * slope) return safe;
    // A stiff contact begins between `near` and `far`. Beyond its beginning the slope is nearly linear, so
    // that `far` and `farther` show where it is zero.
    const double met = far.scale - far.slope * (farther.scale - far.scale) / (farther.slope - far.slope);
    return met > safe && met < far.scale ? met : safe;
}

}  // namespace

void QuasiNewton::topology_changed(const ShellChange& change, const Potential& potential, const Positions&) {
    system.topology_changed(change, potential.body_columns());
    fresh_searches = 0;  // a crack does not move the sheet, so that an old factor still fits
}

double QuasiNewton::iterations_per_factorization(const Potential& potential) const {
    const auto vertices = static_cast<double>(potential.mechanics().mass.size());
    return system.iterations_per_factorization(entries_of_hessian * vertices, entries_of_forces * vertices);
}

bool QuasiNewton::is_slow(const Potential& potential, const Search& search) const {
    if (search.exact) return false;
    const double affordable = iterations_per_factorization(potential);
    if (search.total > most_with_a_factor * (affordable + 1)) return true;
    if (search.last <= tolerance || search.rate <= 0) return false;
    if (search.iterations < first_corrections && !search.too_long) return false;
    const double ahead = std::log(search.last / tolerance) / -std::log(std::min(search.rate, slowest_rate));
    return ahead > affordable + typical_with_new_factor;
}

void QuasiNewton::factorize(const Potential& potential, const Positions& x, Search& search) {
    system.factorize(potential, x);
    search.updates.clear();
    search.iterations = search.total = 0;
    search.last = 0;
    search.exact = true;
    search.is_old = false;
    fewest = 0;
    spent = 0;
}

Positions QuasiNewton::correction(const Potential& potential, const Positions& x, Search& search,
                                  double& slope) {
    for (;;) {
        Positions direction = search.updates.apply(
            -search.gradient, [&](const Positions& one) { return system.solve(potential, one); });
        slope = direction.cwiseProduct(search.gradient).sum();
        if (slope < 0 || search.exact) return direction;
        factorize(potential, x, search);
    }
}

double QuasiNewton::left(const Positions& direction, Search& search) {
    const double now = direction.cwiseAbs().maxCoeff();
    const bool is_known = search.last > 0;
    const double rate = is_known ? now / search.last : 0;
    const double slower = is_known ? std::min(std::max(rate, search.rate), slowest_rate) : slowest_rate;
    search.rate = rate;
    search.last = now;
    // After a correction with the Hessian at x, the distance left is far smaller than the correction, as in
    // Newton's method.
    return search.exact ? may_be_left * now : now * std::max(1.0, slower / (1 - slower));
}

bool QuasiNewton::advance(const Potential& potential, const Positions& direction, double slope, Positions& x,
                          Search& search) {
    double limit = std::min(1.0, search.longest_move / direction.cwiseAbs().maxCoeff());
    double whole = limit * potential.safe_fraction(x, limit * direction);
    double scale = whole;
    Place near{0, slope}, far, farther;
    Positions gradient;  // gradient at `near`
    for (int trial = 0; trial < most_trials && scale > 0; ++trial) {
        Positions there = potential.gradient(x + scale * direction);
        const double end = there.cwiseProduct(direction).sum();
        const bool is_too_far = !(end <= -steepest_end * slope) && -slope > search.round_off;
        if (is_too_far) {
            farther = std::exchange(far, {scale, end});
        } else {
            near = {scale, end};
            gradient = std::move(there);
            if (far.scale == 0 && limit < 1 && whole == limit && end < least_end * slope) {
                limit = 1;
                scale = whole = std::max(near.scale, potential.safe_fraction(x, direction));
                continue;
            }
            // A step has to reach a contact that begins along it, instead of approaching the contact in ever
            // smaller steps.
            if (far.scale == 0 || end > least_end * slope || far.scale - near.scale < narrow * near.scale ||
                trial > enough_trials)
                break;
        }
        scale = between(near, far, farther, slope);
    }
    if (near.scale == 0) return false;
    search.updates.add(near.scale * direction, gradient - search.gradient);
    x += near.scale * direction;
    search.gradient = std::move(gradient);
    const double wanted = whole < limit ? whole : 1;
    search.too_long = near.scale < far_too_long * wanted;
    if (search.too_long)
        search.rate = std::max(search.rate, 1 - near.scale / wanted);
    else if (near.scale < 1)
        search.last = 0;
    search.exact = false;
    return true;
}

void QuasiNewton::begin(const Potential& potential, const Positions& x, Search& search) {
    search.gradient = potential.gradient(x);
    search.longest_move = share_of_edge * mean_edge_length(potential.mechanics());
    search.round_off = potential.round_off() + 1e-12 * std::abs(potential.value(x));
    search.is_old =
        system.has_factor() && fresh_searches == 0 && spent < iterations_per_factorization(potential);
    if (fresh_searches > 0) --fresh_searches;
    if (search.is_old)
        system.turn(potential, x);
    else
        factorize(potential, x, search);
}

void QuasiNewton::refit(const Potential& potential, const Positions& x, Search& search) {
    if (search.exact) return;
    if (search.always_factorize) return factorize(potential, x, search);
    const LaggedSystem::Fit fit = system.fit(potential, x);
    if (fit == LaggedSystem::Fit::needs_factor) factorize(potential, x, search);
    if (fit == LaggedSystem::Fit::patched) {
        search.updates.clear();
        search.last = 0;
        search.iterations = 0;
        // The last correction was too long because of a contact, which the patch now contains.
        search.too_long = false;
    }
    if (!is_slow(potential, search)) return;
    search.always_factorize = !search.is_old && search.too_long && search.total == 2;
    if (search.is_old && search.too_long && search.total == 1)
        fresh_searches = next_fresh_searches = std::min(2 * next_fresh_searches, most_fresh_searches);
    factorize(potential, x, search);
}

void QuasiNewton::end(const Search& search) {
    fewest = fewest == 0 ? search.iterations : std::min(fewest, search.iterations);
    spent += search.iterations - fewest;
    if (search.is_old) next_fresh_searches = 1;
}

void QuasiNewton::Search::assess_factor(double correction) {
    if (correction < falls_fast * last_exact) always_factorize = false;
    last_exact = correction;
}

MinimiserResult QuasiNewton::minimise(Potential& potential, int max_iterations, Positions& x) {
    MinimiserResult result;
    Search search;
    begin(potential, x, search);
    const int limit = max_iterations * per_newton_iteration;
    int more = 0;
    while (result.iterations < limit) {
        refit(potential, x, search);
        double slope = 0;
        Positions direction = correction(potential, x, search, slope);
        ++result.iterations;
        ++search.iterations;
        ++search.total;
        result.correction = direction.cwiseAbs().maxCoeff();
        const bool is_near = left(direction, search) <= may_be_left * tolerance;
        result.converged |= is_near;
        if (result.converged) conserve_momentum(potential, x, search.gradient, tolerance, direction);
        const bool was_exact = search.exact;
        const double force = search.gradient.cwiseAbs().maxCoeff();
        if (slope < 0 && advance(potential, direction, slope, x, search)) {
            if (is_near && (search.gradient.cwiseAbs().maxCoeff() <= forces_fall * force ||
                            result.correction <= share_of_round_off * tolerance))
                break;
            if (result.converged && ++more > most_more) break;
            if (was_exact) search.assess_factor(result.correction);
        } else if (result.converged || was_exact) {
            break;
        } else {
            factorize(potential, x, search);
        }
    }
    if (result.converged) end(search);
    result.limited = result.iterations >= limit && !result.converged;
    return result;
}

void QuasiNewton::visit_state(StateVisitor& visit) {
    auto& [tolerance, system, fewest, spent, fresh_searches, next_fresh_searches] = *this;
    visit(system, fewest, spent, fresh_searches, next_fresh_searches);
}

}  // namespace sherd
