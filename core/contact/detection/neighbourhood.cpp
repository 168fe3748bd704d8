// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/detection/neighbourhood.h"

#include <algorithm>

namespace sherd {
namespace {

// Relative errors of any distance: a bound, and the larger value that is allowed for, so that positions may
// grow.
constexpr double rounding_at_least = 1e-14, rounding = 1e-12;

Positions less_mean(const Positions& motion) {
    const Vector3d mean = motion.rowwise().mean();  // evaluated once, not for every column
    return motion.colwise() - mean;
}

}  // namespace

Neighbourhood::Neighbourhood(const Positions& x, const Positions& motion, double margin, Index colliders)
    : start(x),
      motion(colliders > 0 ? motion : less_mean(motion)),
      margin(margin),
      colliders(colliders),
      colliders_rest(motion.leftCols(colliders).isZero(0)) {
    round_off = rounding * ((start.cwiseAbs() + this->motion.cwiseAbs()).maxCoeff() + margin);
}

bool Neighbourhood::contains(const Positions& x, double spare) const {
    if (x.cols() != start.cols() || rounding_at_least * x.cwiseAbs().maxCoeff() > round_off) return false;
    const bool skip = colliders_rest && x.leftCols(colliders) == start.leftCols(colliders);
    const auto looked_at = [&](const Positions& all) {
        return all.rightCols(all.cols() - (skip ? colliders : 0));
    };
    const Positions difference = looked_at(x) - looked_at(start);
    const Positions moved = colliders > 0 ? difference : less_mean(difference);
    const auto along_motion = looked_at(motion);
    const double way = along_motion.squaredNorm(), along = moved.cwiseProduct(along_motion).sum();
    const double time = way > 0 ? std::clamp(along / way, 0.0, 1.0) : 0;
    const double limit = std::max(0.0, margin - spare);
    return ((moved - time * along_motion).colwise().squaredNorm().array() <= limit * limit).all();
}

bool Neighbourhood::contains(const Neighbourhood& other) const {
    return contains(other.start, other.margin) && contains(other.start + other.motion, other.margin);
}

}  // namespace sherd
