// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/record/fragments.h"

#include "meshops/topology/components.h"

namespace sherd {

Fragments::Fragments(const Mesh& mesh, std::span<const double> areas)
    : fragment_of_face(mesh.number_of_faces(), -1) {
    update(mesh, areas);
}

void Fragments::follow(const TopologyChange& change) {
    for (const WithParents<Face>& face : change.faces)
        fragment_of_face.push_back(fragment_of_face[face.parents.front().element]);
}

void Fragments::update(const Mesh& mesh, std::span<const double> areas) {
    const Components pieces = connected_components(mesh);
    std::vector<double> area(pieces.count, 0.0);
    std::vector<Index> former(pieces.count, -1);
    for (std::size_t f = 0; f < areas.size(); ++f) {
        area[pieces.of_face[f]] += areas[f];
        former[pieces.of_face[f]] = fragment_of_face[f];
    }
    std::vector<Index> inserted(parent.size(), -1);  // for each fragment, the piece that keeps its number
    for (Index piece = 0; piece < pieces.count; ++piece)
        if (const Index from = former[piece]; from >= 0)
            if (inserted[from] < 0 || area[piece] > area[inserted[from]]) inserted[from] = piece;

    std::vector<Index> number(pieces.count);
    for (Index piece = 0; piece < pieces.count; ++piece) {
        const Index from = former[piece];
        if (from >= 0 && inserted[from] == piece) {
            number[piece] = from;
        } else {
            number[piece] = count();
            parent.push_back(from);
        }
    }
    for (std::size_t f = 0; f < areas.size(); ++f) fragment_of_face[f] = number[pieces.of_face[f]];
}

}  // namespace sherd
