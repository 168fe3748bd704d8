// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/cracks/small_pieces.h"

#include <unordered_set>

namespace sherd {
namespace {

/// Whether `edge` alone connects the face `other` with a piece of less than `area` (m^2) at rest. The piece
/// has all faces that are connected with `from` otherwise than across `edge` or the edges marked in `failed`.
bool is_small_piece(const BreakableShell& shell, Edge edge, Face from, Face other, double area,
                    std::span<const char> failed) {
    const Mesh& mesh = shell.mesh();
    std::unordered_set<Index> seen{static_cast<Index>(from)};
    std::vector<Face> piece{from};
    double sum = 0;
    for (std::size_t i = 0; i < piece.size(); ++i) {
        sum += shell.mechanics().triangles[piece[i]].membrane.area;
        if (sum >= area) return false;
        for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(piece[i]))) {
            const Edge way = mesh.edge(h);
            if (way == edge || failed[way] || shell.hinge_of_edge(way) < 0) continue;
            const Face next = mesh.face(mesh.opposite(h));
            if (next == other) return false;
            if (seen.insert(static_cast<Index>(next)).second) piece.push_back(next);
        }
    }
    return true;
}

}  // namespace

bool separates_small_piece(const BreakableShell& shell, Edge edge, double smallest,
                           std::span<const char> failed) {
    const Mesh& mesh = shell.mesh();
    const Halfedge h = mesh.halfedge(edge);
    const Face one = mesh.face(h), other = mesh.face(mesh.opposite(h));
    const double area = smallest * smallest;
    return is_small_piece(shell, edge, one, other, area, failed) ||
           is_small_piece(shell, edge, other, one, area, failed);
}

Index prevent_small_pieces(BreakableShell& shell, std::span<const Edge> edges) {
    Index kept = 0;
    if (edges.empty()) return kept;
    std::vector<char> failed(shell.mesh().number_of_edges(), 0);
    for (const Edge edge : edges) {
        const double smallest = shell.art_direction(shell.sheet_of(edge)).smallest;
        if (smallest > 0 && separates_small_piece(shell, edge, smallest, failed)) {
            shell.make_unbreakable(edge);
            ++kept;
        } else {
            failed[edge] = 1;
        }
    }
    return kept;
}

}  // namespace sherd
