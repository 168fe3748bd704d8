// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/build/texture.h"

#include <fmt/format.h>

#include "app/messages/place_text.h"
#include "meshops/attributes.h"
#include "meshops/error.h"

namespace sherd {
Mesh::Property_map<Face, FaceTexture> texture_coordinates(const Mesh& mesh) {
    const auto [texture, exists] = find_property(mesh, attribute::texture);
    if (!exists) throw Error("the mesh has no texture coordinates: give an OBJ file with vt lines");
    for (const Face face : mesh.faces())
        for (const Eigen::Vector2d& corner : texture[face])
            if (!corner.allFinite())
                throw Error(
                    fmt::format("the texture coordinates of {} are NaN or infinite: unwrap the mesh again",
                                face_text(mesh, face)));
    return texture;
}

}  // namespace sherd
