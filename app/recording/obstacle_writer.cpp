// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/obstacle_writer.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/recording/recording_format.h"
#include "meshops/error.h"

namespace sherd::recording_format {

void write_obstacles(hid_t file, std::span<const RecordedObstacle> obstacles) {
    if (obstacles.empty()) return;
    std::vector<std::string> names;
    std::vector<std::uint8_t> planes, deforming;
    for (std::size_t i = 0; i < obstacles.size(); ++i) {
        const auto& [name, surface, plane, deforms] = obstacles[i];
        names.push_back(name);
        planes.push_back(plane);
        deforming.push_back(deforms);
        const hdf5::Handle group = hdf5::create_group(file, obstacle_group(i));
        hdf5::write<Vector3d>(group, "position", surface.points, {"m", "in the obstacle's own frame"});
        hdf5::write<std::array<Index, 3>>(group, "face", surface.triangles,
                                          {"1", "the three corners, as rows of position"});
    }
    hdf5::write_texts(file, "obstacles/names", names);
    hdf5::write<std::uint8_t>(file, obstacle_planes, planes,
                              {"1", "1: a plane, of which the surface here is a square"});
    if (std::ranges::find(deforming, 1) != deforming.end())
        hdf5::write<std::uint8_t>(file, obstacle_deforms, deforming,
                                  {"1", "1: a deforming obstacle, whose points are in each frame, in space"});
}

ObstaclePlaces first_places(std::span<const RecordedObstacle> obstacles) {
    ObstaclePlaces places;
    places.poses.assign(obstacles.size(), Eigen::Isometry3d::Identity());
    for (std::size_t i = 0; i < obstacles.size(); ++i) places.points.push_back(obstacle_points(i));
    return places;
}

ObstaclePlaces next_places(const ObstaclePlaces& before, std::size_t frame,
                           std::span<const RecordedObstacle> obstacles,
                           std::span<const Eigen::Isometry3d> poses, const ObstacleShapes& shapes) {
    if (poses.size() != obstacles.size())
        throw Error(fmt::format("it has {} poses of {} obstacles", poses.size(), obstacles.size()),
                    Fault::run);
    ObstaclePlaces places{{poses.begin(), poses.end()}, before.points};
    for (std::size_t i = 0; i < poses.size(); ++i) {
        if (obstacles[i].deforms &&
            (i >= shapes.size() || shapes[i].size() != obstacles[i].surface.points.size()))
            throw Error(fmt::format("it lacks points of the obstacle '{}', which deforms", obstacles[i].name),
                        Fault::run);
        if (obstacles[i].deforms || poses[i].matrix() != before.poses[i].matrix())
            places.points[i] = obstacle_points(frame, i);
    }
    return places;
}

void write_places(hid_t file, std::size_t frame, std::span<const RecordedObstacle> obstacles,
                  const ObstaclePlaces& places, const ObstacleShapes& shapes) {
    if (obstacles.empty()) return;
    std::vector<StoredPose> stored(obstacles.size());
    for (std::size_t i = 0; i < obstacles.size(); ++i) {
        Eigen::Map<Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(stored[i].data()) = places.poses[i].affine();
        if (places.points[i] != obstacle_points(frame, i)) continue;
        std::vector<Vector3d> points;
        if (obstacles[i].deforms)
            points = shapes[i];
        else
            for (const Vector3d& point : obstacles[i].surface.points)
                points.push_back(places.poses[i] * point);
        hdf5::write<Vector3d>(file, places.points[i], points,
                              {"m", obstacles[i].deforms ? "in space" : "in space; it has moved"});
    }
    hdf5::write<StoredPose>(file, frame_group(frame) + "/obstacle/pose", stored,
                            {"1",
                             "poses in the order of /obstacles/names: the three rows of rotation | "
                             "translation (m), from the obstacle's own frame to space"});
}

}  // namespace sherd::recording_format
