// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "app/files/picture/image.h"

namespace sherd {

/// A vertex of triangles to be drawn.
struct RenderVertex {
    Eigen::Vector3f position;  ///< m
    Eigen::Vector3f normal;    ///< unit, outward, for shading
    Eigen::Vector3f colour;    ///< albedo, linear light: red, green, blue
    Eigen::Vector3f material;  ///< m, position at rest, to which patterns are fixed
    float stripe = 0;          ///< a stripe is where this is near an even number, if the mesh is striped
    float broken = 0;          ///< 1: on the surface of a crack
    Eigen::Vector2f texture = Eigen::Vector2f::Zero();  ///< coordinates in the triangle's picture, v upwards
};

struct RenderMesh {
    std::vector<RenderVertex> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    bool striped = false;
    /// [T] for each triangle, index in `pictures` of the picture that replaces its colours; -1: none. Empty:
    /// no triangle has a picture.
    std::vector<std::int32_t> picture = {};
    std::vector<std::shared_ptr<const Image>> pictures = {};
};

/// A plane that is seen only from the side to which its normal points.
struct RenderPlane {
    Eigen::Vector3f point;   ///< m
    Eigen::Vector3f normal;  ///< unit
};

/// Content of a picture: meshes of sheets, obstacles and other objects, and planes.
struct RenderScene {
    std::vector<RenderMesh> meshes;
    std::vector<RenderPlane> planes;
    Eigen::Vector3f centre;  ///< m, centre of the region in focus; the ground fades out around it
    Eigen::Vector3f up;      ///< unit
    float radius = 1;        ///< m, radius of the region in focus
};

}  // namespace sherd
