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

/// Elements nearer than this share of half the sum of their thicknesses touch: a barrier over so small a
/// distance would stop all motion.
inline constexpr double touching = 0.01;

/// Two faces that intersect or are too close for a first step.
struct StartOverlap {
    std::array<Index, 2> faces{};  ///< ascending
    /// Whether they intersect beyond shared vertices and edges, or touch (see `touching`).
    bool crossing = false;
    double distance = 0;                 ///< m, between their middle surfaces; 0 if they cross
    double needed = 0;                   ///< m, their activation distance; 0 if they cross
    Vector3d normal = Vector3d::Zero();  ///< unit vector from the first to the second; 0 if they cross
};

/// Exempt pairs: faces that intersect or are too near at the start, until they have separated. Elements that
/// contain a vertex of each face do not collide if the faces intersect; if they are only too near, such
/// elements repel each other from their distance at the start on. All other elements, and these once they
/// have separated, collide normally. So nothing is flung apart, and elements that were apart cannot pass
/// through each other.
class StartExemptions {
  public:
    void add(const Mesh& mesh, std::span<const StartOverlap> overlaps);

    /// Must be called when the mesh was changed: new vertices inherit the pairs of their parents.
    void follow(const TopologyChange& change);

    /// Removes the vertex pairs around which no faces intersect any more and all elements are beyond their
    /// activation distance. Returns whether there were any.
    bool release(const Mesh& mesh, const Shell& shell);

    /// Adds to shell.exempt_pairs and sets shell.near.
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
