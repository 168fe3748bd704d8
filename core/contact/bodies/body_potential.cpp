// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/bodies/body_potential.h"

#include <cmath>

namespace sherd {

Matrix3d turned(const Vector3d& rotation) {
    const double angle = rotation.norm();
    if (angle == 0) return Matrix3d::Identity();
    return Eigen::AngleAxisd(angle, rotation / angle).toRotationMatrix();
}

Matrix3d rotation_jacobian(const Vector3d& rotation) {
    const double angle = rotation.norm(), squared = angle * angle;
    const Matrix3d cross = cross_matrix(rotation);
    if (angle < 1e-4) return Matrix3d::Identity() + 0.5 * cross + cross * cross / 6;
    return Matrix3d::Identity() + (1 - std::cos(angle)) / squared * cross +
           (angle - std::sin(angle)) / (squared * angle) * cross * cross;
}

Matrix36d BodyPose::point_motion(const Vector3d& arm) const {
    Matrix36d motion;
    motion << Matrix3d::Identity(), -cross_matrix(arm) * jacobian;
    return motion;
}

void BodyPotential::add_vertex(const BodyPose& pose, Index vertex, const Vector3d& by_x,
                               const Matrix3d& twice, const Vector3d& arm) {
    const Matrix36d relative = -pose.point_motion(arm);
    VertexTerms& terms = vertex_terms[vertex];
    terms.gradient += by_x;
    terms.hessian += twice;
    terms.mixed += twice * relative;
    turning += by_x.norm() * arm.norm();
    gradient += relative.transpose() * by_x;
    hessian += relative.transpose() * twice * relative;
}

void BodyPotential::add_element(const BodyPose& pose, const std::array<Index, 4>& vertices, Index first,
                                const Positions& points, const PairPositions& by_x,
                                const PairHessian& twice) {
    Eigen::Matrix<double, 12, 6> motion = Eigen::Matrix<double, 12, 6>::Zero();
    for (int i = 0; i < 4; ++i)
        if (vertices[i] < first) {
            const Vector3d arm = pose.place.linear() * points.col(vertices[i]);
            motion.middleRows<3>(3 * i) = pose.point_motion(arm);
            turning += by_x.col(i).norm() * arm.norm();
        }
    gradient += motion.transpose() * by_x.reshaped();
    hessian += motion.transpose() * twice * motion;
    for (int i = 0; i < 4; ++i) {
        if (vertices[i] < first) continue;
        VertexTerms& terms = vertex_terms[vertices[i] - first];
        terms.gradient += by_x.col(i);
        terms.hessian += twice.block<3, 3>(3 * i, 3 * i);
        terms.mixed += twice.middleRows<3>(3 * i) * motion;
        for (int j = 0; j < 4; ++j)
            if (vertices[j] >= first && vertices[j] < vertices[i])
                couplings.try_emplace({vertices[i] - first, vertices[j] - first}, Matrix3d(Matrix3d::Zero()))
                    .first->second += twice.block<3, 3>(3 * i, 3 * j);
    }
}

}  // namespace sherd
