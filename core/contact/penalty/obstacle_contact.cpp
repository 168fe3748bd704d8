// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/penalty/obstacle_contact.h"

namespace sherd {

void ObstacleContact::begin(const StepContext& step) {
    pose = obstacle.motion.at(step.end());
    sliding.clear();
    if (obstacle.friction > 0) find_sliding(step);
}

void ObstacleContact::find_sliding(const StepContext& step) {
    const Eigen::Isometry3d before = obstacle.motion.at(step.begin), moved = pose * before.inverse();
    for (Eigen::Index v = 0; v < sheet.position.cols(); ++v) {
        const Overlap start = overlap(sheet.position, v, before);
        if (start.depth <= 0) continue;
        const Vector3d x = sheet.position.col(v);
        const Index vertex = static_cast<Index>(v);
        const Friction friction{obstacle.friction * stiffness(v) * start.depth, smoothing_speed * step.lag};
        if (obstacle.moves())
            sliding.push_back(
                {vertex, step.at_rest_on(vertex, x, moved * x), moved.linear() * start.normal, friction});
        else
            sliding.push_back({vertex, step.at_rest_on(vertex, x, x), start.normal, friction});
    }
}

double ObstacleContact::stiffness(Eigen::Index vertex) const {
    return column_stiffness(sheet.footprint[vertex], sheet.thickness[vertex], sheet.young[vertex],
                            obstacle.young);
}

Overlap ObstacleContact::overlap(const Positions& x, Eigen::Index vertex, const Eigen::Isometry3d& at) const {
    return sherd::overlap(*obstacle.shape, at, x.col(vertex), 0.5 * sheet.thickness[vertex]);
}

Vector3d ObstacleContact::Sliding::slip(const Positions& x) const {
    const Vector3d way = x.col(vertex) - stuck;
    return way - normal * normal.dot(way);
}

double ObstacleContact::stored_energy(const Positions& x) const {
    double sum = 0;
    for (Eigen::Index v = 0; v < x.cols(); ++v) {
        const double depth = overlap(x, v, pose).depth;
        if (depth > 0) sum += 0.5 * stiffness(v) * depth * depth;
    }
    return sum;
}

void ObstacleContact::add_touch(const Positions& x, Touch& touch) const {
    for (Index v = 0; v < static_cast<Index>(x.cols()); ++v) touch.include(v, overlap(x, v, pose).depth);
}

double ObstacleContact::value(const Positions& x) const {
    double sum = stored_energy(x);
    for (const Sliding& slider : sliding) sum += slider.friction.value(slider.slip(x));
    return sum;
}

void ObstacleContact::add_gradient(const Positions& x, Positions& gradient) const {
    for (Eigen::Index v = 0; v < x.cols(); ++v) {
        const Overlap at = overlap(x, v, pose);
        if (at.depth > 0) gradient.col(v) -= stiffness(v) * at.depth * at.normal;
    }
    for (const Sliding& slider : sliding)
        gradient.col(slider.vertex) += slider.friction.gradient(slider.slip(x));
}

void ObstacleContact::add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const {
    for (Eigen::Index v = 0; v < x.cols(); ++v) {
        const Overlap at = overlap(x, v, pose);
        if (at.depth <= 0) continue;
        Matrix3d block = stiffness(v) * (at.normal * at.normal.transpose());
        if (curvature == Curvature::exact) block -= stiffness(v) * at.depth * at.curvature;
        hessian.add(static_cast<Index>(v), static_cast<Index>(v), block);
    }
    for (const Sliding& slider : sliding) {
        const Matrix3d tangent = Matrix3d::Identity() - slider.normal * slider.normal.transpose();
        hessian.add(slider.vertex, slider.vertex, slider.friction.hessian(slider.slip(x), tangent));
    }
}

}  // namespace sherd
