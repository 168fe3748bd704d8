// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/render/trace/camera.h"
#include "app/render/trace/render_scene.h"
#include "app/render/trace/render_tracer.h"
#include "meshops/attributes.h"

namespace sherd {

/// A point of a surface that is to be lit.
struct LitPoint {
    Eigen::Vector3f position;
    Eigen::Vector3f normal;  ///< unit, towards the side that is seen
    Eigen::Vector3f colour;  ///< albedo
    float gloss = 0;         ///< 0: matt
    float backdrop = 0;      ///< share of the backdrop in its light
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

/// Returns the point of a mesh that a ray hits.
LitPoint point_on_mesh(const RenderHit& hit, const RenderRay& ray);
/// Returns the point of a plane that a ray hits at a distance.
LitPoint point_on_plane(const RenderPlane& plane, const Studio& studio, const RenderRay& ray, float distance);

/// Returns the light of the backdrop, seen in a direction in which there is no mesh.
Eigen::Vector3f backdrop_light(const Studio& studio, const Eigen::Vector3f& direction);

/// Returns the light that comes from a direction of the dome. hidden: whether a mesh hides the dome there;
/// the mesh reflects a little light instead.
Eigen::Vector3f ambient_light(const Studio& studio, const Eigen::Vector3f& direction, bool hidden);

/// Returns the light that a point sends to the camera. seen_from: unit, direction of the ray that hit the
/// point; lamp_direction: unit, towards a point of the lamp; lamp_hidden: whether a mesh hides this point;
/// ambient: ambient_light() from a direction of the hemisphere, sampled by the cosine.
Eigen::Vector3f lit(const LitPoint& point, const Studio& studio, const Eigen::Vector3f& seen_from,
                    const Eigen::Vector3f& lamp_direction, bool lamp_hidden, const Eigen::Vector3f& ambient);

/// Returns linear light as sRGB, 0 to 1, with a soft shoulder at the bright end.
Eigen::Vector3f developed(const Eigen::Vector3f& light);

/// Returns the albedo, linear light, of a colour 0xRRGGBB (sRGB).
Eigen::Vector3f linear_colour(std::uint32_t rgb);
Eigen::Vector3f linear_colour(const Colour& colour);
/// Returns the colour 0xRRGGBB (sRGB) of an albedo.
std::uint32_t written_colour(const Eigen::Vector3f& albedo);

}  // namespace sherd
