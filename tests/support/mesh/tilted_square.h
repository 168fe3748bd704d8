// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <numbers>

#include "fracture/shell/breakable_shell.h"
#include "meshops/generate/generate.h"

namespace sherd::test {

/// Square of side 1 m, 1 cm thick, with edges of `edge` m; turned by `degrees` about the x axis, then moved
/// by `shift`, m.
inline SheetInput tilted_square(double degrees, const Vector3d& shift, double edge = 1) {
    SheetInput sheet;
    sheet.mesh = generate_rectangle(1, 1, {edge, Layout::structured, 1});
    sheet.material = {1000, 0.01, 1e8, 0.2};
    const Eigen::AngleAxisd turn(degrees * std::numbers::pi / 180, Vector3d::UnitX());
    for (const Vertex v : sheet.mesh.vertices()) {
        const Point& p = sheet.mesh.point(v);
        const Vector3d moved = turn * Vector3d(p.x(), p.y(), p.z()) + shift;
        sheet.mesh.point(v) = Point(moved.x(), moved.y(), moved.z());
    }
    return sheet;
}

}  // namespace sherd::test
