// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/remesh/plain_copy.h"

#include <vector>

#include "meshops/error.h"
#include "meshops/mesh_measures.h"

namespace sherd {

Mesh plain_copy(const Mesh& mesh) {
    Mesh copy;
    std::vector<Vertex> vertex(mesh.num_vertices());
    for (const Vertex v : mesh.vertices()) vertex[v.idx()] = copy.add_vertex(mesh.point(v));
    for (const Face face : mesh.faces()) {
        std::array<Vertex, 3> corners = face_corners(mesh, face);
        for (Vertex& corner : corners) corner = vertex[corner.idx()];
        if (copy.add_face(corners) == Mesh::null_face())
            throw Error("remeshing: a face of the mesh does not fit the others", Fault::run);
    }
    return copy;
}

}  // namespace sherd
