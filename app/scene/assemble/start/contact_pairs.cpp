// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/assemble/start/contact_pairs.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "meshops/error.h"
#include "meshops/mesh_measures.h"

namespace sherd {
namespace {

constexpr double most_pairs = 5e7;  // need about 3 GB

struct EdgesOfSheet {
    double length;  ///< m, mean length of the edges
    double pairs;   ///< estimated number of pairs of elements that are nearer than the thickness
};

EdgesOfSheet edges_of(const SheetInput& input) {
    const Mesh& mesh = input.mesh;
    double length = 0, area = 0;
    for (const Edge edge : mesh.edges())
        length += (position(mesh, mesh.vertex(edge, 1)) - position(mesh, mesh.vertex(edge, 0))).norm();
    for (const Face face : mesh.faces()) area += face_area(mesh, face);
    const double vertices = mesh.number_of_vertices(), edges = mesh.number_of_edges(),
                 faces = mesh.number_of_faces(), mean = length / edges;
    const double reach = input.thickest() + mean;
    const double share = std::min(1.0, std::numbers::pi * reach * reach / area);
    return {mean, (edges * edges / 2 + vertices * faces) * share};
}

}  // namespace

void require_few_pairs(const Scene& scene, const std::vector<SheetInput>& inputs) {
    if (!scene.simulation.stepper.contact.sheets) return;
    for (std::size_t s = 0; s < inputs.size(); ++s) {
        const double thickness = inputs[s].thickest();
        const EdgesOfSheet edges = edges_of(inputs[s]);
        if (edges.pairs <= most_pairs || edges.length >= thickness) continue;
        throw Error(fmt::format(
            "{}: sheet.{} has edges of {:.2g} m on average where it is {:.2g} m thick, so that contact would "
            "have some {:.0f} million pairs to follow, more than it can; give the mesh `remesh = {:.1g}`, "
            "make the sheet thinner, or set contact.sheets = false, so that sheets pass through each other",
            scene.sheets[s].where, scene.sheets[s].name, edges.length, thickness, edges.pairs / 1e6,
            thickness));
    }
}

}  // namespace sherd
