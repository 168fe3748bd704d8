// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/trace/render_picture.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <thread>

#include "app/render/trace/render_light.h"
#include "app/render/trace/render_sample.h"
#include "app/render/trace/render_tracer.h"

namespace sherd {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

/// Purposes of the points of a SamplePattern.
enum Purpose : std::uint32_t { within_pixel, over_lamp, over_hemisphere };

class Painter {
  public:
    Painter(const RenderScene& scene, const Camera& camera, const PictureOptions& options)
        : scene(scene),
          options(options),
          tracer(scene),
          studio(make_studio(scene, camera)),
          axes(camera_axes(camera)),
          eye(camera.eye.cast<float>()),
          slope(static_cast<float>(std::tan(camera.view_angle * std::numbers::pi / 360))) {}

    Vector3f pixel(int column, int row) const;

  private:
    RenderRay camera_ray(int column, int row, const Vector2f& within) const;
    LitPoint seen(const RenderRay& ray, const RenderHit& hit) const;
    RenderRay secondary(const LitPoint& point, const Vector3f& direction, float reach) const;
    Vector3f packet(int column, int row, int first) const;

    const RenderScene& scene;
    const PictureOptions& options;
    RenderTracer tracer;
    Studio studio;
    CameraAxes axes;
    Vector3f eye;
    float slope;  ///< tangent of half the angle of view
};

RenderRay Painter::camera_ray(int column, int row, const Vector2f& within) const {
    const float pixel = 2 * slope / static_cast<float>(options.height);
    const float x =
        (static_cast<float>(column) + within.x() - 0.5f * static_cast<float>(options.width)) * pixel;
    const float y =
        (0.5f * static_cast<float>(options.height) - static_cast<float>(row) - within.y()) * pixel;
    RenderRay ray;
    ray.origin = eye;
    ray.direction =
        (axes.forward.cast<float>() + x * axes.right.cast<float>() + y * axes.top.cast<float>()).normalized();
    ray.active = true;
    return ray;
}

/// Returns the point that a ray from the camera sees: on the nearest plane, if that is nearer than the hit;
/// otherwise on the mesh that is hit; otherwise on the backdrop.
LitPoint Painter::seen(const RenderRay& ray, const RenderHit& hit) const {
    float nearest = hit.distance;
    const RenderPlane* front = nullptr;
    for (const RenderPlane& plane : scene.planes) {
        const float approach = -plane.normal.dot(ray.direction);
        const float distance = plane.normal.dot(ray.origin - plane.point) / approach;
        if (approach <= 0 || distance <= 0 || distance >= nearest) continue;
        nearest = distance;
        front = &plane;
    }
    if (front) return point_on_plane(*front, studio, ray, nearest);
    if (hit.mesh) return point_on_mesh(hit, ray);
    return {.position = Vector3f::Zero(), .normal = studio.up, .colour = Vector3f::Zero(), .backdrop = 1};
}

RenderRay Painter::secondary(const LitPoint& point, const Vector3f& direction, float reach) const {
    // The ray starts far enough from the surface for round-off, but nearer than the other side of any sheet.
    const float offset = 2e-5f * scene.radius;
    RenderRay ray;
    ray.origin = point.position + offset * point.normal;
    ray.direction = direction;
    ray.nearest = offset;
    ray.reach = reach;
    ray.active = point.backdrop < 1;
    return ray;
}

/// Returns the sum of the light of up to eight samples of a pixel, from sample `first` on.
Vector3f Painter::packet(int column, int row, int first) const {
    const int count = std::min(ray_packet, options.samples - first);
    const auto pixel = static_cast<std::uint32_t>(row) * static_cast<std::uint32_t>(options.width) +
                       static_cast<std::uint32_t>(column);
    const SamplePattern within(pixel, within_pixel, options.samples), lamp(pixel, over_lamp, options.samples),
        dome(pixel, over_hemisphere, options.samples);
    RayPacket rays, to_lamp, to_dome;
    for (int i = 0; i < ray_packet; ++i) {
        rays[i] = camera_ray(column, row, within.point(first + i));
        rays[i].active = i < count;
    }
    const HitPacket hits = tracer.nearest_hits(rays);
    std::array<LitPoint, ray_packet> points;
    for (int i = 0; i < ray_packet; ++i) {
        points[i] = seen(rays[i], hits[i]);
        to_lamp[i] =
            secondary(points[i], cone_direction(studio.lamp, studio.lamp_width, lamp.point(first + i)),
                      std::numeric_limits<float>::infinity());
        to_dome[i] = secondary(points[i], cosine_direction(points[i].normal, dome.point(first + i)),
                               2.5f * scene.radius);
        to_lamp[i].active &= i < count && points[i].normal.dot(to_lamp[i].direction) > 0;
        to_dome[i].active &= i < count;
    }
    const auto lamp_hidden = tracer.occluded(to_lamp), dome_hidden = tracer.occluded(to_dome);
    Vector3f sum = Vector3f::Zero();
    for (int i = 0; i < count; ++i) {
        const Vector3f light = lit(points[i], studio, rays[i].direction, to_lamp[i].direction, lamp_hidden[i],
                                   ambient_light(studio, to_dome[i].direction, dome_hidden[i]));
        sum += light + points[i].backdrop * (backdrop_light(studio, rays[i].direction) - light);
    }
    return sum;
}

Vector3f Painter::pixel(int column, int row) const {
    Vector3f sum = Vector3f::Zero();
    for (int first = 0; first < options.samples; first += ray_packet) sum += packet(column, row, first);
    return developed(sum / static_cast<float>(options.samples));
}

}  // namespace

std::optional<Image> render_picture(const RenderScene& scene, const Camera& camera,
                                    const PictureOptions& options, const std::function<bool()>& stop) {
    const Painter painter(scene, camera, options);
    Image image;
    image.width = options.width;
    image.height = options.height;
    image.colours.resize(3, static_cast<Eigen::Index>(options.width) * options.height);
    std::atomic<int> next_row = 0;
    std::atomic<bool> stopped = false;
    const auto paint_rows = [&] {
        for (int row = next_row++; row < options.height; row = next_row++) {
            if (stop()) stopped = true;
            if (stopped) return;
            for (int column = 0; column < options.width; ++column)
                image.colours.col(static_cast<Eigen::Index>(row) * options.width + column) =
                    painter.pixel(column, row);
        }
    };
    const int threads = options.threads > 0
                            ? options.threads
                            : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    std::vector<std::jthread> helpers;
    for (int i = 1; i < threads; ++i) helpers.emplace_back(paint_rows);
    paint_rows();
    helpers.clear();
    if (stopped) return std::nullopt;
    return image;
}

}  // namespace sherd
