// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/render/trace/camera.h"
#include "app/render/trace/render_scene.h"
#include "app/render/trace/render_tracer.h"
#include "meshops/attributes.h"

namespace sherd {

/// A point of a surface to be lit.
struct LitPoint {
    Eigen::Vector3f position;
    Eigen::Vector3f normal;  ///< unit, to the side that is seen
    Eigen::Vector3f colour;  ///< albedo
    float gloss = 0;         ///< 0: matt
    float backdrop = 0;      ///< 1: only the backdrop is left of it
};

/// Lighting of a picture: a large soft lamp beside the camera, a dome of light, and a backdrop into which the
/// ground fades.
struct Studio {
    Eigen::Vector3f up;
    Eigen::Vector3f lamp;     ///< unit, towards the lamp
    float lamp_width = 0.16;  ///< tangent of half the angle under which the lamp is seen
    Eigen::Vector3f centre;
    float radius;
};

Studio make_studio(const RenderScene& scene, const Camera& camera);

/// Point of a mesh that a ray hits.
LitPoint point_on_mesh(const RenderHit& hit, const RenderRay& ray);
/// Point of a plane that a ray hits at a distance.
LitPoint point_on_plane(const RenderPlane& plane, const Studio& studio, const RenderRay& ray, float distance);

/// Light of the backdrop from a direction without a mesh.
Eigen::Vector3f backdrop_light(const Studio& studio, const Eigen::Vector3f& direction);

/// Light of the dome from a direction; hidden: a mesh is in its way, which reflects a little.
Eigen::Vector3f ambient_light(const Studio& studio, const Eigen::Vector3f& direction, bool hidden);

/// Light from a point to the camera. seen_from: unit, the direction of the ray that hit it; ambient: light
/// from one direction of the hemisphere, sampled by cosine.
Eigen::Vector3f lit(const LitPoint& point, const Studio& studio, const Eigen::Vector3f& seen_from,
                    const Eigen::Vector3f& lamp_direction, bool lamp_hidden, const Eigen::Vector3f& ambient);

/// Converts linear light to sRGB, 0 to 1, with a soft shoulder at the bright end.
Eigen::Vector3f developed(const Eigen::Vector3f& light);

/// Albedo of a colour that is written as 0xRRGGBB (sRGB).
Eigen::Vector3f linear_colour(std::uint32_t rgb);
Eigen::Vector3f linear_colour(const Colour& colour);
/// Colour 0xRRGGBB (sRGB) of an albedo.
std::uint32_t written_colour(const Eigen::Vector3f& albedo);

}  // namespace sherd
