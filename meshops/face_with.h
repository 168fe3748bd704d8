// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "meshops/mesh.h"

namespace sherd {

/// A face that has all of the given one, two or three vertices; the null face if there is none.
inline Face face_with(const Mesh& mesh, std::span<const std::int32_t> vertices) {
    for (const Face face : mesh.faces_around_target(mesh.halfedge(Vertex(vertices.front())))) {
        if (face == Mesh::null_face()) continue;
        const auto corners = mesh.vertices_around_face(mesh.halfedge(face));
        if (std::all_of(vertices.begin(), vertices.end(), [&](std::int32_t vertex) {
                return std::find(corners.begin(), corners.end(), Vertex(vertex)) != corners.end();
            }))
            return face;
    }
    return Mesh::null_face();
}

}  // namespace sherd
