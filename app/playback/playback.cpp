// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/playback/playback.h"

#include <algorithm>
#include <utility>

#include "app/playback/interpolation.h"

namespace sherd {

Playback::Playback(std::function<Snapshot(std::size_t)> read_) : read(std::move(read_)) {}

const Snapshot& Playback::frame(std::size_t number) {
    const auto found = kept.find(number);
    return found != kept.end() ? found->second : kept.emplace(number, read(number)).first->second;
}

Snapshot Playback::at(const PlaybackTime& moment) {
    std::erase_if(kept, [&](const auto& entry) {
        return entry.first != moment.earlier && entry.first != moment.later;
    });
    const Snapshot& earlier = frame(moment.earlier);
    return moment.share > 0 ? interpolated(earlier, frame(moment.later), moment.share) : earlier;
}

Vector3d middle(const GridSurface& surface) {
    Vector3d sum = Vector3d::Zero();
    for (const Vector3d& point : surface.points) sum += point;
    return sum / std::max<double>(1, static_cast<double>(surface.points.size()));
}

ObstaclePlayback::ObstaclePlayback(const Recording& recording) : recording(recording) {
    for (const RecordedObstacle& obstacle : recording.obstacles())
        middles.push_back(middle(obstacle.surface));
}

std::vector<Eigen::Isometry3d> ObstaclePlayback::at(const PlaybackTime& moment) const {
    std::vector<Eigen::Isometry3d> poses = recording.poses(moment.earlier);
    if (!(moment.share > 0)) return poses;
    const std::vector<Eigen::Isometry3d> later = recording.poses(moment.later);
    for (std::size_t i = 0; i < poses.size(); ++i)
        poses[i] = interpolated(poses[i], later[i], moment.share, middles[i]);
    return poses;
}

ObstacleShapes ObstaclePlayback::shapes(const PlaybackTime& moment) const {
    ObstacleShapes shapes = recording.shapes(moment.earlier);
    if (!(moment.share > 0)) return shapes;
    const ObstacleShapes later = recording.shapes(moment.later);
    for (std::size_t i = 0; i < shapes.size(); ++i)
        for (std::size_t p = 0; p < shapes[i].size(); ++p)
            shapes[i][p] += moment.share * (later[i][p] - shapes[i][p]);
    return shapes;
}

}  // namespace sherd
