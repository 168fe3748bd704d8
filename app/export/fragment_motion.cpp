// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/fragment_motion.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "app/export/export_sheet.h"

namespace sherd {

namespace {

constexpr double no_inertia = 1e-12;  // share of the largest principal moment that counts as zero

/// Part of the mass of a vertex that belongs to one of its faces, and so to a fragment.
struct MassPoint {
    std::size_t fragment;
    Index vertex;
    double mass;  ///< kg
};

std::vector<MassPoint> mass_points(const Snapshot& frame) {
    std::vector<int> faces_at(static_cast<std::size_t>(frame.mass.size()), 0);
    for (const auto& corners : frame.faces)
        for (const Index v : corners) ++faces_at[v];
    std::vector<MassPoint> points;
    for (std::size_t f = 0; f < frame.faces.size(); ++f)
        for (const Index v : frame.faces[f])
            points.push_back(
                {static_cast<std::size_t>(frame.face_fragment[f]), v, frame.mass[v] / faces_at[v]});
    return points;
}

/// Spin of a body with an angular momentum (kg m^2/s) about its centre; zero about axes without inertia.
Vector3d spin_of(const Matrix3d& inertia, const Vector3d& momentum) {
    const Eigen::SelfAdjointEigenSolver<Matrix3d> principal(inertia);
    const Vector3d& moments = principal.eigenvalues();
    Vector3d along = principal.eigenvectors().transpose() * momentum;
    for (int i = 0; i < 3; ++i) along[i] = moments[i] > no_inertia * moments[2] ? along[i] / moments[i] : 0;
    return principal.eigenvectors() * along;
}

}  // namespace

std::vector<FragmentMotion> fragment_motions(const Snapshot& frame) {
    std::vector<FragmentMotion> all(fragment_count(frame));
    const std::vector<MassPoint> points = mass_points(frame);
    for (const Index fragment : frame.face_fragment) ++all[fragment].faces;
    for (const auto& [fragment, v, mass] : points) {
        all[fragment].mass += mass;
        all[fragment].centre += mass * frame.position.col(v);
        all[fragment].velocity += mass * frame.velocity.col(v);
    }
    for (FragmentMotion& one : all) {
        if (!(one.mass > 0)) continue;
        one.centre /= one.mass;
        one.velocity /= one.mass;
    }
    std::vector<Vector3d> momenta(all.size(), Vector3d::Zero());
    for (const auto& [fragment, v, mass] : points) {
        const Vector3d arm = frame.position.col(v) - all[fragment].centre;
        const Vector3d way = frame.velocity.col(v) - all[fragment].velocity;
        all[fragment].inertia += mass * (arm.squaredNorm() * Matrix3d::Identity() - arm * arm.transpose());
        momenta[fragment] += mass * arm.cross(way);
    }
    for (std::size_t i = 0; i < all.size(); ++i) all[i].spin = spin_of(all[i].inertia, momenta[i]);
    return all;
}

}  // namespace sherd
