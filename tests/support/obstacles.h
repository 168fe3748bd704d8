// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/obstacle.h"
#include "core/contact/solids.h"
#include "core/sheet.h"

namespace sherd::test {

template <class Solid>
Obstacle obstacle(const Solid& solid, double young = 3e10, double friction = 0) {
    return {std::make_shared<Solid>(solid), {}, young, friction};
}

/// The plane z = 0.
inline Obstacle floor(double young = 3e10, double friction = 0) {
    return obstacle(PlaneShape{}, young, friction);
}

/// A lone vertex, which a step treats as a ball of mass 0.1 kg, 1 cm thick.
inline Sheet lone_vertex(const Vector3d& at) {
    Sheet sheet;
    resize_vertices(sheet, 1);
    sheet.position.col(0) = at;
    sheet.rest = sheet.position;
    sheet.mass[0] = 0.1;
    sheet.thickness[0] = 0.01;
    sheet.young[0] = 1e7;
    sheet.footprint[0] = 1e-4;
    return sheet;
}

}  // namespace sherd::test
