// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/build/texture.h"

#include <fmt/format.h>

#include <cmath>

#include "app/words/place_words.h"
#include "meshops/error.h"

namespace sherd {
namespace {

/// The two texels beside a texture coordinate, and how near it is to the second.
struct Neighbours {
    int low, high;
    double weight;
};

Neighbours neighbours(double coordinate, int count) {
    const double at = (coordinate - std::floor(coordinate)) * count - 0.5, low = std::floor(at);
    const auto wrapped = [count](double index) { return (static_cast<int>(index) + count) % count; };
    return {wrapped(low), wrapped(low + 1), at - low};
}

}  // namespace

Mesh::Property_map<Face, FaceTexture> texture_coordinates(const Mesh& mesh) {
    const auto [texture, exists] = mesh.property_map<Face, FaceTexture>(property::texture);
    if (!exists) throw Error("the mesh has no texture coordinates: give an OBJ file with vt lines");
    for (const Face face : mesh.faces())
        for (const Eigen::Vector2d& corner : texture[face])
            if (!corner.allFinite())
                throw Error(
                    fmt::format("the texture coordinates of {} are NaN or infinite: unwrap the mesh anew",
                                face_words(mesh, face)));
    return texture;
}

std::array<WeightedColour, 4> texels_around(const Image& image, const Eigen::Vector2d& uv) {
    const Neighbours x = neighbours(uv.x(), image.width), y = neighbours(uv.y(), image.height);
    const auto texel = [&](int column, int row) { return image.colour(column, image.height - 1 - row); };
    return {{{texel(x.low, y.low), (1 - x.weight) * (1 - y.weight)},
             {texel(x.high, y.low), x.weight * (1 - y.weight)},
             {texel(x.low, y.high), (1 - x.weight) * y.weight},
             {texel(x.high, y.high), x.weight * y.weight}}};
}

}  // namespace sherd
