// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/trace/render_light.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/files/picture/image.h"
#include "app/render/trace/render_sample.h"

namespace sherd {
namespace {

using Eigen::Vector3f;

const Vector3f ground_colour(0.58f, 0.575f, 0.565f), lamp_light(1.02f, 0.97f, 0.89f),
    zenith_light(0.52f, 0.56f, 0.63f), horizon_light(0.34f, 0.36f, 0.40f), backdrop(0.52f, 0.53f, 0.545f),
    clay(0.62f, 0.52f, 0.41f), dark_stripe(0.02f, 0.09f, 0.22f);

/// Returns the linear light of an sRGB value; both are from 0 to 1.
float linear_part(float x) {
    return x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f);
}

float smooth(float low, float high, float x) {
    const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}

/// Returns the sRGB value of linear light; both are from 0 to 1.
float coded(float x) {
    return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f;
}

Vector3f mix(const Vector3f& a, const Vector3f& b, float t) {
    return a + t * (b - a);
}

std::uint32_t cell_hash(const Eigen::Vector3i& cell) {
    return scramble(
        static_cast<std::uint32_t>(cell.x()) +
        scramble(static_cast<std::uint32_t>(cell.y()) + scramble(static_cast<std::uint32_t>(cell.z()))));
}

/// Returns noise, from -1 to 1 in each component, that varies over distances of 1.
Vector3f noise(const Vector3f& place) {
    const Vector3f floor = place.array().floor();
    const Eigen::Vector3i cell = floor.cast<int>();
    const Vector3f t = place - floor;
    Vector3f sum = Vector3f::Zero();
    for (int corner = 0; corner < 8; ++corner) {
        const Eigen::Vector3i step(corner & 1, corner >> 1 & 1, corner >> 2);
        float weight = 1;
        for (int axis = 0; axis < 3; ++axis) weight *= step[axis] ? t[axis] : 1 - t[axis];
        const std::uint32_t hash = cell_hash(cell + step);
        sum += weight *
               Vector3f(unit_float(hash), unit_float(scramble(hash + 1)), unit_float(scramble(hash + 2)));
    }
    return 2 * sum - Vector3f::Ones();
}

Vector3f weighted(const RenderHit& hit, Vector3f RenderVertex::*member) {
    const auto& [a, b, c] = hit.mesh->triangles[hit.triangle];
    const auto& vertices = hit.mesh->vertices;
    return (1 - hit.u - hit.v) * vertices[a].*member + hit.u * vertices[b].*member +
           hit.v * vertices[c].*member;
}

float weighted(const RenderHit& hit, float RenderVertex::*member) {
    const auto& [a, b, c] = hit.mesh->triangles[hit.triangle];
    const auto& vertices = hit.mesh->vertices;
    return (1 - hit.u - hit.v) * vertices[a].*member + hit.u * vertices[b].*member +
           hit.v * vertices[c].*member;
}

/// Returns the colour of the triangle's picture at the hit, linear light; none without a picture.
std::optional<Vector3f> picture_colour(const RenderHit& hit) {
    const RenderMesh& mesh = *hit.mesh;
    if (mesh.picture.empty() || mesh.picture[hit.triangle] < 0) return std::nullopt;
    const auto& [a, b, c] = mesh.triangles[hit.triangle];
    const Eigen::Vector2f uv = (1 - hit.u - hit.v) * mesh.vertices[a].texture +
                               hit.u * mesh.vertices[b].texture + hit.v * mesh.vertices[c].texture;
    Vector3f colour = Vector3f::Zero();
    for (const WeightedColour& texel :
         texels_around(*mesh.pictures[mesh.picture[hit.triangle]], uv.cast<double>()))
        colour += static_cast<float>(texel.weight) * texel.colour.unaryExpr(&linear_part);
    return colour;
}

/// Makes a point rough and unglazed, like the surface of a crack, with grains that move with the material.
void roughen(LitPoint& point, const RenderHit& hit) {
    constexpr float grain = 6e-4f;  // m
    const Vector3f place = weighted(hit, &RenderVertex::material) / grain;
    const Vector3f coarse = noise(place), fine = noise(2.3f * place);
    point.colour = (0.86f + 0.16f * coarse.x() + 0.10f * fine.x()) * mix(clay, point.colour, 0.25f);
    point.normal = (point.normal + 0.35f * coarse + 0.25f * fine).normalized();
    point.gloss = 0;
}

}  // namespace

Studio make_studio(const RenderScene& scene, const Camera& camera) {
    const CameraAxes axes = camera_axes(camera);
    const Vector3f right = axes.right.cast<float>();
    const Vector3f back = right.cross(scene.up);  // horizontal, towards the camera
    Studio studio;
    studio.up = scene.up;
    studio.lamp = (0.80f * scene.up - 0.55f * right + 0.28f * back).normalized();
    studio.centre = scene.centre;
    studio.radius = scene.radius;
    return studio;
}

LitPoint point_on_mesh(const RenderHit& hit, const RenderRay& ray) {
    LitPoint point;
    point.position = ray.origin + hit.distance * ray.direction;
    point.normal = weighted(hit, &RenderVertex::normal).normalized();
    point.colour = weighted(hit, &RenderVertex::colour);
    if (const auto pictured = picture_colour(hit)) point.colour = *pictured;
    point.gloss = 0.5f;
    if (hit.mesh->striped) {
        const float stripe = weighted(hit, &RenderVertex::stripe);
        if (std::abs(std::remainder(stripe, 2.0f)) < 0.25f) point.colour = dark_stripe;
    }
    if (weighted(hit, &RenderVertex::broken) > 0.5f) roughen(point, hit);
    if (point.normal.dot(ray.direction) > 0) point.normal = -point.normal;
    return point;
}

LitPoint point_on_plane(const RenderPlane& plane, const Studio& studio, const RenderRay& ray,
                        float distance) {
    LitPoint point;
    point.position = ray.origin + distance * ray.direction;
    point.normal = plane.normal;
    point.colour = ground_colour;
    point.backdrop = smooth(1.5f, 6, (point.position - studio.centre).norm() / studio.radius);
    return point;
}

Vector3f backdrop_light(const Studio& studio, const Vector3f& direction) {
    const float height = direction.dot(studio.up);
    return mix(backdrop, zenith_light, 0.5f * smooth(0, 1, height));
}

Vector3f ambient_light(const Studio& studio, const Vector3f& direction, bool hidden) {
    const Vector3f light = mix(horizon_light, zenith_light, smooth(-0.2f, 1, direction.dot(studio.up)));
    return hidden ? Vector3f(0.12f * light) : light;
}

Vector3f lit(const LitPoint& point, const Studio& studio, const Vector3f& seen_from,
             const Vector3f& lamp_direction, bool lamp_hidden, const Vector3f& ambient) {
    const float facing = std::max(0.0f, point.normal.dot(lamp_direction));
    const Vector3f lamp = lamp_hidden ? Vector3f::Zero() : Vector3f(facing * lamp_light);
    Vector3f light = point.colour.cwiseProduct(lamp + ambient);
    if (point.gloss > 0) {
        // Fresnel's reflection by a glaze, in Schlick's approximation.
        const float grazing = 1 - std::max(0.0f, -seen_from.dot(point.normal));
        const float reflected =
            point.gloss * (0.04f + 0.5f * grazing * grazing * grazing * grazing * grazing);
        const Vector3f mirrored = seen_from - 2 * seen_from.dot(point.normal) * point.normal;
        light += reflected * ambient_light(studio, mirrored, false);
        if (!lamp_hidden && facing > 0) {
            const Vector3f half = (lamp_direction - seen_from).normalized();
            light += reflected * std::pow(std::max(0.0f, half.dot(point.normal)), 60.0f) * 8 * lamp_light;
        }
    }
    return light;
}

Vector3f developed(const Vector3f& light) {
    return light.unaryExpr([](float x) {
        const float bounded = x < 0.7f ? x : 0.7f + 0.3f * (1 - std::exp((0.7f - x) / 0.3f));
        return coded(std::clamp(bounded, 0.0f, 1.0f));
    });
}

std::uint32_t written_colour(const Vector3f& albedo) {
    std::uint32_t rgb = 0;
    for (const float part : albedo)
        rgb = rgb << 8 | static_cast<std::uint32_t>(coded(std::clamp(part, 0.0f, 1.0f)) * 255 + 0.5f);
    return rgb;
}

Vector3f linear_colour(std::uint32_t rgb) {
    const auto linear = [](std::uint32_t byte) { return linear_part(static_cast<float>(byte & 255) / 255); };
    return {linear(rgb >> 16), linear(rgb >> 8), linear(rgb)};
}

Vector3f linear_colour(const Colour& colour) {
    return linear_colour(static_cast<std::uint32_t>(colour[0] << 16 | colour[1] << 8 | colour[2]));
}

}  // namespace sherd
