// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wind.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace sherd {
namespace {

/// K, kg/s, of a triangle. corners: m; wind: of the air relative to it, m/s.
Matrix3d resistance(const Wind& wind, const TrianglePositions& corners, const Vector3d& relative) {
    const Vector3d area =
        0.5 * Vector3d(corners.col(1) - corners.col(0)).cross(Vector3d(corners.col(2) - corners.col(0)));
    const Vector3d normal = area.stableNormalized();
    const double across = normal.dot(relative), along = (relative - across * normal).norm();
    const Matrix3d normals = normal * normal.transpose();
    return 0.5 * wind.density * area.norm() *
           ((wind.drag * std::abs(across) + wind.lift * along) * normals +
            wind.friction * along * (Matrix3d::Identity() - normals));
}

}  // namespace

Vector3d Wind::at(const Vector3d& place, double time) const {
    Vector3d sum = velocity;
    for (const GustWave& gust : gusts)
        sum += std::cos(gust.wave.dot(place) + gust.frequency * time + gust.phase) * gust.amplitude;
    return ramp > 0 ? std::clamp(time / ramp, 0.0, 1.0) * sum : sum;
}

WindEnergy::WindEnergy(const Sheet& sheet, const std::vector<Wind>& winds, double end, double step) {
    for (const Wind& wind : winds)
        for (const Index triangle : wind.triangles) {
            const std::array<Index, 3>& vertices = sheet.triangles[triangle].vertices;
            const TrianglePositions x = triangle_positions(sheet.position, vertices),
                                    v = triangle_positions(sheet.velocity, vertices);
            TrianglePositions air;
            for (int i = 0; i < 3; ++i) air.col(i) = wind.at(x.col(i), end);
            const Matrix3d stiffness = resistance(wind, x, (air - v).rowwise().mean()) / (3 * step);
            for (int i = 0; i < 3; ++i)
                corners.push_back({vertices[i], x.col(i) + step * air.col(i), stiffness});
        }
}

double WindEnergy::value(const Positions& x) const {
    double sum = 0;
    for (const Blown& corner : corners) {
        const Vector3d behind = x.col(corner.vertex) - corner.carried;
        sum += 0.5 * behind.dot(corner.stiffness * behind);
    }
    return sum;
}

void WindEnergy::add_gradient(const Positions& x, Positions& gradient) const {
    for (const Blown& corner : corners)
        gradient.col(corner.vertex) += corner.stiffness * (x.col(corner.vertex) - corner.carried);
}

void WindEnergy::add_hessian(const Positions&, Curvature, BlockMatrix& hessian) const {
    for (const Blown& corner : corners) hessian.add(corner.vertex, corner.vertex, corner.stiffness);
}

}  // namespace sherd
