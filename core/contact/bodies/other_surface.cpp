// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/bodies/other_surface.h"

#include <cmath>
#include <utility>

namespace sherd {

OtherSurface::OtherSurface(const Collider& collider) : of(collider.surface) {
    for (const auto& point : of->points.colwise()) around.include({point, point});
}

OtherSurface::OtherSurface(const Obstacle& obstacle) : OtherSurface(static_cast<const Collider&>(obstacle)) {
    deformation = obstacle.deformation;
    if (deforms()) before = now = of->points;
}

void OtherSurface::move_to(double time) {
    if (!deforms()) return;
    before = std::exchange(now, deformation->at(time));
    around = {};
    for (const Positions* shape : {&before, &now})
        for (const auto& point : shape->colwise()) around.include({point, point});
}

Positions OtherSurface::displacement_to(double time) const {
    return deforms() ? Positions(deformation->at(time) - now) : Positions(3, 0);
}

double OtherSurface::largest_displacement() const {
    return deforms() ? std::sqrt((now - before).colwise().squaredNorm().maxCoeff()) : 0;
}

}  // namespace sherd
