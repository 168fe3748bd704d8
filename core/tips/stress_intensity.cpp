// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tips/stress_intensity.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "core/shell/thickness.h"
#include "core/tips/fold_changes.h"

namespace sherd {
namespace {

/// Weights of a triangle's corners at three points that integrate quadratic functions.
constexpr std::array<std::array<double, 3>, 3> points_inside{
    {{2.0 / 3, 1.0 / 6, 1.0 / 6}, {1.0 / 6, 2.0 / 3, 1.0 / 6}, {1.0 / 6, 1.0 / 6, 2.0 / 3}}};

/// A face in the tip's tangent plane, with the tip at the origin and the crack on the negative first axis.
struct FaceAtTip {
    double area;                              ///< m^2
    Eigen::Matrix2d frame;                    ///< axes of the face's rest frame, one a column
    Eigen::Matrix<double, 2, 3> corners;      ///< m
    Eigen::Matrix<double, 2, 3> derivatives;  ///< derivatives of the shape functions, 1/m
    Matrix3d unfolded;                        ///< rotation of the face at rest into the plane
    Vector2d point(int i) const {
        return corners * Vector3d(points_inside[i][0], points_inside[i][1], points_inside[i][2]);
    }
};

FaceAtTip face_at_tip(const Shell& shell, const CrackTip& tip, Index face) {
    const auto& [vertices, membrane] = shell.triangles[face];
    const TrianglePositions rest = columns(shell.rest, vertices);
    const Eigen::Matrix<double, 3, 2> own = frame_axes(rest), axes = tip.axes();
    const Vector3d normal = Vector3d(own.col(0)).cross(Vector3d(own.col(1)));
    FaceAtTip at;
    at.area = membrane.area;
    at.unfolded = smallest_turn(normal, tip.normal);
    at.frame = axes.transpose() * at.unfolded * own;
    at.derivatives = at.frame * membrane.derivatives.transpose();
    for (int corner = 0; corner < 3; ++corner) {
        const Vector3d from_tip = rest.col(corner) - shell.rest.col(tip.vertex);
        const Vector2d flat = axes.transpose() * from_tip;
        const double length = flat.norm();
        at.corners.col(corner) = length > 0 ? Vector2d(from_tip.norm() / length * flat) : flat;
    }
    return at;
}

/// The symmetric tensor with the components (00, 11, 01).
Eigen::Matrix2d full(const Vector3d& tensor) {
    Eigen::Matrix2d matrix;
    matrix << tensor[0], tensor[2], tensor[2], tensor[1];
    return matrix;
}

/// Symmetric tensor of a strain (00, 11, 2 * 01).
Eigen::Matrix2d full_strain(const Vector3d& strain) {
    return full({strain[0], strain[1], strain[2] / 2});
}

/// Gradient, 1/m, of the field that is 1 on the tip's rings 0 to `last` and falls to 0 linearly in the faces
/// beyond.
Vector2d ring_gradient(const FaceAtTip& at, const std::array<Index, 3>& vertices, const CrackTip& tip,
                       int last) {
    Vector2d sum = Vector2d::Zero();
    for (int corner = 0; corner < 3; ++corner)
        for (int ring = 0; ring <= last; ++ring)
            if (std::ranges::binary_search(tip.rings[ring], vertices[corner]))
                sum += at.derivatives.col(corner);
    return sum;
}

/// Gradient and second derivatives of a smooth field about the tip: the field is 1 up to a third of `reach`
/// (m) from the tip, and 0 beyond `reach`.
struct SmoothField {
    Vector2d slope;        ///< 1/m
    Eigen::Matrix2d bend;  ///< 1/m^2
};

SmoothField smooth_field(const Vector2d& at, double reach) {
    const double r = at.norm(), inner = reach / 3, s = (r - inner) / (reach - inner);
    if (s <= 0 || s >= 1) return {Vector2d::Zero(), Eigen::Matrix2d::Zero()};
    const double width = reach - inner;
    const double first = -30 * s * s * (1 - s) * (1 - s) / width,
                 second = -60 * s * (1 - s) * (1 - 2 * s) / (width * width);
    const Vector2d out = at / r;
    const Eigen::Matrix2d radial = out * out.transpose();
    return {first * out, second * radial + first / r * (Eigen::Matrix2d::Identity() - radial)};
}

/// Radius of the smooth field, m: the distance of the nearest vertex outside of the rings.
double reach_of(const Shell& shell, const CrackTip& tip, const std::vector<Index>& faces) {
    double reach = std::numeric_limits<double>::infinity();
    for (const Index face : faces)
        for (const Index vertex : shell.triangles[face].vertices)
            if (std::ranges::none_of(tip.rings, [vertex](const std::vector<Index>& ring) {
                    return std::ranges::binary_search(ring, vertex);
                }))
                reach = std::min(reach, (shell.rest.col(vertex) - shell.rest.col(tip.vertex)).norm());
    return reach;
}

/// A face with its membrane fields, in the tip's axes.
struct StretchedFace {
    FaceAtTip place;
    Eigen::Matrix2d stress;   ///< Pa
    Vector2d along_gradient;  ///< derivative of the displacement along the crack
};

/// turn: rotation from rest to x at the tip. The rotation between the tangent plane at the tip and the face
/// at rest is taken out, since it is no displacement.
StretchedFace stretched_face(const Shell& shell, const CrackTip& tip, Index face, const Positions& x,
                             const Matrix3d& turn) {
    const auto& [vertices, membrane] = shell.triangles[face];
    const TrianglePositions now = columns(x, vertices);
    StretchedFace at{face_at_tip(shell, tip, face), {}, {}};
    const Eigen::Matrix2d& frame = at.place.frame;
    const Eigen::Matrix2d tension = full(membrane.elasticity * green_strain(membrane, now));
    at.stress = frame * tension * frame.transpose() / mean_thickness(shell, vertices);
    const Eigen::Matrix2d stretched = tip.axes().transpose() * at.place.unfolded * turn.transpose() *
                                      deformation_gradient(membrane, now) * frame.transpose();
    at.along_gradient = stretched.col(0) - Vector2d::UnitX();
    return at;
}

/// Interaction of the face's fields with the fields of a mode, Pa/m. slope: gradient of the field of advance,
/// 1/m.
double interaction(const StretchedFace& at, const MembraneField& mode, const Vector2d& slope) {
    const Vector2d carried = at.stress * mode.along_gradient + full(mode.stress) * at.along_gradient;
    return carried.dot(slope) - at.stress.cwiseProduct(full_strain(mode.strain)).sum() * slope.x();
}

/// A face with its bending, in the tip's axes.
struct BentFace {
    FaceAtTip place;
    Matrix3d rigidity;          ///< N m, in the face's frame
    Eigen::Matrix2d curvature;  ///< change of curvature, 1/m
    Eigen::Matrix2d moment;     ///< N
    double along_slope;         ///< derivative of the deflection along the crack
};

/// turn: rotation from rest to x at the tip; changes: changes of all folds' angles, rad.
BentFace bent_face(const Shell& shell, const CoupledBending& bending, const CrackTip& tip, Index face,
                   const Positions& x, const Matrix3d& turn, const VectorXd& changes) {
    BentFace at{face_at_tip(shell, tip, face), {}, {}, {}, 0};
    const Eigen::Matrix2d& frame = at.place.frame;
    at.rigidity = bending.rigidity(face) / at.place.area;
    const Vector3d change = bending.face_curvature().of(static_cast<std::size_t>(face), changes);
    at.curvature = frame * full_strain(change) * frame.transpose();
    at.moment = frame * full(at.rigidity * change) * frame.transpose();
    const Eigen::Matrix<double, 3, 2> now = frame_axes(columns(x, shell.triangles[face].vertices));
    const Vector3d normal = Vector3d(now.col(0)).cross(Vector3d(now.col(1)));
    at.along_slope = -tip.direction.dot(at.place.unfolded * turn.transpose() * normal);
    return at;
}

/// Interaction of the face's bending with the bending of a mode, Pa.
double interaction(const BentFace& at, const PlateField& mode, const SmoothField& field) {
    const Eigen::Matrix2d curvature = full_strain(mode.curvature),
                          moment = full(at.rigidity * mode.curvature);  // isotropic: equal in all axes
    const Vector2d carried = 2 * (at.moment * curvature.col(0) + moment * at.curvature.col(0));
    return carried.dot(field.slope) - at.moment.cwiseProduct(curvature).sum() * field.slope.x() +
           (mode.along_slope * at.moment + at.along_slope * moment).cwiseProduct(field.bend).sum();
}

/// The modes of unit factor.
constexpr std::array<ModePair, 2> unit_modes{{{1, 0}, {0, 1}}};

ModePair from_interactions(const std::array<double, 2>& interactions, double release_of_one) {
    return {interactions[0] / (2 * release_of_one), interactions[1] / (2 * release_of_one)};
}

}  // namespace

std::optional<PlaneStress> isotropic_at(const Shell& shell, Index face) {
    const auto& [vertices, membrane] = shell.triangles[face];
    const Matrix3d& c = membrane.elasticity;
    const double poisson = c(0, 1) / c(0, 0);
    const double young = c(0, 0) * (1 - poisson * poisson) / mean_thickness(shell, vertices);
    Matrix3d isotropic;
    isotropic << 1, poisson, 0, poisson, 1, 0, 0, 0, (1 - poisson) / 2;
    if (!((c - c(0, 0) * isotropic).norm() <= 1e-6 * c.norm())) return std::nullopt;
    return PlaneStress{young, poisson};
}

PlaneStress plane_stress_at(const Shell& shell, Index face) {
    if (const std::optional<PlaneStress> found = isotropic_at(shell, face)) return *found;
    throw std::invalid_argument("face " + std::to_string(face) +
                                " is not isotropic: stress intensity factors are not defined");
}

ModePair membrane_intensity(const Shell& shell, const VertexFaces& around, const CrackTip& tip,
                            const Positions& x) {
    const int last = std::min(1, static_cast<int>(tip.rings.size()) - 1);
    const PlaneStress material = plane_stress_at(shell, around[tip.vertex].front());
    const Matrix3d turn = rotation_at(shell, around, tip.vertex, x);
    std::array<double, 2> interactions{};
    for (const Index face : faces_around(around, tip, last)) {
        const StretchedFace at = stretched_face(shell, tip, face, x, turn);
        const Vector2d slope = ring_gradient(at.place, shell.triangles[face].vertices, tip, last);
        for (int mode = 0; mode < 2; ++mode)
            for (int i = 0; i < 3; ++i)
                interactions[mode] +=
                    at.place.area / 3 *
                    interaction(at, membrane_field(material, unit_modes[mode], at.place.point(i)), slope);
    }
    return from_interactions(interactions, membrane_release(material, unit_modes[0]));
}

ModePair plate_intensity(const Shell& shell, const VertexFaces& around, const CoupledBending& bending,
                         const CrackTip& tip, const Positions& x) {
    const std::vector<Index> faces = faces_around(around, tip, static_cast<int>(tip.rings.size()) - 1);
    const PlaneStress material = plane_stress_at(shell, around[tip.vertex].front());
    const double thickness = shell.thickness[tip.vertex], reach = reach_of(shell, tip, faces);
    const Matrix3d turn = rotation_at(shell, around, tip.vertex, x);
    const VectorXd changes = changes_of(bending, x, bending.face_curvature().folds_of(faces));
    std::array<double, 2> interactions{};
    for (const Index face : faces) {
        const BentFace at = bent_face(shell, bending, tip, face, x, turn, changes);
        for (int i = 0; i < 3; ++i) {
            const SmoothField field = smooth_field(at.place.point(i), reach);
            for (int mode = 0; mode < 2 && !field.slope.isZero(); ++mode)
                interactions[mode] +=
                    at.place.area / 3 *
                    interaction(at, plate_field(material, thickness, unit_modes[mode], at.place.point(i)),
                                field);
        }
    }
    return from_interactions(interactions, thickness * plate_release(material, unit_modes[0]));
}

}  // namespace sherd
