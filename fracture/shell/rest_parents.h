// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>

#include "core/shell/shell.h"
#include "core/state_visitor.h"
#include "fracture/shell/rest_mesh.h"
#include "meshops/topology/topology_change.h"

namespace sherd {

/// How a mesh lies in the unfractured mesh, for RestMesh.
class RestParents {
  public:
    /// mesh: the unfractured mesh.
    explicit RestParents(const Mesh& mesh);
    /// Must be called when the mesh has changed; mesh: the mesh after the change. The place of an inserted or
    /// moved vertex is the nearest point of the unfractured faces that are parents of the faces around it. On
    /// a curved sheet the vertex may lie off these faces, by the sagitta of a chord.
    void follow(const Mesh& mesh, const TopologyChange& change);

    /// [V] column of RestMesh::position of each vertex.
    const std::vector<Index>& columns() const { return column; }
    RestMesh rest(const Shell& shell) const;

    void visit_state(StateVisitor& visit) {
        auto& [start, unfractured, area, column, vertex, places, reshaped] = *this;
        visit(column, vertex, places, reshaped);
    }

  private:
    using Parts = std::map<Index, double>;  ///< unfractured faces, and fractions of their areas

    struct Place {
        std::array<Index, 3> parents;
        std::array<double, 3> weights;
    };

    Parts parts_of(Index face) const;
    std::array<Eigen::Vector3d, 3> corners(Index unfractured_face) const;
    Place place_of(const Mesh& mesh, Vertex vertex) const;
    Index parent_of(Index face) const;

    Positions start;                                ///< [3, V0] m, unfractured vertices
    std::vector<std::array<Index, 3>> unfractured;  ///< [F0] corners
    std::vector<double> area;                       ///< [F0] m^2, areas
    std::vector<Index> column;                      ///< [V] see columns()
    std::vector<Index> vertex;                      ///< [R] a vertex of the mesh with this column
    std::vector<Place> places;                      ///< [R] place in the unfractured mesh
    std::map<Index, Parts> reshaped;                ///< parts of faces that are not whole unfractured faces
};

}  // namespace sherd
