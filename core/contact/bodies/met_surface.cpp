// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/bodies/met_surface.h"

#include <cmath>
#include <utility>

namespace sherd {

MetSurface::MetSurface(const Collider& collider) : of(collider.surface) {
    for (const auto& point : of->points.colwise()) around.include({point, point});
}

MetSurface::MetSurface(const Obstacle& obstacle) : MetSurface(static_cast<const Collider&>(obstacle)) {
    deformation = obstacle.deformation;
    if (deforms()) before = now = of->points;
}

void MetSurface::move_to(double time) {
    if (!deforms()) return;
    before = std::exchange(now, deformation->at(time));
    around = {};
    for (const Positions* shape : {&before, &now})
        for (const auto& point : shape->colwise()) around.include({point, point});
}

Positions MetSurface::way_to(double time) const {
    return deforms() ? Positions(deformation->at(time) - now) : Positions(3, 0);
}

double MetSurface::longest_way() const {
    return deforms() ? std::sqrt((now - before).colwise().squaredNorm().maxCoeff()) : 0;
}

}  // namespace sherd
