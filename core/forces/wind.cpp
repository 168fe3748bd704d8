// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/forces/wind.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

namespace sherd {
namespace {

/// Matrix K, kg/s, of a triangle: see WindEnergy. corners: m; relative: velocity of the air relative to the
/// triangle, m/s.
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

Positions WindEnergy::air_at_corners(const Wind& wind, double time) const {
    Positions air(3, shell.position.cols());
    std::vector<char> known(shell.position.cols(), 0);
    for (const Index triangle : wind.triangles)
        for (const Index v : shell.triangles[triangle].vertices)
            if (!std::exchange(known[v], 1)) air.col(v) = wind.at(shell.position.col(v), time);
    return air;
}

void WindEnergy::topology_changed(const ShellChange& change, const StepContext& step) {
    for (Wind& wind : winds) follow_faces(change, wind.triangles);
    begin(step);
}

void WindEnergy::begin(const StepContext& step) {
    elements.corners.clear();
    for (const Wind& wind : winds) {
        const Positions at_corners = air_at_corners(wind, step.end());
        for (const Index triangle : wind.triangles) {
            const std::array<Index, 3>& vertices = shell.triangles[triangle].vertices;
            const TrianglePositions x = columns(shell.position, vertices),
                                    v = columns(shell.velocity, vertices),
                                    origin = columns(step.origin, vertices),
                                    air = columns(at_corners, vertices);
            const Matrix3d stiffness = resistance(wind, x, (air - v).rowwise().mean()) / (3 * step.lag);
            for (int i = 0; i < 3; ++i)
                elements.corners.push_back({vertices[i], origin.col(i) + step.lag * air.col(i), stiffness});
        }
    }
}

}  // namespace sherd
