// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/render/camera.h"
#include "app/render/render_scene.h"
#include "app/render/render_tracer.h"
#include "meshops/surface_colour.h"

namespace sherd {

/// A point that is to be lit.
struct LitPoint {
    Eigen::Vector3f position;
    Eigen::Vector3f normal;  ///< unit, to the side that is seen
    Eigen::Vector3f colour;  ///< albedo
    float gloss = 0;         ///< 0: matt
    float backdrop = 0;      ///< 1: nothing of it is left before the backdrop
};

/// A studio: a large soft lamp beside the camera, a dome of light, and a backdrop that the ground fades into.
struct Studio {
    Eigen::Vector3f up;
    Eigen::Vector3f lamp;     ///< unit, towards it
    float lamp_width = 0.16;  ///< tangent of half the angle under which it is seen
    Eigen::Vector3f centre;
    float radius;
};

Studio make_studio(const RenderScene& scene, const Camera& camera);

/// What a ray sees of a mesh.
LitPoint point_on_mesh(const RenderHit& hit, const RenderRay& ray);
/// What a ray sees of a plane, `distance` away.
LitPoint point_on_plane(const RenderPlane& plane, const Studio& studio, const RenderRay& ray, float distance);

/// Light that comes from a direction in which there is no mesh.
Eigen::Vector3f backdrop_light(const Studio& studio, const Eigen::Vector3f& direction);

/// Light of the dome from a direction; hidden: a mesh is in its way, which sends back a little of its own.
Eigen::Vector3f ambient_light(const Studio& studio, const Eigen::Vector3f& direction, bool hidden);

/// Light from a point to the camera. seen_from: unit, the direction of the ray that found it; ambient: light
/// from one direction of the hemisphere, drawn by cosine.
Eigen::Vector3f lit(const LitPoint& point, const Studio& studio, const Eigen::Vector3f& seen_from,
                    const Eigen::Vector3f& lamp_direction, bool lamp_hidden, const Eigen::Vector3f& ambient);

/// Linear light to what a screen shows, 0 to 1: soft at the bright end, coded as sRGB.
Eigen::Vector3f developed(const Eigen::Vector3f& light);

/// The albedo of a colour that is written as 0xRRGGBB (sRGB).
Eigen::Vector3f linear_colour(std::uint32_t rgb);
Eigen::Vector3f linear_colour(const Colour& colour);
/// The reverse.
std::uint32_t written_colour(const Eigen::Vector3f& albedo);

}  // namespace sherd
