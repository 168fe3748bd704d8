// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <span>
#include <string>

namespace sherd {

/// A pinhole camera; all lengths in m.
struct Camera {
    Eigen::Vector3d eye, target, up;
    double view_angle = 28;  ///< degrees, over the picture's height
};

/// Three perpendicular unit vectors: the directions of the picture's right and top side, and the direction of
/// view.
struct CameraAxes {
    Eigen::Vector3d right, top, forward;
};

CameraAxes camera_axes(const Camera& camera);

/// Position of a camera, as the command line gives it: by the direction from which it looks at the scene, or
/// by coordinates.
struct CameraChoice {
    double azimuth = 20;    ///< degrees, from the front to the right, about the direction that is up
    double elevation = 28;  ///< degrees above the horizon
    double zoom = 1;        ///< 2: everything is twice as large as when it just fits into the picture
    std::optional<Eigen::Vector3d> eye = {}, target = {};  ///< m; both are given, or none
    double view_angle = 28;                                ///< degrees
};

/// Reads `AZIMUTH,ELEVATION[,ZOOM]` or `X,Y,Z,X,Y,Z[,ANGLE]`: eye, target, angle of view over the height.
/// Throws Error (input) if the text has another form, or if a number is out of range.
CameraChoice parse_camera(const std::string& text);

/// Returns the camera of a choice. If the choice has no coordinates, all boxes (m) are in the picture when
/// the zoom is 1. up: a unit vector; the front is at -y if up is z. aspect: width over height of the picture.
Camera place_camera(const CameraChoice& choice, std::span<const Eigen::AlignedBox3d> boxes,
                    const Eigen::Vector3d& up, double aspect);

}  // namespace sherd
