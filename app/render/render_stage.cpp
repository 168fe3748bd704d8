// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/render_stage.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/render/focus.h"
#include "app/render/render_obstacle.h"
#include "app/render/render_stripes.h"
#include "app/render/render_tip.h"
#include "app/render/trace/render_light.h"
#include "app/scene/read/scene.h"
#include "meshops/error.h"

namespace sherd {
namespace {

// Quantile that has the brightest colour, so that a single splinter does not darken the rest.
constexpr double largest_share = 0.99;

constexpr double largest_widening = 2;  // factor by which an obstacle may widen the picture

// Radius of a tip's ball: over RenderStage::radius(), and, if that gives more, over the thickness of the
// sheet, from which the ball must protrude.
constexpr double tip_size = 0.022, tip_thickness = 1.1;
// Length of a tip's cone over the radius of the tip's ball, for a tip at rest and for the fastest tip.
constexpr double tip_reach = 2, fastest_reach = 5;
constexpr double brightest_tip = 2;  // G / G_c of the brightest colour; a tip propagates above 1

double released_over_toughness(const TipRecord& tip) {
    return tip.released / tip.toughness;
}

}  // namespace

Scene recorded_scene(const RecordingHeader& header) {
    return parse_scene(header.scene_text, header.scene_file, recorded_choice(header.scene_text));
}

RenderStage::RenderStage(const Recording& recording, const StageOptions& options,
                         std::vector<std::string>& warnings)
    : options(options), header(recording.header()), obstacles(recording.obstacles()) {
    if (!recording.recovery().empty()) warnings.push_back(recording.recovery());
    for (const RecordedMode& mode : recording.modes())
        modes.push_back(fmt::format("mode {}: {}", modes.size() + 1, mode.words()));
    read_scene(warnings);
    find_thickness(warnings);
    measure(recording);
    if (options.colour == RenderColour::tips) measure_tips(recording);
    measure_obstacles(recording);
    if (options.colour == RenderColour::material) surface.emplace(header.rest_look, warnings);
    if (options.colour == RenderColour::axis) {
        double area = 0;
        for (const double a : header.rest_area) area += a;
        stripes = axis_stripes(header, recorded_axes(*scene_spec, header, warnings), std::sqrt(area) / 30);
    }
    placed = place_camera(options.camera, boxes, up, options.aspect);
    placed.eye -= centre();
    placed.target -= centre();
    if (options.ground) add_ground();
}

void RenderStage::read_scene(std::vector<std::string>& warnings) {
    try {
        scene_spec = recorded_scene(header);
        if (scene_spec->sheets.size() != header.sheet_names.size())
            throw Error(fmt::format("it has {} sheets, the recording {}", scene_spec->sheets.size(),
                                    header.sheet_names.size()));
        if (!scene_spec->simulation.stepper.gravity.isZero(0))
            up = -scene_spec->simulation.stepper.gravity.normalized();
    } catch (const Error& error) {
        if (options.colour == RenderColour::axis) throw;
        scene_spec.reset();
        warnings.push_back(
            fmt::format("the scene in the recording cannot be read, so z points up in the picture{}: {}",
                        has_planes() ? "" : " and the scene's planes are missing", error.what()));
    }
}

void RenderStage::find_thickness(std::vector<std::string>& warnings) {
    if (!header.rest_thickness.empty()) return;
    const Positions& rest = header.rest_position;
    const double guess = 0.005 * (rest.rowwise().maxCoeff() - rest.rowwise().minCoeff()).norm();
    guessed_thickness = guess;
    warnings.push_back(
        fmt::format("the recording, made by an earlier version, does not say how thick its "
                    "sheets are: they are drawn {:.2g} m thick, which is a guess",
                    guess));
}

void RenderStage::measure(const Recording& recording) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    lowest = infinity;
    extent = {infinity, -infinity};
    for (std::size_t i = 0; i < recording.frame_count(); ++i) {
        const Snapshot frame = recording.frame(i);
        for (Eigen::Index v = 0; v < frame.position.cols(); ++v) {
            const Vector3d p = frame.position.col(v);
            if (!p.allFinite()) continue;
            box.extend(p);
            lowest = std::min(lowest, p.dot(up));
        }
        const Eigen::AlignedBox3d shown = focus_box(frame);
        if (!shown.isEmpty()) boxes.push_back(shown);
        focus.extend(shown);
        end = frame.time;
        measure_scalar(render_scalar(frame, options.colour));
    }
    if (focus.isEmpty())
        throw Error("the recording has no frame with finite positions, so there is nothing to draw");
    if (options.range) range = *options.range;
    if (!(range.second > range.first)) range.second = range.first + 1;  // all values are equal
}

void RenderStage::measure_scalar(RenderScalar scalar) {
    for (const double value : scalar.values) {
        if (!std::isfinite(value)) continue;
        extent.first = std::min(extent.first, value);
        extent.second = std::max(extent.second, value);
    }
    range.second = std::max(range.second, quantile(std::move(scalar.values), largest_share));
    scalar_name = scalar.name;
    scalar_unit = scalar.unit;
}

void RenderStage::measure_tips(const Recording& recording) {
    tips.emplace(recording);
    if (tips->empty())
        throw Error(
            "--color tips: the recording has no crack tips; they are recorded for sheets with "
            "fracture.toughness in which a crack has started, by this version or a later one");
    scalar_name = "G / G_c of tips";
    for (const TipRecord& tip : recording.events().tips) {
        extent.first = std::min(extent.first, released_over_toughness(tip));
        extent.second = std::max(extent.second, released_over_toughness(tip));
    }
    if (!options.range) range = {0, brightest_tip};
}

void RenderStage::measure_obstacles(const Recording& recording) {
    if (obstacles.empty()) return;
    std::vector<Eigen::AlignedBox3d> around(obstacles.size());
    for (std::size_t i = 0; i < recording.frame_count(); ++i) {
        const std::vector<Eigen::Isometry3d> poses = recording.poses(i);
        const ObstacleShapes shapes = recording.shapes(i);
        for (std::size_t k = 0; k < obstacles.size(); ++k)
            if (!obstacles[k].plane && poses[k].matrix().allFinite())
                around[k].extend(box_of(reshaped(obstacles[k].surface, shapes[k]), poses[k]));
    }
    for (const Eigen::AlignedBox3d& obstacle : around) {
        // An obstacle that would make the sheets small need not fit into the picture, which cuts it off.
        const double widened = focus.merged(obstacle).diagonal().norm();
        if (obstacle.isEmpty() || !(widened <= largest_widening * focus.diagonal().norm())) continue;
        boxes.push_back(obstacle);
        for (int corner = 0; corner < 8; ++corner)
            lowest = std::min(lowest,
                              obstacle.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)).dot(up));
    }
}

void RenderStage::add_ground() {
    const auto add = [&](const Vector3d& point, const Vector3d& normal) {
        planes.push_back({(point - centre()).cast<float>(), normal.cast<float>()});
    };
    if (has_planes()) return;
    if (scene_spec)  // a recording of an older version
        for (const ObstacleSpec& obstacle : scene_spec->obstacles)
            if (const auto* plane = std::get_if<PlaneShape>(&obstacle.shape))
                add(plane->point, plane->normal.normalized());
    if (planes.empty()) add((lowest - 0.01 * focus.diagonal().norm()) * up, up);
}

SheetPaint RenderStage::paint(const Snapshot& frame) const {
    if (surface) return surface->paint(frame, linear_colour(porcelain));
    SheetPaint paint;
    paint.colour.assign(frame.position.cols(), linear_colour(porcelain));
    if (options.colour == RenderColour::fragment)
        for (std::size_t f = 0; f < frame.faces.size(); ++f)
            for (const Index v : frame.faces[f])
                paint.colour[v] = linear_colour(fragment_colour(frame.face_fragment[f]));
    const std::vector<double> values = render_scalar(frame, options.colour).values;
    for (std::size_t v = 0; v < values.size(); ++v) paint.colour[v] = linear_colour(scalar_colour(values[v]));
    if (options.colour == RenderColour::axis)
        paint.stripe = stripes_of_parts(frame.rest, stripes).cast<float>();
    return paint;
}

std::uint32_t RenderStage::scalar_colour(double value) const {
    return map_colour((value - range.first) / (range.second - range.first));
}

RenderMesh RenderStage::tips_of(const Snapshot& frame) const {
    const std::vector<double> thickness = thickness_of(frame);
    const double size = std::max(tip_size * radius(), tip_thickness * *std::ranges::max_element(thickness));
    const double fastest = std::max(tips->fastest(), std::numeric_limits<double>::min());
    std::vector<TipMark> marks;
    for (const TipRecord& tip : tips->at(frame.step, frame.time)) {
        const double reach = tip_reach + (fastest_reach - tip_reach) * tip.speed / fastest;
        marks.push_back({tip.position, tip.direction.stableNormalized(), size, reach * size,
                         linear_colour(scalar_colour(released_over_toughness(tip)))});
    }
    return tip_marks(marks, centre());
}

std::vector<double> RenderStage::thickness_of(const Snapshot& frame) const {
    if (!guessed_thickness) return frame.rest.thickness;
    return std::vector<double>(frame.faces.size(), *guessed_thickness);
}

RenderScene RenderStage::scene(const Snapshot& frame, std::span<const Eigen::Isometry3d> poses,
                               const ObstacleShapes& shapes) const {
    RenderScene scene;
    scene.meshes.push_back(sheet_solid(frame, thickness_of(frame), paint(frame), centre()));
    for (std::size_t i = 0; i < poses.size(); ++i)
        if (!obstacles[i].plane && poses[i].matrix().allFinite())
            scene.meshes.push_back(
                obstacle_solid(reshaped(obstacles[i].surface, shapes[i]), poses[i], centre()));
    if (tips) scene.meshes.push_back(tips_of(frame));
    scene.planes = ground(poses);
    scene.centre = Eigen::Vector3f::Zero();
    scene.up = up.cast<float>();
    scene.radius = static_cast<float>(radius());
    return scene;
}

std::vector<RenderPlane> RenderStage::ground(std::span<const Eigen::Isometry3d> poses) const {
    std::vector<RenderPlane> all = planes;
    for (std::size_t i = 0; i < poses.size(); ++i)
        if (options.ground && obstacles[i].plane)
            all.push_back(plane_of(obstacles[i].surface, poses[i], centre()));
    return all;
}

bool RenderStage::has_planes() const {
    return std::ranges::any_of(obstacles, &RecordedObstacle::plane);
}

double RenderStage::radius() const {
    return std::max(focus.diagonal().norm() / 2, 1e-6);
}

std::string RenderStage::legend() const {
    if (options.colour == RenderColour::axis) return "stripes: along the first axis of the material";
    if (scalar_name.empty()) return "";
    const std::string unit = scalar_unit.empty() ? "" : " " + scalar_unit;
    return fmt::format("{}: {:.4g}{} (dark violet) to {:.4g}{} (yellow)", scalar_name, range.first, unit,
                       range.second, unit);
}

std::optional<ColourBar> RenderStage::colour_bar() const {
    if (scalar_name.empty()) return std::nullopt;
    return make_colour_bar(scalar_name, scalar_unit, range, extent);
}

std::string RenderStage::caption(const Snapshot& frame) const {
    if (frame.step >= 1 && frame.step <= static_cast<std::int64_t>(modes.size()))
        return modes[frame.step - 1];
    return time_caption(frame.time, frame.step, end, header.time_unit);
}

}  // namespace sherd
