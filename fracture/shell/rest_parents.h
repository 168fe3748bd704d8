// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>

#include "core/shell/shell.h"
#include "core/state_visitor.h"
#include "fracture/shell/rest_mesh.h"
#include "meshops/topology/topology_change.h"

namespace sherd {

/// How the mesh of a sheet lies in the unfractured one, for RestMesh.
class RestParents {
  public:
    /// mesh: the unfractured one.
    explicit RestParents(const Mesh& mesh);
    /// Must be called when the mesh has changed; mesh: after the change. Inserted and moved vertices get the
    /// nearest point of the unfractured faces that are parents of the faces around them. On a curved sheet
    /// they may lie beside these, by the sagitta of a chord.
    void follow(const Mesh& mesh, const TopologyChange& change);

    /// [V] columns of RestMesh::position.
    const std::vector<Index>& columns() const { return column; }
    RestMesh rest(const Shell& shell) const;

    void visit_state(StateVisitor& visit) {
        auto& [start, unfractured, area, column, vertex, places, reshaped] = *this;
        visit(column, vertex, places, reshaped);
    }

  private:
    using Parts = std::map<Index, double>;  ///< fraction of the area of each unfractured face

    struct Place {
        std::array<Index, 3> parents;
        std::array<double, 3> weights;
    };

    Parts parts_of(Index face) const;
    std::array<Eigen::Vector3d, 3> corners(Index unfractured_face) const;
    Place place_of(const Mesh& mesh, Vertex vertex) const;
    Index parent_of(Index face) const;

    Positions start;                                ///< [3, V0] m
    std::vector<std::array<Index, 3>> unfractured;  ///< [F0]
    std::vector<double> area;                       ///< [F0] m^2
    std::vector<Index> column;                      ///< [V]
    std::vector<Index> vertex;                      ///< [R] one of the mesh's vertices there
    std::vector<Place> places;                      ///< [R]
    std::map<Index, Parts> reshaped;                ///< parts of faces that are not whole unfractured ones
};

}  // namespace sherd
