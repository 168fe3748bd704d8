// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/recording/synthetic_run.h"

namespace sherd::test {

/// Tetrahedron, some 6 cm in size, with a name that no path in a file could have.
inline RecordedObstacle tetrahedron() {
    return {"a/b \"anvil\"",
            {{{0, 0, 0}, {0.06, 0, 0}, {0, 0.06, 0}, {0, 1.0 / 17, 0.06}},
             {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}}};
}

/// Plane, recorded as a square with sides of 40 cm.
inline RecordedObstacle floor_plane() {
    return {"floor",
            {{{-0.2, -0.2, 0}, {0.2, -0.2, 0}, {0.2, 0.2, 0}, {-0.2, 0.2, 0}}, {{0, 1, 2}, {0, 2, 3}}},
            true};
}

inline Eigen::Isometry3d obstacle_pose(double angle, const Vector3d& place) {
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = Eigen::AngleAxisd(angle, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    pose.translation() = place;
    return pose;
}

/// Two tetrahedra and a floor; the second tetrahedron moves from frame to frame.
inline std::vector<RecordedObstacle> recorded_obstacles() {
    return {tetrahedron(), tetrahedron(), floor_plane()};
}

inline std::vector<Eigen::Isometry3d> obstacle_poses(std::size_t frame) {
    const double k = static_cast<double>(frame);
    return {obstacle_pose(0.3, {0.02, 0, 0.03}), obstacle_pose(k, {0.07, 0.01 * k, -0.05}),
            obstacle_pose(0, {0, 0, -0.1})};
}

/// Points of an obstacle in a frame, m.
inline std::vector<Vector3d> obstacle_points(std::size_t obstacle, std::size_t frame) {
    std::vector<Vector3d> points = recorded_obstacles()[obstacle].surface.points;
    for (Vector3d& point : points) point = obstacle_poses(frame)[obstacle] * point;
    return points;
}

inline void record_with_obstacles(const SyntheticRun& run, const std::filesystem::path& file) {
    RecordingWriter writer(file, run.header, false, recorded_obstacles());
    for (std::size_t k = 0; k < run.frames.size(); ++k)
        writer.append(run.frames[k], run.steps[k], run.events[k], obstacle_poses(k));
    writer.finish(1, "complete");
}

}  // namespace sherd::test
