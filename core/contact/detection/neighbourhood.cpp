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
    const Eigen::Index first = skip ? colliders : 0;
    const Vector3d mean = colliders > 0 ? Vector3d::Zero() : Vector3d((x - start).rowwise().mean());
    const auto moved = [&](Eigen::Index v) -> Vector3d { return x.col(v) - start.col(v) - mean; };
    double way = 0, along = 0;
    for (Eigen::Index v = first; v < x.cols(); ++v) {
        way += motion.col(v).squaredNorm();
        along += moved(v).dot(motion.col(v));
    }
    const double time = way > 0 ? std::clamp(along / way, 0.0, 1.0) : 0;
    const double limit = std::max(0.0, margin - spare);
    for (Eigen::Index v = first; v < x.cols(); ++v)
        if (!((moved(v) - time * motion.col(v)).squaredNorm() <= limit * limit)) return false;
    return true;
}

bool Neighbourhood::contains(const Neighbourhood& other) const {
    return contains(other.start, other.margin) && contains(other.start + other.motion, other.margin);
}

}  // namespace sherd
