// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>
#include <span>
#include <vector>

#include "app/render/embree.h"
#include "app/render/render_scene.h"

namespace sherd {

/// Rays are traced by eights, which is what the processor does at once.
constexpr int ray_packet = 8;

struct RenderRay {
    Eigen::Vector3f origin, direction;
    float nearest = 0;                                     ///< where it begins, in lengths of the direction
    float reach = std::numeric_limits<float>::infinity();  ///< where it ends
    bool active = false;
};

struct RenderHit {
    const RenderMesh* mesh = nullptr;  ///< none: nothing was hit
    std::uint32_t triangle = 0;
    float u = 0, v = 0;  ///< weights of the triangle's second and third corner
    float distance = std::numeric_limits<float>::infinity();
};

using RayPacket = std::array<RenderRay, ray_packet>;
using HitPacket = std::array<RenderHit, ray_packet>;

/// Embree's bounding volume hierarchy of a scene's meshes; it refers to the scene. May be used by several
/// threads at once.
class RenderTracer {
  public:
    explicit RenderTracer(const RenderScene& scene);
    ~RenderTracer();
    RenderTracer(const RenderTracer&) = delete;
    RenderTracer& operator=(const RenderTracer&) = delete;

    HitPacket nearest_hits(const RayPacket& rays) const;
    /// Whether something is in the way of each ray; false of those that are not active.
    std::array<bool, ray_packet> occluded(const RayPacket& rays) const;

  private:
    void add(const RenderMesh& mesh);

    RTCDevice device;
    RTCScene hierarchy;
    std::vector<const RenderMesh*> meshes;  ///< by Embree's number
};

}  // namespace sherd
