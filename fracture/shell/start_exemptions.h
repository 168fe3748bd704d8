// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "core/shell/shell.h"
#include "core/state_visitor.h"
#include "core/vector.h"
#include "fracture/shell/vertex_pairs.h"
#include "meshops/topology/topology_change.h"

namespace sherd {

/// Elements touch if their distance is less than this share of half the sum of their thicknesses: a barrier
/// over so small a distance would stop all motion.
inline constexpr double touching = 0.01;

/// Two faces that intersect or are too close for a first step.
struct StartOverlap {
    std::array<Index, 2> faces{};  ///< ascending
    /// Whether the faces intersect beyond shared vertices and edges, or touch (see `touching`).
    bool crossing = false;
    double distance = 0;                 ///< m, between their middle surfaces; 0 if they cross
    double needed = 0;                   ///< m, activation distance of their nearest elements; 0 if they
                                         ///< cross
    Vector3d normal = Vector3d::Zero();  ///< unit vector from the first face to the second; 0 if they cross
};

/// Exempt pairs: pairs of faces that intersect or are too near at the start, until the two faces have
/// separated. If they intersect, two elements do not collide if one contains a vertex of one face and the
/// other a vertex of the other face. If they are only too near, such elements repel each other only below the
/// faces' distance at the start. All other elements collide normally, and so do such elements once they have
/// separated. Therefore nothing is flung apart at the start, and elements that were apart cannot pass through
/// each other.
class StartExemptions {
  public:
    void add(const Mesh& mesh, std::span<const StartOverlap> overlaps);

    /// Must be called when the mesh has changed: new vertices inherit the pairs of their parents.
    void follow(const TopologyChange& change);

    /// Removes the vertex pairs around which no faces intersect any more and all elements are beyond their
    /// activation distance. Returns whether there were any such pairs.
    bool release(const Mesh& mesh, const Shell& shell);

    /// Appends the vertex pairs of faces that intersect or touch to shell.exempt_pairs, and sets shell.near
    /// to the other vertex pairs.
    void write(Shell& shell) const;

    bool has(Vertex vertex) const { return pairs.has(vertex); }
    std::size_t count() const { return pairs.all().size(); }

    void visit_state(StateVisitor& visit) {
        auto& [pairs] = *this;
        visit(pairs);
    }

  private:
    bool apart(const Mesh& mesh, const Shell& shell, const VertexPairs::Pair& pair) const;

    VertexPairs pairs;
};

}  // namespace sherd
