// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/loads.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <stdexcept>

namespace sherd {
namespace {

double fraction(const Load& load, double time) {
    return load.ramp > 0 ? std::clamp(time / load.ramp, 0.0, 1.0) : 1.0;
}

Matrix3d skew(const Vector3d& v) {
    Matrix3d s;
    s << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return s;
}

}  // namespace

std::vector<CornerForce> point_forces(const Sheet& sheet, std::span<const Index> vertices,
                                      const Vector3d& force) {
    std::vector<CornerForce> forces(sheet.mass.size(), CornerForce{-1, 0, force});
    for (Index t = 0; t < static_cast<Index>(sheet.triangles.size()); ++t)
        for (int corner = 0; corner < 3; ++corner)
            forces[sheet.triangles[t].vertices[corner]] = {t, corner, force};
    std::vector<CornerForce> result;
    for (const Index vertex : vertices) {
        result.push_back(forces.at(vertex));
        if (result.back().triangle < 0) throw std::out_of_range("point_forces: a vertex without triangle");
    }
    return result;
}

std::vector<CornerForce> line_forces(const Sheet& sheet, std::span<const TriangleSide> sides,
                                     const Vector3d& force) {
    std::vector<CornerForce> result;
    for (const TriangleSide& side : sides) {
        const auto [from, to, opposite] = side_vertices(sheet, side);
        const double length = (sheet.rest.col(to) - sheet.rest.col(from)).norm();
        for (const int turn : {1, 2})
            result.push_back({side.triangle, (side.corner + turn) % 3, length / 2 * force});
    }
    return result;
}

std::vector<CornerForce> area_forces(const Sheet& sheet, std::span<const Index> triangles,
                                     const Vector3d& force) {
    std::vector<CornerForce> result;
    for (const Index triangle : triangles)
        for (int corner = 0; corner < 3; ++corner)
            result.push_back({triangle, corner, sheet.triangles[triangle].membrane.area / 3 * force});
    return result;
}

LoadEnergy::LoadEnergy(const Sheet& sheet, const std::vector<Load>& loads, double time)
    : start(sheet.position), force(Positions::Zero(3, sheet.position.cols())) {
    for (const Load& load : loads) {
        for (const CornerForce& dead : load.dead)
            force.col(sheet.triangles[dead.triangle].vertices[dead.corner]) +=
                fraction(load, time) * dead.force;
        press(sheet, load, fraction(load, time));
    }
    if (pressed.empty()) return;
    for (const PressedTriangle& triangle : pressed)
        centre += triangle_positions(start, triangle.vertices).rowwise().mean() /
                  static_cast<double>(pressed.size());
    for (const PressedTriangle& triangle : pressed) {
        const TrianglePositions x = triangle_positions(start, triangle.vertices);
        const Vector3d area = 0.5 * Vector3d(x.col(1) - x.col(0)).cross(Vector3d(x.col(2) - x.col(0)));
        for (const Index vertex : triangle.vertices) force.col(vertex) += triangle.pressure / 3 * area;
        add_volume_gradient(triangle, start, force);
    }
    start_potential = potential_of_volume(start);
}

void LoadEnergy::press(const Sheet& sheet, const Load& load, double fraction) {
    for (const Index triangle : load.pressed)
        pressed.push_back({sheet.triangles[triangle].vertices, fraction * load.pressure});
}

double LoadEnergy::potential_of_volume(const Positions& x) const {
    double sum = 0;
    for (const PressedTriangle& triangle : pressed) {
        const TrianglePositions r = triangle_positions(x, triangle.vertices).colwise() - centre;
        sum -= triangle.pressure / 6 * r.determinant();
    }
    return sum;
}

void LoadEnergy::add_volume_gradient(const PressedTriangle& triangle, const Positions& x,
                                     Positions& gradient) const {
    const TrianglePositions r = triangle_positions(x, triangle.vertices).colwise() - centre;
    for (int i = 0; i < 3; ++i)
        gradient.col(triangle.vertices[i]) -=
            triangle.pressure / 6 * r.col((i + 1) % 3).cross(r.col((i + 2) % 3));
}

double LoadEnergy::value(const Positions& x) const {
    return potential_of_volume(x) - start_potential - force.cwiseProduct(x - start).sum();
}

void LoadEnergy::add_gradient(const Positions& x, Positions& gradient) const {
    gradient -= force;
    for (const PressedTriangle& triangle : pressed) add_volume_gradient(triangle, x, gradient);
}

void LoadEnergy::add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const {
    // The volume's second derivative is indefinite: it has no convex part worth keeping.
    if (curvature == Curvature::convex) return;
    for (const PressedTriangle& triangle : pressed) {
        const TrianglePositions r = triangle_positions(x, triangle.vertices).colwise() - centre;
        for (int i = 0; i < 3; ++i)
            hessian.add(triangle.vertices[i], triangle.vertices[(i + 1) % 3],
                        triangle.pressure / 6 * skew(r.col((i + 2) % 3)));
    }
}

void LoadEnergy::add_pattern(std::vector<std::pair<Index, Index>>& pairs) const {
    for (const PressedTriangle& triangle : pressed) add_pairs(pairs, triangle.vertices);
}

}  // namespace sherd
