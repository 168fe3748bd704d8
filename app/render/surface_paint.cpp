// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/surface_paint.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/render/trace/render_light.h"
#include "meshops/error.h"
#include "meshops/shared_values.h"

namespace sherd {

using Eigen::Vector3f;

void require_paint(const SurfaceLook& look) {
    if (!look.paints())
        throw Error(
            "--color material: the recording has no materials and no colours; they are those of meshes from "
            ".obj (usemtl) and .ply, recorded by this version or a later one");
}

std::string unread_picture(const SurfaceMaterial& material, const std::exception& error) {
    return fmt::format("the material '{}' is drawn in one colour: {}", material.name, error.what());
}

SurfacePaint::SurfacePaint(const SurfaceLook& look, std::vector<std::string>& warnings) {
    require_paint(look);
    for (const SurfaceMaterial& material : shared_values(look.material).rows) add(material, warnings);
}

void SurfacePaint::add(const SurfaceMaterial& material, std::vector<std::string>& warnings) {
    const MaterialLook look = material_look(material);
    known.push_back({material, look.colour, -1});
    if (look.picture.empty()) return;
    try {
        pictures.push_back(std::make_shared<const Image>(read_picture(look.picture)));
        known.back().picture = static_cast<std::int32_t>(pictures.size()) - 1;
    } catch (const Error& error) {
        warnings.push_back(unread_picture(material, error));
    }
}

std::vector<const SurfacePaint::Known*> SurfacePaint::known_of(
    const std::vector<SurfaceMaterial>& materials) const {
    std::vector<const Known*> result;
    for (const SurfaceMaterial& material : materials) {
        const auto found = std::ranges::find(known, material, &Known::material);
        result.push_back(found == known.end() ? nullptr : &*found);
    }
    return result;
}

SheetPaint SurfacePaint::paint(const Snapshot& frame, const Vector3f& plain) const {
    const SurfaceLook& look = frame.rest.look;
    const bool is_coloured = look.has_colours();
    const SharedValues<SurfaceMaterial> shared = shared_values(look.material);
    const std::vector<const Known*> materials = known_of(shared.rows);
    SheetPaint paint;
    paint.colour.assign(frame.position.cols(), plain);
    paint.texture = look.texture;
    paint.pictures = pictures;
    for (std::size_t f = 0; f < frame.faces.size(); ++f) {
        const Index number = shared.number.empty() ? -1 : shared.number[f];
        const Known* material = number < 0 ? nullptr : materials[number];
        const Vector3f base = material ? material->colour : is_coloured ? Vector3f(Vector3f::Ones()) : plain;
        auto& corners = paint.corner_colour.emplace_back();
        for (int k = 0; k < 3; ++k)
            corners[k] = base.cwiseProduct(linear_colour(look.colour(f, frame.original[frame.faces[f][k]])));
        paint.picture.push_back(material && !look.texture.empty() ? material->picture : -1);
    }
    return paint;
}

}  // namespace sherd
