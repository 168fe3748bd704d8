// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/trace/camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "app/messages/number_list.h"
#include "meshops/error.h"

namespace sherd {
namespace {

using Eigen::Vector3d;

constexpr double degree = std::numbers::pi / 180;
constexpr double most_zoom = 1e6, farthest = 1e12;  // beyond these limits rays lose all digits
constexpr double margin = 1.08;                     // size of the picture over size of its boxes

void check_angle(const std::string& text, double angle) {
    if (angle < 1 || angle > 120)
        throw Error(fmt::format("--camera {}: the angle of view must be 1 to 120 degrees", text));
}

/// Returns the direction from the scene to the eye.
Vector3d direction_of(const CameraChoice& choice, const Vector3d& up) {
    const Vector3d side = std::abs(up.x()) < 0.9 ? Vector3d::UnitX() : Vector3d::UnitY();
    const Vector3d front = side.cross(up).normalized(), right = up.cross(front);
    const double azimuth = choice.azimuth * degree, elevation = choice.elevation * degree;
    return std::cos(elevation) * (std::cos(azimuth) * front + std::sin(azimuth) * right) +
           std::sin(elevation) * up;
}

/// Interval along one of the picture's axes: the lines of sight through the outermost corners meet the plane
/// through the centre at its ends. `half` is half the length of the interval, `middle` the coordinate of its
/// middle, relative to the centre. slope: tangent of half the angle of view.
struct Span {
    double half, middle;
};

Span span_of(std::span<const Vector3d> corners, const Vector3d& axis, const Vector3d& forward, double slope) {
    double right = -std::numeric_limits<double>::infinity(), left = right;
    for (const Vector3d& corner : corners) {
        right = std::max(right, corner.dot(axis) - slope * corner.dot(forward));
        left = std::max(left, -corner.dot(axis) - slope * corner.dot(forward));
    }
    return {(right + left) / 2, (right - left) / 2};
}

Vector3d centre_of(std::span<const Eigen::AlignedBox3d> boxes) {
    Eigen::AlignedBox3d all;
    for (const Eigen::AlignedBox3d& box : boxes) all.extend(box);
    return all.center();
}

/// Returns the corners of the boxes relative to `centre`.
std::vector<Vector3d> corners_of(std::span<const Eigen::AlignedBox3d> boxes, const Vector3d& centre) {
    std::vector<Vector3d> corners;
    for (const Eigen::AlignedBox3d& box : boxes)
        for (int i = 0; i < 8; ++i)
            corners.push_back(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)) - centre);
    return corners;
}

}  // namespace

CameraAxes camera_axes(const Camera& camera) {
    CameraAxes axes;
    axes.forward = (camera.target - camera.eye).normalized();
    Vector3d right = axes.forward.cross(camera.up);
    if (right.norm() < 1e-6) right = axes.forward.unitOrthogonal();  // the camera looks straight down or up
    axes.right = right.normalized();
    axes.top = axes.right.cross(axes.forward);
    return axes;
}

CameraChoice parse_camera(const std::string& text) {
    const std::vector<double> n = number_list("--camera", text);
    if (std::ranges::any_of(n, [](double number) { return std::abs(number) > farthest; }))
        throw Error(fmt::format("--camera {}: numbers are at most {:g}", text, farthest));
    CameraChoice choice;
    if (n.size() == 2 || n.size() == 3) {
        choice.azimuth = n[0];
        choice.elevation = n[1];
        if (n.size() == 3) choice.zoom = n[2];
        if (std::abs(choice.elevation) > 90)
            throw Error(fmt::format("--camera {}: the elevation must be -90 to 90 degrees", text));
        if (!(choice.zoom >= 1 / most_zoom && choice.zoom <= most_zoom))
            throw Error(
                fmt::format("--camera {}: the zoom must be {:g} to {:g}", text, 1 / most_zoom, most_zoom));
    } else if (n.size() == 6 || n.size() == 7) {
        choice.eye = Vector3d(n[0], n[1], n[2]);
        choice.target = Vector3d(n[3], n[4], n[5]);
        if (n.size() == 7) choice.view_angle = n[6];
        check_angle(text, choice.view_angle);
        if (*choice.eye == *choice.target)
            throw Error(fmt::format("--camera {}: the eye is at the target", text));
    } else {
        throw Error(
            fmt::format("--camera {}: give AZIMUTH,ELEVATION or AZIMUTH,ELEVATION,ZOOM (degrees), or eye and "
                        "target as X,Y,Z,X,Y,Z (m), with an angle of view (degrees) if wanted",
                        text));
    }
    return choice;
}

Camera place_camera(const CameraChoice& choice, std::span<const Eigen::AlignedBox3d> boxes,
                    const Vector3d& up, double aspect) {
    const Vector3d centre = centre_of(boxes);
    Camera camera{.eye = Vector3d::Zero(), .target = centre, .up = up, .view_angle = choice.view_angle};
    if (choice.eye) {
        camera.eye = *choice.eye;
        camera.target = *choice.target;
        return camera;
    }
    camera.eye = centre + direction_of(choice, up);
    const CameraAxes axes = camera_axes(camera);
    const std::vector<Vector3d> corners = corners_of(boxes, centre);
    const double slope = std::tan(camera.view_angle * degree / 2) / margin;
    const Span wide = span_of(corners, axes.right, axes.forward, slope * aspect);
    const Span high = span_of(corners, axes.top, axes.forward, slope);
    const double distance = std::max({wide.half / (slope * aspect), high.half / slope, 1e-6}) / choice.zoom;
    camera.target += wide.middle * axes.right + high.middle * axes.top;
    camera.eye = camera.target - distance * axes.forward;
    return camera;
}

}  // namespace sherd
