// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/record/snapshot.h"

#include "fracture/shell/breakable_shell.h"
#include "fracture/shell/hinge_measures.h"

namespace sherd {
namespace {

SurfaceLook recorded_look(const Mesh& mesh, std::span<const Index> original, const RestMesh& rest) {
    SurfaceLook look = surface_look(mesh, original, static_cast<std::size_t>(rest.position.cols()));
    visit_surface_attributes([&](const auto& attribute) {
        if (*attribute.recorded == 0) (look.*attribute.list).clear();
    });
    return look;
}

}  // namespace

Snapshot take_snapshot(const BreakableShell& shell, std::span<const Index> face_fragment) {
    const Shell& mechanics = shell.mechanics();
    Snapshot snapshot;
    snapshot.position = mechanics.position;
    snapshot.velocity = mechanics.velocity;
    snapshot.mass = mechanics.mass;
    for (const TriangleStencil& triangle : mechanics.triangles) snapshot.faces.push_back(triangle.vertices);
    snapshot.face_fragment.assign(face_fragment.begin(), face_fragment.end());
    snapshot.face_sheet.assign(shell.face_sheet().begin(), shell.face_sheet().end());

    const VectorXd strains = hinge_strains(shell, mechanics.position);
    const Mesh& mesh = shell.mesh();
    snapshot.original = shell.rest_parents().columns();
    snapshot.rest = shell.rest_parents().rest(mechanics);
    snapshot.rest.look = recorded_look(mesh, snapshot.original, snapshot.rest);
    for (const Edge edge : mesh.edges()) {
        snapshot.edges.push_back(
            {static_cast<Index>(mesh.vertex(edge, 0)), static_cast<Index>(mesh.vertex(edge, 1))});
        snapshot.edge_state.push_back(shell.cracks().state(edge));
        const Index hinge = shell.hinge_of_edge(edge);
        snapshot.edge_strain.push_back(hinge < 0 ? 0 : strains[hinge]);
    }
    return snapshot;
}

}  // namespace sherd
