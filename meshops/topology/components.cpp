// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/topology/components.h"

namespace sherd {

Components connected_components(const Mesh& mesh) {
    Components components;
    components.of_face.assign(mesh.num_faces(), -1);
    std::vector<Face> waiting;
    const auto visit = [&](Face face) {
        if (components.of_face[face.idx()] >= 0) return;
        components.of_face[face.idx()] = components.count;
        waiting.push_back(face);
    };
    for (const Face seed : mesh.faces()) {
        if (components.of_face[seed.idx()] >= 0) continue;
        visit(seed);
        while (!waiting.empty()) {
            const Face face = waiting.back();
            waiting.pop_back();
            for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(face))) {
                const Face other = mesh.face(mesh.opposite(h));
                if (other != Mesh::null_face()) visit(other);
            }
        }
        ++components.count;
    }
    return components;
}

}  // namespace sherd
