// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/playback/playback.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/playback/interpolation.h"
#include "meshops/error.h"

namespace sherd {
namespace {

constexpr double most_moments = 100'000;

constexpr double near = 1e-6;  // round-off, as a share of a step or of the time between frames

}  // namespace

std::vector<PlaybackTime> recorded_times(std::span<const std::size_t> frames, std::span<const double> times) {
    std::vector<PlaybackTime> moments;
    for (std::size_t i = 0; i < frames.size(); ++i) moments.push_back({frames[i], frames[i], 0, times[i]});
    return moments;
}

std::vector<PlaybackTime> even_times(std::span<const std::size_t> frames, std::span<const double> times,
                                     double step) {
    const double steps = std::max(0.0, std::ceil((times.back() - times.front()) / step - near));
    if (!(steps < most_moments))
        throw Error(
            fmt::format("--slow and --rate ask for {:.0f} pictures, more than {:.0f}; make one of "
                        "them smaller, or choose fewer --frames",
                        steps + 1, most_moments));
    std::vector<PlaybackTime> moments;
    std::size_t at = 0;  // index of the last frame that is not later than the moment
    for (std::size_t i = 0; i < static_cast<std::size_t>(steps); ++i) {
        const double time = times.front() + static_cast<double>(i) * step;
        const auto share = [&] { return (time - times[at]) / (times[at + 1] - times[at]); };
        while (at + 2 < times.size() && !(share() < 1 - near)) ++at;
        const double way = share();
        moments.push_back(way < near ? PlaybackTime{frames[at], frames[at], 0, times[at]}
                                     : PlaybackTime{frames[at], frames[at + 1], way, time});
    }
    moments.push_back({frames.back(), frames.back(), 0, times.back()});
    return moments;
}

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
