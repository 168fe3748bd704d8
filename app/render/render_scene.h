// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "app/files/image.h"

namespace sherd {

/// A corner of triangles that are to be drawn.
struct RenderVertex {
    Eigen::Vector3f position;  ///< m
    Eigen::Vector3f normal;    ///< unit, to the outside: how the surface is lit
    Eigen::Vector3f colour;    ///< albedo, linear light: red, green, blue
    Eigen::Vector3f material;  ///< m, a place that stays with the matter: at rest
    float stripe = 0;          ///< where it is near an even number is a stripe, if the mesh has them
    float broken = 0;          ///< 1: the rough inside that a crack laid open
    Eigen::Vector2f texture = Eigen::Vector2f::Zero();  ///< coordinates in the triangle's picture, v upwards
};

struct RenderMesh {
    std::vector<RenderVertex> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    bool striped = false;
    /// [T] number of the picture that each has instead of its colours, -1: none; empty: none has one.
    std::vector<std::int32_t> picture = {};
    std::vector<std::shared_ptr<const Image>> pictures = {};
};

/// A half-space behind a plane, seen from its front only.
struct RenderPlane {
    Eigen::Vector3f point;   ///< m
    Eigen::Vector3f normal;  ///< unit
};

/// What a picture shows. Further meshes, such as obstacles, are simply added.
struct RenderScene {
    std::vector<RenderMesh> meshes;
    std::vector<RenderPlane> planes;
    Eigen::Vector3f centre;  ///< m, of the action; the ground fades out around it
    Eigen::Vector3f up;      ///< unit
    float radius = 1;        ///< m, of the action
};

}  // namespace sherd
