// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/shell/start_overlaps.h"

#include <algorithm>
#include <map>
#include <set>

#include "core/contact/sheets/sheet_contact.h"
#include "meshops/intersect/self_intersections.h"
#include "meshops/mesh_measures.h"

namespace sherd {
namespace {

constexpr double nearest = 0.99;  // share of the activation distance; closer elements would be flung apart

using FacePair = std::array<Index, 2>;

FacePair ascending(Face a, Face b) {
    return {static_cast<Index>(std::min(a, b)), static_cast<Index>(std::max(a, b))};
}

/// Whether a vertex of one face coincides with a vertex of the other, as along a seam.
bool at_seam(const Shell& shell, const FacePair& faces) {
    for (const Index p : shell.triangles[faces[0]].vertices)
        for (const Index q : shell.triangles[faces[1]].vertices)
            if (std::binary_search(shell.exempt_pairs.begin(), shell.exempt_pairs.end(),
                                   std::array{std::min(p, q), std::max(p, q)}))
                return true;
    return false;
}

/// Returns a face that contains the pair's first element, then a face that contains the second.
FacePair faces_of(const Mesh& mesh, const ContactPair& pair) {
    const std::span<const Index> vertices(pair.vertices);
    const std::size_t first = pair.kind == PairKind::edge_edge ? 2 : 1;
    return {static_cast<Index>(face_with(mesh, vertices.first(first))),
            static_cast<Index>(face_with(mesh, vertices.subspan(first)))};
}

StartOverlap overlap_of(const Mesh& mesh, const ContactPair& pair, const PairPositions& x) {
    const Vector3d apart = x * closest_points(pair.kind, x).weights;  // from the second element to the first
    const double distance = apart.norm();
    const Vector3d normal = distance > 0 ? Vector3d(-apart / distance) : Vector3d(Vector3d::Zero());
    const auto [first, second] = faces_of(mesh, pair);
    const FacePair faces{std::min(first, second), std::max(first, second)};
    return {faces, false, distance, pair.activation_distance, first < second ? normal : Vector3d(-normal)};
}

}  // namespace

Mesh placed_mesh(const BreakableShell& shell) {
    Mesh mesh = shell.mesh();
    for (const Vertex v : mesh.vertices()) {
        const auto at = shell.mechanics().position.col(static_cast<Index>(v));
        mesh.point(v) = point_at(at);
    }
    return mesh;
}

std::vector<StartOverlap> start_overlaps(const BreakableShell& shell) {
    std::vector<StartOverlap> overlaps;
    std::map<FacePair, StartOverlap> near;
    const Shell& mechanics = shell.mechanics();
    std::set<FacePair> crossing;
    const SheetContact contact(mechanics);
    for (const ContactPair& pair : contact.pairs_nearby(mechanics.position)) {
        const PairPositions x = columns(mechanics.position, pair.vertices);
        const double apart = distance(pair, x);
        if (apart <= touching * half_thicknesses(mechanics, pair.kind, pair.vertices)) {
            const auto [a, b] = faces_of(shell.mesh(), pair);
            crossing.insert({std::min(a, b), std::max(a, b)});
        }
        if (apart >= nearest * pair.activation_distance) continue;
        const StartOverlap overlap = overlap_of(shell.mesh(), pair, x);
        const auto known = near.emplace(overlap.faces, overlap).first;
        if (overlap.distance < known->second.distance) known->second = overlap;
    }
    for (const auto& [a, b] : self_intersections(placed_mesh(shell))) {
        const FacePair faces = ascending(a, b);
        if (!at_seam(mechanics, faces)) crossing.insert(faces);
    }
    for (const FacePair& faces : crossing) {
        overlaps.push_back({faces, true});
        near.erase(faces);
    }
    for (const auto& [faces, overlap] : near) overlaps.push_back(overlap);
    return overlaps;
}

}  // namespace sherd
