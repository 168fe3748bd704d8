// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/measures/cracks/crack_directions.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "core/elements/membrane.h"

namespace sherd {
namespace {

constexpr std::size_t smoothed_edges = 2;  // on each side of an edge whose direction is smoothed

/// Returns the angle of the direction `along` against the axis of a face, rad, 0 to pi.
double angle_in_face(const Vector3d& along, const RestMesh& rest, std::size_t face,
                     std::span<const Vector3d> axes) {
    const Eigen::Matrix<double, 3, 2> plane = frame_axes(columns(rest.position, rest.faces[face]));
    const Vector3d normal = plane.col(0).cross(plane.col(1));
    const Vector3d axis =
        in_plane_axis(normal, axes.empty() ? Vector3d::Zero().eval() : axes[rest.face_parent[face]]);
    const double angle = std::atan2(normal.cross(axis).dot(along), axis.dot(along));
    return angle < 0 ? angle + std::numbers::pi : angle;
}

std::size_t bin_of(double angle) {
    const double bins = CrackDirections::bins;
    return static_cast<std::size_t>(std::lround(angle / std::numbers::pi * bins)) % CrackDirections::bins;
}

}  // namespace

Vector3d in_plane_axis(const Vector3d& normal, const Vector3d& axis) {
    constexpr double least = 1e-3;  // shortest projection that gives a direction
    for (const Vector3d& way : {axis, Vector3d::UnitX().eval()})
        if (const Vector3d in_plane = way - way.dot(normal) * normal; in_plane.norm() > least)
            return in_plane.normalized();
    return (Vector3d::UnitY() - normal.y() * normal).normalized();
}

CrackDirections crack_directions(const CrackGraph& cracks, const RestMesh& rest,
                                 std::span<const Vector3d> axes) {
    CrackDirections directions;
    std::complex<double> doubled = 0;
    for (const CrackBranch& branch : cracks.branches) {
        const auto& [vertices, edges] = branch;
        if (!branch.has_shape()) continue;
        for (std::size_t i = 0; i < edges.size(); ++i) {
            const std::size_t from = i - std::min(i, smoothed_edges),
                              to = std::min(i + 1 + smoothed_edges, edges.size());
            const Vector3d chord = rest.position.col(vertices[to]) - rest.position.col(vertices[from]);
            const auto& [ends, faces, length] = cracks.edges[edges[i]];
            const double angle = angle_in_face(chord, rest, faces[0], axes);
            directions.length += length;
            directions.histogram[bin_of(angle)] += length;
            doubled += length * std::polar(1.0, 2 * angle);
        }
    }
    if (directions.length == 0) return directions;
    for (double& share : directions.histogram) share /= directions.length;
    directions.resultant = std::abs(doubled) / directions.length;
    const double mean = std::arg(doubled) * 90 / std::numbers::pi;
    directions.mean = mean < 0 ? mean + 180 : mean;
    return directions;
}

}  // namespace sherd
