// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/trace/render_tracer.h"

#include "meshops/error.h"

namespace sherd {
namespace {

struct Valid {
    alignas(32) std::array<int, ray_packet> lanes;
};

template <class Rays>
Valid load(const RayPacket& rays, Rays& to) {
    Valid valid;
    for (int i = 0; i < ray_packet; ++i) {
        const RenderRay& ray = rays[i];
        valid.lanes[i] = ray.active ? -1 : 0;
        to.org_x[i] = ray.origin.x();
        to.org_y[i] = ray.origin.y();
        to.org_z[i] = ray.origin.z();
        to.dir_x[i] = ray.direction.x();
        to.dir_y[i] = ray.direction.y();
        to.dir_z[i] = ray.direction.z();
        to.tnear[i] = ray.nearest;
        to.tfar[i] = ray.reach;
        to.time[i] = 0;
        to.mask[i] = ~0u;
        to.id[i] = i;
        to.flags[i] = 0;
    }
    return valid;
}

}  // namespace

RenderTracer::RenderTracer(const RenderScene& scene)
    // A single thread builds the hierarchy, so that it never depends on how threads share the work.
    : device(rtcNewDevice("threads=1")), hierarchy(nullptr) {
    if (!device) throw Error("Embree cannot be started", Fault::run);
    hierarchy = rtcNewScene(device);
    rtcSetSceneFlags(hierarchy, RTC_SCENE_FLAG_ROBUST);
    for (const RenderMesh& mesh : scene.meshes)
        if (!mesh.triangles.empty()) add(mesh);
    rtcCommitScene(hierarchy);
    if (rtcGetDeviceError(device) != RTC_ERROR_NONE)
        throw Error("Embree cannot take the scene: not enough memory?", Fault::run);
}

RenderTracer::~RenderTracer() {
    rtcReleaseScene(hierarchy);
    rtcReleaseDevice(device);
}

void RenderTracer::add(const RenderMesh& mesh) {
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, mesh.vertices.data(),
                               0, sizeof(RenderVertex), mesh.vertices.size());
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.triangles.data(), 0,
                               sizeof(mesh.triangles[0]), mesh.triangles.size());
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(hierarchy, geometry, static_cast<unsigned>(meshes.size()));
    rtcReleaseGeometry(geometry);
    meshes.push_back(&mesh);
}

HitPacket RenderTracer::nearest_hits(const RayPacket& rays) const {
    RTCRayHit8 packet;
    const Valid valid = load(rays, packet.ray);
    for (int i = 0; i < ray_packet; ++i) {
        packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
        packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
    }
    find_nearest(valid.lanes.data(), hierarchy, packet);
    HitPacket hits;
    for (int i = 0; i < ray_packet; ++i)
        if (rays[i].active && packet.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID)
            hits[i] = {meshes[packet.hit.geomID[i]], packet.hit.primID[i], packet.hit.u[i], packet.hit.v[i],
                       packet.ray.tfar[i]};
    return hits;
}

std::array<bool, ray_packet> RenderTracer::occluded(const RayPacket& rays) const {
    RTCRay8 packet;
    const Valid valid = load(rays, packet);
    find_occluded(valid.lanes.data(), hierarchy, packet);
    std::array<bool, ray_packet> blocked{};
    for (int i = 0; i < ray_packet; ++i) blocked[i] = rays[i].active && packet.tfar[i] < 0;
    return blocked;
}

}  // namespace sherd
