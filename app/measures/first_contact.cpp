// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/measures/first_contact.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "app/playback/playback.h"
#include "meshops/error.h"
#include "meshops/nearest_triangle.h"

namespace sherd {
namespace {

std::size_t number_of(const std::vector<RecordedObstacle>& obstacles, const std::string& name) {
    const auto found = std::ranges::find(obstacles, name, &RecordedObstacle::name);
    if (found != obstacles.end()) return found - obstacles.begin();
    std::vector<std::string> names;
    for (const RecordedObstacle& obstacle : obstacles) names.push_back(obstacle.name);
    throw Error(fmt::format("--about {}: the recording has no such obstacle; it has {}", name,
                            names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "))));
}

/// End of the first step in which the obstacle had a contact force, s; for a free body: of the first step
/// with any contact.
double first_touch(const Recording& recording, const std::string& name) {
    const std::vector<RecordedSupport> supports = recording.header().supports;
    const auto support = std::ranges::find(supports, "obstacle." + name, &RecordedSupport::name);
    for (const StepReport& step : recording.steps())
        if (support == supports.end() ? step.contacts > 0
                                      : !step.reactions[support - supports.begin()].force.isZero(0))
            return step.time;
    throw Error(fmt::format("--about {}: the obstacle has touched nothing", name));
}

PlaybackTime moment_at(const Recording& recording, double time) {
    PlaybackTime moment{.time = time};
    while (moment.later + 1 < recording.frame_count() && recording.time(moment.later) < time) ++moment.later;
    const double late = recording.time(moment.later);
    if (late <= time) return {moment.later, moment.later, 0, time};
    if (moment.later == 0) return {0, 0, 0, time};
    moment.earlier = moment.later - 1;
    const double early = recording.time(moment.earlier);
    moment.share = (time - early) / (late - early);
    return moment;
}

NearestTriangle surface_at(const Recording& recording, const std::vector<RecordedObstacle>& obstacles,
                           std::size_t number, const PlaybackTime& moment) {
    const ObstaclePlayback playback(recording);
    const Eigen::Isometry3d pose =
        obstacles[number].deforms ? Eigen::Isometry3d::Identity() : playback.at(moment)[number];
    const GridSurface surface = reshaped(obstacles[number].surface, playback.shapes(moment)[number]);
    Positions points(3, static_cast<Eigen::Index>(surface.points.size()));
    for (std::size_t i = 0; i < surface.points.size(); ++i)
        points.col(static_cast<Eigen::Index>(i)) = pose * surface.points[i];
    return {points, surface.triangles};
}

}  // namespace

Vector3d first_contact(const Recording& recording, const std::string& name) {
    const std::string prefix = "obstacle.";
    const std::string obstacle = name.starts_with(prefix) ? name.substr(prefix.size()) : name;
    const std::vector<RecordedObstacle> obstacles = recording.obstacles();
    const std::size_t number = number_of(obstacles, obstacle);
    const PlaybackTime moment = moment_at(recording, first_touch(recording, obstacle));
    const NearestTriangle surface = surface_at(recording, obstacles, number, moment);
    const Snapshot frame = Playback([&](std::size_t number) { return recording.frame(number); }).at(moment);
    double least = std::numeric_limits<double>::infinity();
    Index nearest = 0;
    for (Index v = 0; v < frame.position.cols(); ++v)
        if (const double distance = surface(frame.position.col(v)).distance; distance < least)
            least = distance, nearest = frame.original[v];
    return frame.rest.position.col(nearest);
}

}  // namespace sherd
