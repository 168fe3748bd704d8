// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/assemble/check/squeeze.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "app/messages/time_text.h"
#include "fracture/shell/mesh_inheritance.h"
#include "meshops/intersect/surface_crossings.h"
#include "meshops/mesh_measures.h"

namespace sherd {
namespace {

constexpr int moments_beside_keys = 200;
/// Number of moments, before the gap between two obstacles is too narrow, at which the sheet is searched for
/// in the gap.
constexpr int looks = 16;
constexpr double noticed_squeeze = 1e-2;  // share of the thickness: a gap narrower by more is reported
constexpr double bend_slack = 0.05;       // share of a sheet's size, added for its bending in flight
constexpr double needle_width = 1e-6;     // width of a needle, as a share of its length

/// A sheet at the start, which may get between two obstacles.
struct Between {
    std::vector<Vector3d> points;                 ///< m, vertices of the sheet
    std::vector<std::array<Index, 3>> triangles;  ///< without triangles pinned at all three vertices
    Vector3d velocity, gravity;                   ///< m/s, m/s^2; zero for a supported sheet
    double thickness;                             ///< m, smallest thickness of the sheet

    Vector3d flown(double time) const { return time * velocity + 0.5 * time * time * gravity; }
};

/// A point of the first obstacle of a Pair that comes too near to the second.
struct NarrowPoint {
    Index point;    ///< column of Pair::points_at()
    Vector3d foot;  ///< m, nearest point of the second obstacle at the time `first`, in its frame
    double first;   ///< s, first moment at which the gap is too narrow
    double gap;     ///< m, least gap
    double time;    ///< s, moment of the least gap
};

std::optional<NarrowPoint> narrower(const std::optional<NarrowPoint>& one, const NarrowPoint& other) {
    return one && one->gap <= other.gap ? one : other;
}

/// Two obstacles, and points on the surface of the first, `one`.
struct Pair {
    const Obstacle *one, *other;
    Positions added;  ///< m, further points of the surface of `one`, in its frame

    Positions points_at(double time) const {
        Positions placed = one->motion.at(time) * added;
        if (one->surface == nullptr) return placed;
        Positions all(3, one->surface->size() + placed.cols());
        all << one->points_at(time), placed;
        return all;
    }
};

Between between(const SheetInput& input, const SheetSpec& sheet, const Vector3d& gravity) {
    Between found{{}, {}, input.velocity, gravity, input.thinnest()};
    if (sheet.is_supported()) found.velocity = found.gravity = Vector3d::Zero();
    for (const Vertex v : input.mesh.vertices()) found.points.push_back(input.starts_at(v));
    for (const Face face : input.mesh.faces()) {
        const std::array<Index, 3> corners = face_vertices(input.mesh, face);
        if (!std::ranges::all_of(corners,
                                 [&](Index v) { return std::ranges::binary_search(input.pinned, v); }))
            found.triangles.push_back(corners);
    }
    return found;
}

/// Returns the points of an obstacle's surface that are nearest to the middles of a sheet's faces at the
/// start, in the obstacle's frame.
Positions feet(const Between& sheet, const Obstacle& obstacle) {
    std::vector<Vector3d> feet;
    const Eigen::Isometry3d back = obstacle.motion.at(0).inverse();
    for (const auto& [a, b, c] : sheet.triangles) {
        const Vector3d at = back * ((sheet.points[a] + sheet.points[b] + sheet.points[c]) / 3).eval();
        const SurfaceDistance found = obstacle.shape->distance(at);
        if (std::isfinite(found.distance)) feet.push_back(at - found.distance * found.gradient);
    }
    return Eigen::Map<const Positions>(feet.empty() ? nullptr : feet.front().data(), 3,
                                       static_cast<Index>(feet.size()));
}

std::vector<double> moments_of(const Pair& pair, double end) {
    std::vector<double> times;
    for (int i = 0; i <= moments_beside_keys; ++i) times.push_back(end * i / moments_beside_keys);
    for (const Obstacle* obstacle : {pair.one, pair.other})
        for (const MotionKey& key : obstacle->motion.keys)
            if (key.time >= 0 && key.time <= end) times.push_back(key.time);
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

/// Returns all points of the first obstacle that come nearer to the second than `least` (m) at one of the
/// times (s).
std::vector<NarrowPoint> narrow_points(const Pair& pair, std::span<const double> times, double least) {
    std::vector<std::optional<NarrowPoint>> found;
    Eigen::AlignedBox3d near = pair.other->shape->bounds();
    near.min().array() -= least;
    near.max().array() += least;
    for (const double time : times) {
        const Positions points = pair.other->motion.at(time).inverse() * pair.points_at(time);
        found.resize(points.cols());
        for (Index i = 0; i < points.cols(); ++i) {
            const Vector3d at = points.col(i);
            if (!near.contains(at)) continue;
            const SurfaceDistance to = pair.other->shape->distance(at);
            if (to.distance >= least) continue;
            if (!found[i]) found[i] = {i, at - to.distance * to.gradient, time, to.distance, time};
            if (to.distance >= found[i]->gap) continue;
            found[i]->gap = to.distance;
            found[i]->time = time;
        }
    }
    std::vector<NarrowPoint> narrow;
    for (const auto& point : found)
        if (point) narrow.push_back(*point);
    return narrow;
}

/// Adds a needle, a thin triangle along the line between two points that come together later. If a sheet
/// intersects the needle, it is between the points.
void add_needle(Mesh& needles, const Vector3d& from, const Vector3d& to) {
    const Vector3d aside = needle_width * (to - from).norm() * (to - from).unitOrthogonal();
    const Vertex a = needles.add_vertex(point_at(from)), b = needles.add_vertex(point_at(to)),
                 c = needles.add_vertex(point_at(to + aside));
    needles.add_face(a, b, c);
}

/// Returns, among the points for which the sheet is between the point and its foot at `time` (s), the point
/// with the narrowest gap; none if there is no such point. Points whose gap is too narrow before `time` do
/// not count. shift: m, displacement of the sheet since the start.
std::optional<NarrowPoint> crossed(const Pair& pair, const std::vector<NarrowPoint>& narrow,
                                   const Between& sheet, double time, const Vector3d& shift) {
    Mesh needles;
    std::vector<NarrowPoint> asked;
    const Positions points = pair.points_at(time);
    const Eigen::Isometry3d pose = pair.other->motion.at(time);
    for (const NarrowPoint& point : narrow) {
        const Vector3d from = points.col(point.point) - shift, to = pose * point.foot - shift;
        if (point.first < time || from == to) continue;
        add_needle(needles, from, to);
        asked.push_back(point);
    }
    std::optional<NarrowPoint> worst;
    for (const Face needle : surface_crossings(needles, sheet.points, sheet.triangles))
        worst = narrower(worst, asked[needle.idx()]);
    return worst;
}

/// Returns the point with the narrowest gap among those that crossed() finds, at the first moment at which it
/// finds any; none if it never does.
std::optional<NarrowPoint> certain(const Pair& pair, const std::vector<NarrowPoint>& narrow,
                                   const Between& sheet) {
    double last = 0;
    for (const NarrowPoint& point : narrow) last = std::max(last, point.first);
    for (int look = 0; look <= looks; ++look) {
        const double time = last * look / looks;
        for (const Vector3d& shift : {Vector3d(Vector3d::Zero()), sheet.flown(time)})
            if (auto found = crossed(pair, narrow, sheet, time, shift)) return found;
    }
    return std::nullopt;
}

/// Returns the point with the narrowest gap among the points that lie in the box through which the sheet
/// flies until their gap is too narrow; none if there is no such point.
std::optional<NarrowPoint> possible(const Pair& pair, const std::vector<NarrowPoint>& narrow,
                                    const Between& sheet) {
    Eigen::AlignedBox3d start;
    for (const Vector3d& point : sheet.points) start.extend(point);
    const Vector3d room = Vector3d::Constant(bend_slack * start.diagonal().norm() + sheet.thickness);
    start = Eigen::AlignedBox3d(start.min() - room, start.max() + room);
    std::optional<NarrowPoint> worst;
    for (const NarrowPoint& point : narrow) {
        if (point.first == 0) continue;  // the gap is too narrow from the start
        const Eigen::AlignedBox3d way = start.merged(start.translated(sheet.flown(point.first)));
        if (way.contains(pair.other->motion.at(point.first) * point.foot)) worst = narrower(worst, point);
    }
    return worst;
}

/// Points with the narrowest gaps between two obstacles in which a sheet certainly lies, and in which it
/// possibly lies.
struct Squeeze {
    std::optional<NarrowPoint> certain, possible;
};

Squeeze squeeze(const Between& sheet, const Obstacle& one, const Obstacle& other, double end) {
    Squeeze found;
    for (const auto& [from, onto] : {std::pair(&one, &other), std::pair(&other, &one)}) {
        const Pair pair{from, onto, feet(sheet, *from)};
        const std::vector<NarrowPoint> narrow =
            narrow_points(pair, moments_of(pair, end), (1 - noticed_squeeze) * sheet.thickness);
        if (narrow.empty()) continue;
        if (const auto point = certain(pair, narrow, sheet)) found.certain = narrower(found.certain, *point);
        if (const auto point = possible(pair, narrow, sheet))
            found.possible = narrower(found.possible, *point);
    }
    return found;
}

std::string message(const Scene& scene, const ObstacleSpec& one, const ObstacleSpec& other,
                    const std::string& sheet, double thickness, const NarrowPoint& point) {
    const auto when = [&](double time) { return time_text(fmt::format("{:.4g}", time), scene.time_unit()); };
    return fmt::format(
        "{}: by their keys the gap between obstacle.{} and obstacle.{} falls below {:.3g} m at {}, and to "
        "{:.3g} m at {}; {} is {:.3g} m thick there, and contact forces would grow without bound: keep the "
        "two {:.3g} m or more apart, or let one of them move freely (density, without keys)",
        one.where, one.name, other.name, thickness, when(point.first), point.gap, when(point.time), sheet,
        thickness, thickness);
}

}  // namespace

SqueezedSheets squeezed_sheets(const Scene& scene, const std::vector<SheetInput>& inputs,
                               const std::vector<Obstacle>& obstacles) {
    SqueezedSheets all;
    const double end = scene.is_static() ? scene.simulation.stepper.last_load : scene.duration;
    for (std::size_t s = 0; s < inputs.size(); ++s) {
        const Between sheet = between(inputs[s], scene.sheets[s], scene.simulation.stepper.gravity);
        const std::string name = "sheet." + scene.sheets[s].name;
        for (std::size_t one = 0; one < obstacles.size(); ++one)
            for (std::size_t other = 0; other < obstacles.size(); ++other) {
                // Each pair is checked once, with a moving obstacle first.
                if (!obstacles[one].moves() || one == other) continue;
                if (obstacles[other].moves() && other < one) continue;
                const Squeeze found = squeeze(sheet, obstacles[one], obstacles[other], end);
                const auto told = [&](const std::string& who, const NarrowPoint& point) {
                    return message(scene, scene.obstacles[one], scene.obstacles[other], who, sheet.thickness,
                                   point);
                };
                if (found.certain)
                    all.certain.push_back(told(name + ", which is between them,", *found.certain));
                else if (found.possible)
                    all.possible.push_back(told("if it gets between them, " + name, *found.possible));
            }
    }
    return all;
}

void warn_of_squeezes(const Scene& scene, const BuiltScene& built, std::vector<std::string>& warnings) {
    const SqueezedSheets found =
        squeezed_sheets(scene, built.inputs, built.options.stepper.contact.obstacles);
    for (const auto* some : {&found.certain, &found.possible})
        warnings.insert(warnings.end(), some->begin(), some->end());
}

}  // namespace sherd
