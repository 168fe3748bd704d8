// SPDX-License-Identifier: GPL-3.0-or-later
// The search for the optimal poses of body_contact.h, along collision-free motions.
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "core/contact/bodies/body_contact.h"

namespace sherd {
namespace {

constexpr int most_iterations = 100, most_halvings = 40, most_hidden_halvings = 2;
constexpr double round_off_of_value = 1e-12;
/// rad; if a correction turns a body farther, a bound on the second derivatives of rotations is added to the
/// Gauss-Newton Hessian, which leaves them out.
constexpr double large_turn = 0.1;
/// Share of the potential by which another step of Newton's method may still lower it where poses count as
/// optimal.
constexpr double still_to_gain = 1e-9;
/// Corrections that count as zero, in sizes of a body and rad: the potential of a body of almost no mass is
/// all round-off.
constexpr double small_way = 1e-6;

}  // namespace

void BodyContact::move_with_colliders() {
    std::vector<Eigen::Isometry3d> start, end;
    for (std::size_t c = 0; c < steps.size() + obstacles.size(); ++c) {
        start.push_back(start_of(c));
        end.push_back(is_free(c) ? start_of(c) : obstacle_places[c - steps.size()]);
    }
    const auto ends = [&](const SurfacePairs& pair) { return PairPlaces{end[pair.body], end[pair.other]}; };
    const auto meet = [&](const SurfacePairs& pair) {
        return pair.free_fraction(start_of(pair), ends(pair)) < 1;
    };
    const auto moves = [&](std::size_t one, const Eigen::Isometry3d& along) {
        if (along.matrix() == end[one].matrix()) return false;
        end[one] = along;
        return true;
    };
    const auto pushed = [&](std::size_t one, std::size_t by) {
        if (!is_free(one) || end[by].matrix() == start[by].matrix()) return false;
        return moves(one, end[by] * start[by].inverse() * start[one]);
    };
    const auto pushed_by_deforming = [&](const SurfacePairs& pair) {
        if (!pair.other_deforms()) return false;
        const PairPlaces stays{start[pair.body], end[pair.other]};
        return moves(pair.body,
                     Eigen::Translation3d(pair.push_displacement(start_of(pair), stays)) * start[pair.body]);
    };
    // A body that is pushed may push others, in chains of at most all bodies.
    bool any = true;
    for (std::size_t i = 0; any && i <= steps.size(); ++i) {
        any = false;
        for (const auto& pair : surfaces)
            if (meet(*pair))
                any |= pushed_by_deforming(*pair) || pushed(pair->body, pair->other) ||
                       (end[pair->body].matrix() != start[pair->body].matrix() &&
                        pushed(pair->other, pair->body));
    }
    for (std::size_t b = 0; b < steps.size(); ++b) {
        if (end[b].matrix() == start[b].matrix()) continue;
        const Eigen::AngleAxisd turn(end[b].linear() * start[b].linear().transpose());
        base.segment<6>(6 * b) << end[b].translation() - start[b].translation(), turn.angle() * turn.axis();
    }
    is_blocked |= std::ranges::any_of(surfaces, [&](const auto& pair) { return meet(*pair); });
    for (std::size_t b = 0; b < steps.size(); ++b)
        if (!part(base, b).isZero(0))
            is_blocked |= steps[b].free_fraction(shell.position, Vector6d::Zero(), part(base, b)) < 1;
}

double BodyContact::free_fraction(const Positions& x, const VectorXd& from, const VectorXd& to) const {
    double fraction = 1;
    for (std::size_t b = 0; b < steps.size(); ++b)
        fraction = std::min(fraction, steps[b].free_fraction(x, part(from, b), part(to, b)));
    if (surfaces.empty()) return fraction;
    const std::vector<BodyPose> before = poses(from), after = poses(to);
    for (const auto& pair : surfaces)
        fraction = std::min(fraction, pair->free_fraction(places_of(*pair, before), places_of(*pair, after)));
    return fraction;
}

void BodyContact::moved_to(const Positions& x) {
    solve(x);
    base = best;
}

double BodyContact::safe_fraction(const Positions& x, const Positions& motion) const {
    solve(x);
    double fraction = 1;
    for (std::size_t b = 0; b < steps.size(); ++b)
        fraction = std::min(fraction, steps[b].free_motion(x, motion, part(best, b)));
    return fraction;
}

VectorXd BodyContact::correction() const {
    VectorXd newton = -at_best.hessian.ldlt().solve(at_best.gradient);
    double most = 0;
    for (std::size_t b = 0; b < steps.size(); ++b) most = std::max(most, part(newton, b).tail<3>().norm());
    if (most <= large_turn) return newton;
    Eigen::MatrixXd stiffer = at_best.hessian;
    for (std::size_t b = 0; b < steps.size(); ++b)
        stiffer.diagonal().segment<3>(6 * b + 3).array() += at_best.turning[b];
    return -stiffer.ldlt().solve(at_best.gradient);
}

bool BodyContact::improve(const Positions& x) const {
    VectorXd direction = correction();
    const double slope = direction.dot(at_best.gradient);
    for (int halving = 0; halving < most_halvings; ++halving, direction /= 2) {
        if (best + direction == best) return false;
        if (const double fraction = free_fraction(x, best, best + direction); fraction < 1) {
            // The bodies rotate, so a pose part of the way is not on the line between the positions checked;
            // it needs a check of its own.
            direction *= 2 * 0.9 * fraction;
            continue;
        }
        Potential trial = potential(x, best + direction);
        const double change = trial.value - at_best.value;
        // Where round-off hides the decrease, a step that flattens the slope is accepted, too.
        const bool hidden = std::abs(change) <= round_off_of_value * std::abs(at_best.value);
        const bool flatter =
            std::abs(direction.dot(trial.gradient)) <= 0.5 * std::abs(direction.dot(at_best.gradient));
        if (hidden && !flatter && halving >= most_hidden_halvings) return false;
        if (hidden ? !flatter : change > 0) continue;
        best += direction;
        at_best = std::move(trial);
        return slope < 0;
    }
    return false;
}

const BodyContact::Potential& BodyContact::solve(const Positions& x) const {
    if (last.cols() == x.cols() && last == x) return at_best;
    best = base;
    at_best = potential(x, best);
    for (int i = 0; i < most_iterations && improve(x); ++i) {
    }
    last = x;
    return at_best;
}

bool BodyContact::is_small(const VectorXd& correction) const {
    for (std::size_t b = 0; b < steps.size(); ++b) {
        const Vector6d own = part(correction, b);
        const double size = started[b].shape->bounds().diagonal().norm();
        if (!(own.head<3>().norm() <= small_way * size && own.tail<3>().norm() <= small_way)) return false;
    }
    return true;
}

bool BodyContact::have_optimal_poses(const Positions& x) const {
    const Potential& here = solve(x);
    const VectorXd correction = here.hessian.ldlt().solve(here.gradient);
    const bool is_best = here.gradient.dot(correction) <= still_to_gain * std::abs(here.value);
    return is_best || is_small(correction);
}

bool BodyContact::passes(const StepContext& step, const Positions& x) const {
    solve(x);
    for (std::size_t b = 0; b < steps.size(); ++b)
        if (steps[b].passes(x, part(best, b))) return true;
    return std::ranges::any_of(surfaces, [&](const auto& pair) { return passes(step, *pair); });
}

bool BodyContact::passes(const StepContext& step, const SurfacePairs& pair) const {
    const auto turn_of = [&](std::size_t one) {
        return is_free(one) ? part(best, one).tail<3>().norm()
                            : obstacles[one - steps.size()].motion.turn_between(step.begin, step.end());
    };
    const auto place_of = [&](std::size_t one, double share) {
        return is_free(one) ? steps[one].pose(share * part(best, one)).place
                            : obstacles[one - steps.size()].motion.at(step.begin + share * step.length);
    };
    // The shape of a deforming surface is available at both ends only.
    const int parts = pair.other_deforms() ? 1 : straight_parts(turn_of(pair.body) + turn_of(pair.other));
    PairPlaces before = start_of(pair);
    for (int part = 1; part <= parts; ++part) {
        const double share = static_cast<double>(part) / parts;
        const PairPlaces after{place_of(pair.body, share), place_of(pair.other, share)};
        if (pair.pass_between(before, after)) return true;
        before = after;
    }
    return false;
}

bool BodyContact::have_straight_paths(const Positions& x, const VectorXd& q, double widths,
                                      double widths_in_collider) const {
    for (std::size_t b = 0; b < steps.size(); ++b)
        if (!steps[b].has_straight_path(x, part(q, b), widths)) return false;
    const std::vector<BodyPose> end = poses(q);
    return std::ranges::all_of(surfaces, [&](const auto& pair) {
        return pair->has_straight_path(start_of(*pair), places_of(*pair, end), widths_in_collider);
    });
}

}  // namespace sherd
