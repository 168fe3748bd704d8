// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/attributes.h"

#include <algorithm>
#include <cmath>

namespace sherd {
namespace {

constexpr std::size_t count_lists() {
    std::size_t count = 0;
    visit_surface_attributes([&](const auto&) { ++count; });
    return count;
}
static_assert(sizeof(SurfaceLook) == count_lists() * sizeof(std::vector<int>),
              "visit_surface_attributes() must visit every list of SurfaceLook");

}  // namespace

bool SurfaceLook::operator==(const SurfaceLook& other) const {
    bool same = true;
    visit_surface_attributes([&](const auto& attribute) {
        same = same && std::ranges::equal(this->*attribute.list, other.*attribute.list,
                                          [](const auto& one, const auto& two) { return is_same(one, two); });
    });
    return same;
}

bool SurfaceLook::paints() const {
    return has_colours() || std::ranges::any_of(material, [](const auto& one) { return one != nullptr; });
}

Colour SurfaceLook::colour(std::size_t face, std::size_t vertex) const {
    if (!vertex_colour.empty()) return vertex_colour[vertex];
    return face_colour.empty() ? white : face_colour[face];
}

Colour Mean<Colour>::value() const {
    Colour colour;
    std::ranges::transform(sum, colour.begin(), [](double part) {
        return static_cast<std::uint8_t>(std::lround(std::clamp(part, 0.0, 255.0)));
    });
    return colour;
}

SurfaceLook surface_look(const Mesh& mesh, std::span<const std::int32_t> rows, std::size_t count) {
    SurfaceLook look;
    visit_attributes_of<Vertex>([&](const auto& attribute) {
        const auto [values, exists] = find_property(mesh, attribute);
        if (!exists) return;
        auto& list = look.*attribute.list;
        list.assign(count, attribute.missing());
        for (const Vertex vertex : mesh.vertices()) list[rows[vertex.idx()]] = values[vertex];
    });
    visit_attributes_of<Face>([&](const auto& attribute) {
        if (const auto [values, exists] = find_property(mesh, attribute); exists)
            for (const Face face : mesh.faces()) (look.*attribute.list).push_back(values[face]);
    });
    return look;
}

void take_properties(Mesh& mesh, const Mesh& other) {
    visit_surface_attributes([&](const auto& attribute) {
        if (find_property(other, attribute).second) add_property(mesh, attribute);
    });
}

}  // namespace sherd
