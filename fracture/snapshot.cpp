// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/snapshot.h"

#include "fracture/breakable_sheet.h"
#include "fracture/hinge_measures.h"

namespace sherd {

Snapshot take_snapshot(const BreakableSheet& sheet, std::span<const Index> face_fragment) {
    const Sheet& mechanics = sheet.mechanics();
    Snapshot snapshot;
    snapshot.position = mechanics.position;
    snapshot.velocity = mechanics.velocity;
    snapshot.mass = mechanics.mass;
    for (const TriangleStencil& triangle : mechanics.triangles) snapshot.faces.push_back(triangle.vertices);
    snapshot.face_fragment.assign(face_fragment.begin(), face_fragment.end());
    snapshot.face_sheet.assign(sheet.face_sheet().begin(), sheet.face_sheet().end());

    const VectorXd strains = hinge_strains(sheet, mechanics.position);
    const Mesh& mesh = sheet.mesh();
    for (const Vertex vertex : mesh.vertices())
        snapshot.original.push_back(static_cast<Index>(sheet.cracks().original(vertex)));
    for (const Edge edge : mesh.edges()) {
        snapshot.edges.push_back(
            {static_cast<Index>(mesh.vertex(edge, 0)), static_cast<Index>(mesh.vertex(edge, 1))});
        snapshot.edge_state.push_back(sheet.cracks().state(edge));
        const Index hinge = sheet.hinge_of_edge(edge);
        snapshot.edge_strain.push_back(hinge < 0 ? 0 : strains[hinge]);
    }
    return snapshot;
}

}  // namespace sherd
