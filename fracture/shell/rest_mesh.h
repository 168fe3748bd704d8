// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/state_visitor.h"
#include "core/vector.h"
#include "fracture/mesh/mesh_state.h"
#include "meshops/attributes.h"

namespace sherd {

/// The mesh of a snapshot at rest, with all copies of a vertex merged, and how it lies in the unfractured
/// mesh. A crack may split faces, which inserts vertices in edges and faces; the parts of a face lie in that
/// face, which is flat at rest. A crack may also move vertices and flip edges; then a face may cover parts of
/// several unfractured faces.
struct RestMesh {
    /// [3, R] m; the first columns are the vertices of the unfractured mesh, moved ones at their new places.
    Positions position;
    std::vector<std::array<Index, 3>> faces;  ///< [F] corners, columns of position
    std::vector<double> area;                 ///< [F] m^2
    std::vector<double> thickness;            ///< [F] m; empty in recordings of versions that did not store
                                              ///< it

    std::vector<std::array<Index, 3>> vertex_parents;   ///< [R] unfractured vertices around its place
    std::vector<std::array<double, 3>> vertex_weights;  ///< [R] shares of vertex_parents, which sum to 1
    std::vector<Index> face_parent;  ///< [F] face of the unfractured mesh that covers it, or most of it
    /// [F] 1 for mixed faces, which cover parts of several unfractured faces, so that not all corners lie in
    /// face_parent; empty: no face is mixed.
    std::vector<std::uint8_t> face_mixed = {};
    SurfaceLook look = {};  ///< recorded attributes of vertices [R] and faces [F]
    std::vector<std::array<Index, 3>> unfractured_faces;  ///< [F0] faces of the unfractured mesh
    Positions unfractured_position = {};                  ///< [3, V0] m, vertices of the unfractured mesh

    void visit_state(StateVisitor& visit) {
        auto& [position, faces, area, thickness, vertex_parents, vertex_weights, face_parent, face_mixed,
               look, unfractured_faces, unfractured_position] = *this;
        visit(position, faces, area, thickness, vertex_parents, vertex_weights, face_parent, face_mixed,
              unfractured_faces, unfractured_position);
        visit_look(visit, look);
    }
};

/// Returns the rest mesh of a mesh that has not fractured. The arguments become the members of the same
/// names.
RestMesh unfractured_mesh(Positions position, std::vector<std::array<Index, 3>> faces,
                          std::vector<double> area, std::vector<double> thickness);

/// Barycentric coordinates of a face's corner (0, 1, 2) in its parent face; in a mixed face, the coordinates
/// of the corner's projection into the parent's plane.
Vector3d place_in_parent(const RestMesh& rest, std::size_t face, int corner);

}  // namespace sherd
