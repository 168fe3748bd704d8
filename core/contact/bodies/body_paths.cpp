// SPDX-License-Identifier: GPL-3.0-or-later
// Member functions of BodyContact (body_contact.h) that limit motions of bodies to parts free of collisions.
#include <algorithm>

#include "core/contact/bodies/body_contact.h"

namespace sherd {
namespace {

/// Limits, in widths (smallest extents) of a body, on the distance of its predicted pose beyond the first
/// contact with a sheet, and with another collider. The second limit is small because contact points would
/// push the body out of the collider on the nearest side, which may be the wrong one.
constexpr double most_widths = 8, most_widths_in_collider = 0.25;
/// When only a part of a motion is found free, the motion is shortened to this share of that part and checked
/// again, up to most_checks times.
constexpr double share_of_free = 0.9;
constexpr int most_checks = 40;

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
    // A body that is pushed may push other bodies; a chain of pushes contains each body at most once.
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
        Vector6d motion;
        motion << end[b].translation() - start[b].translation(), turn.angle() * turn.axis();
        at.middleCols<2>(static_cast<Eigen::Index>(2 * b)) = steps[b].columns(motion);
    }
    is_blocked |= std::ranges::any_of(surfaces, [&](const auto& pair) { return meet(*pair); });
    for (std::size_t b = 0; b < steps.size(); ++b) {
        if (placed(b).isZero(0)) continue;
        const BodyPose from = steps[b].pose(BodyColumns::Zero()), to = steps[b].pose(placed(b));
        is_blocked |= turn_of(b, at) > largest_turn ||
                      steps[b].free_fraction(shell.position, from, shell.position, to) < 1;
    }
}

double BodyContact::turn_of(std::size_t body, const Positions& columns) const {
    const auto first = columns.cols() - static_cast<Eigen::Index>(2 * (steps.size() - body));
    return steps[body].motion(columns.middleCols<2>(first)).tail<3>().norm();
}

double BodyContact::largest_turn_in(const Positions& motion) const {
    double most = 0;
    for (std::size_t b = 0; b < steps.size(); ++b) most = std::max(most, turn_of(b, motion));
    return most;
}

double BodyContact::free_fraction_of_part(const Positions& x, const Positions& after) const {
    const Positions shell_here = shell_part(x), shell_there = shell_part(after);
    const std::vector<BodyPose> here = poses(x), there = poses(after);
    double fraction = 1;
    for (std::size_t b = 0; b < steps.size(); ++b)
        fraction = std::min(fraction, steps[b].free_fraction(shell_here, here[b], shell_there, there[b]));
    for (const auto& pair : surfaces_of_step())
        fraction = std::min(fraction, pair->free_fraction(places_of(*pair, here), places_of(*pair, there)));
    return fraction;
}

double BodyContact::free_fraction(const Positions& x, const Positions& motion) const {
    // In the frame of a body that turns, the path of the shell is curved; short parts of it are nearly
    // straight.
    const int parts = straight_parts(largest_turn_in(motion));
    Positions before = x;
    for (int part = 0; part < parts; ++part) {
        const Positions after = x + (part + 1.0) / parts * motion;
        if (const double fraction = free_fraction_of_part(before, after); fraction < 1)
            return (part + fraction) / parts;
        before = after;
    }
    return 1;
}

double BodyContact::checked_fraction(const Positions& x, const Positions& motion) const {
    if (largest_turn_in(motion) == 0) return free_fraction(x, motion);
    double share = 1;
    for (int check = 0; check < most_checks; ++check) {
        const double fraction = free_fraction(x, share * motion);
        if (fraction == 1) return share;
        // A rotating body's poses in the shortened motion differ from the straight path that was checked, so
        // that the shortened motion needs another check.
        share *= share_of_free * fraction;
    }
    return 0;
}

double BodyContact::safe_fraction(const Positions& x, const Positions& motion) const {
    const double turn = largest_turn_in(motion), share = turn > largest_turn ? largest_turn / turn : 1;
    return share * checked_fraction(x, share * motion);
}

void BodyContact::predict(const Positions& x) {
    const Positions from = with_bodies(x);
    Positions motion = Positions::Zero(3, from.cols());
    for (std::size_t b = 0; b < steps.size(); ++b)
        motion.middleCols<2>(first_column(b)) = prediction(b) - placed(b);
    at += checked_fraction(from, motion) * motion.rightCols(at.cols());
}

bool BodyContact::passes(const StepContext& step, const Positions& x) const {
    for (std::size_t b = 0; b < steps.size(); ++b)
        if (steps[b].passes(x, placed(b))) return true;
    return std::ranges::any_of(surfaces, [&](const auto& pair) { return passes(step, *pair); });
}

bool BodyContact::passes(const StepContext& step, const SurfacePairs& pair) const {
    const auto turn = [&](std::size_t one) {
        return is_free(one) ? turn_of(one, at)
                            : obstacles[one - steps.size()].motion.turn_between(step.begin, step.end());
    };
    const auto place_of = [&](std::size_t one, double share) {
        return is_free(one) ? steps[one].pose(share * placed(one)).place
                            : obstacles[one - steps.size()].motion.at(step.begin + share * step.length);
    };
    // The shape of a deforming surface is known only at the beginning and at the end of the step.
    const int parts = pair.other_deforms() ? 1 : straight_parts(turn(pair.body) + turn(pair.other));
    PairPlaces before = start_of(pair);
    for (int part = 1; part <= parts; ++part) {
        const double share = static_cast<double>(part) / parts;
        const PairPlaces after{place_of(pair.body, share), place_of(pair.other, share)};
        if (pair.pass_between(before, after)) return true;
        before = after;
    }
    return false;
}

bool BodyContact::have_straight_paths(const Positions& x) const {
    Positions ahead(3, at.cols());
    for (std::size_t b = 0; b < steps.size(); ++b) {
        if (!steps[b].has_straight_path(x, prediction(b), most_widths)) return false;
        ahead.middleCols<2>(static_cast<Eigen::Index>(2 * b)) = prediction(b);
    }
    const std::vector<BodyPose> end = poses(ahead);
    return std::ranges::all_of(surfaces, [&](const auto& pair) {
        return pair->has_straight_path(start_of(*pair), places_of(*pair, end), most_widths_in_collider);
    });
}

}  // namespace sherd
