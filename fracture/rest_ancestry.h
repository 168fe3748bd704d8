// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>

#include "core/shell/shell.h"
#include "core/state_visitor.h"
#include "fracture/snapshot.h"
#include "meshops/topology_change.h"

namespace sherd {

/// How the mesh of a breaking sheet lies in the one that it began as: what RestMesh tells.
class RestAncestry {
  public:
    /// mesh: the unbroken one.
    explicit RestAncestry(const Mesh& mesh);
    /// Must be called when the mesh has changed; mesh: after that. Born and moved vertices lie where they are
    /// nearest to the unbroken faces of which the faces around them have a part. On a curved sheet they may
    /// be off these, by what chords leave out.
    void follow(const Mesh& mesh, const TopologyChange& change);

    /// [V] columns of RestMesh::position.
    const std::vector<Index>& columns() const { return column; }
    RestMesh rest(const Shell& shell) const;

    void visit_state(StateVisitor& visit) {
        auto& [start, unbroken, area, column, vertex, places, reshaped] = *this;
        visit(column, vertex, places, reshaped);
    }

  private:
    using Parts = std::map<Index, double>;  ///< of unbroken faces: fractions of their areas

    struct Place {
        std::array<Index, 3> parents;
        std::array<double, 3> weights;
    };

    Parts parts_of(Index face) const;
    std::array<Eigen::Vector3d, 3> corners(Index unbroken_face) const;
    Place place_of(const Mesh& mesh, Vertex vertex) const;
    Index parent_of(Index face) const;

    Positions start;                             ///< [3, V0] m
    std::vector<std::array<Index, 3>> unbroken;  ///< [F0]
    std::vector<double> area;                    ///< [F0] m^2
    std::vector<Index> column;                   ///< [V]
    std::vector<Index> vertex;                   ///< [R] one that is there
    std::vector<Place> places;                   ///< [R]
    std::map<Index, Parts> reshaped;             ///< of faces that are not unbroken ones
};

}  // namespace sherd
