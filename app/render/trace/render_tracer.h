// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>
#include <span>
#include <vector>

#include "app/render/trace/embree.h"
#include "app/render/trace/render_scene.h"

namespace sherd {

/// Number of rays in a packet, which the processor traces at once.
constexpr int ray_packet = 8;

struct RenderRay {
    Eigen::Vector3f origin, direction;
    float nearest = 0;                                     ///< begin of the ray, in lengths of `direction`
    float reach = std::numeric_limits<float>::infinity();  ///< end of the ray, in lengths of `direction`
    bool active = false;
};

struct RenderHit {
    const RenderMesh* mesh = nullptr;  ///< null: nothing was hit
    std::uint32_t triangle = 0;
    float u = 0, v = 0;  ///< weights of the triangle's second and third corner
    float distance = std::numeric_limits<float>::infinity();
};

using RayPacket = std::array<RenderRay, ray_packet>;
using HitPacket = std::array<RenderHit, ray_packet>;

/// Embree's bounding volume hierarchy of a scene's meshes. The scene must outlive this object. Several
/// threads may use the object at once.
class RenderTracer {
  public:
    explicit RenderTracer(const RenderScene& scene);
    ~RenderTracer();
    RenderTracer(const RenderTracer&) = delete;
    RenderTracer& operator=(const RenderTracer&) = delete;

    HitPacket nearest_hits(const RayPacket& rays) const;
    /// Returns whether a mesh occludes each ray; false for rays that are not active.
    std::array<bool, ray_packet> occluded(const RayPacket& rays) const;

  private:
    void add(const RenderMesh& mesh);

    RTCDevice device;
    RTCScene hierarchy;
    std::vector<const RenderMesh*> meshes;  ///< by Embree's geometry number
};

}  // namespace sherd
