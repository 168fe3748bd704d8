// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "app/files/picture/image.h"

namespace sherd {

/// A corner of triangles to be drawn.
struct RenderVertex {
    Eigen::Vector3f position;  ///< m
    Eigen::Vector3f normal;    ///< unit, outward, for shading
    Eigen::Vector3f colour;    ///< albedo, linear light: red, green, blue
    Eigen::Vector3f material;  ///< m, position at rest, to which patterns are fixed
    float stripe = 0;          ///< a stripe lies where it is near an even number, if the mesh has stripes
    float broken = 0;          ///< 1: on the surface of a crack
    Eigen::Vector2f texture = Eigen::Vector2f::Zero();  ///< coordinates in the triangle's picture, v upwards
};

struct RenderMesh {
    std::vector<RenderVertex> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    bool striped = false;
    /// [T] index of each triangle's picture instead of its colours, -1: none; empty: none at all.
    std::vector<std::int32_t> picture = {};
    std::vector<std::shared_ptr<const Image>> pictures = {};
};

/// A half-space behind a plane, seen from its front only.
struct RenderPlane {
    Eigen::Vector3f point;   ///< m
    Eigen::Vector3f normal;  ///< unit
};

/// Content of a picture. Further meshes, such as obstacles, are simply added.
struct RenderScene {
    std::vector<RenderMesh> meshes;
    std::vector<RenderPlane> planes;
    Eigen::Vector3f centre;  ///< m, of the region in focus; the ground fades out around it
    Eigen::Vector3f up;      ///< unit
    float radius = 1;        ///< m, of the region in focus
};

}  // namespace sherd
