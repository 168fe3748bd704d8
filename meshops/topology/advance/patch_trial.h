// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "meshops/topology/advance/patch.h"
#include "meshops/topology/retriangulation.h"

namespace sherd {

/// A change of a copy of a patch, which is tried there and can then be applied to the mesh.
class PatchTrial {
  public:
    explicit PatchTrial(const Patch& patch);
    PatchTrial(const PatchTrial&) = delete;
    PatchTrial& operator=(const PatchTrial&) = delete;

    const Mesh& mesh() const { return sheet; }
    /// Operations as in Retriangulation. An inserted vertex is fixed; the halves of a line are lines.
    Vertex split_edge(Halfedge h, double t);
    Vertex split_face(Face face, const Eigen::Vector3d& weights);
    void move(Vertex vertex, const SurfacePoint& place);
    /// Replaces an edge by the other diagonal of its two faces.
    void flip(Edge edge);
    bool can_flip(Edge edge) const { return !line[edge] && edits.can_flip(edge); }
    void fix(Vertex vertex) { mobility[vertex] = Mobility::fixed; }  ///< the vertex stays from now on
    /// Makes the edge a line whose ends stay from now on.
    void keep(Edge edge);

    /// Flips edges and moves free vertices until no angle of a changed face is below `bound` (rad), or
    /// nothing improves.
    void improve(double bound);

    /// Smallest angle of the changed faces, rad; -1 if one has turned over.
    double smallest_angle() const;
    /// Smallest angle of the replaced faces before the change, rad.
    double replaced_angle() const;
    /// Result of apply().
    struct Applied {
        TopologyChange change;
        std::vector<Vertex> vertices;  ///< vertex of the mesh for each vertex of the trial
    };
    /// Applies the change to `to`, the mesh from which the patch was taken.
    Applied apply(Mesh& to) const;

  private:
    struct Step {
        enum Kind { split_edge, split_face, flip, move } kind;
        std::array<Vertex, 3> vertices;  ///< ends of the edge, or corners of the face
        Eigen::Vector3d weights;         ///< weights of these vertices
        Vertex moved = Mesh::null_vertex();
    };

    double angle_of(Face face) const;
    double star_angle(Vertex vertex, const Eigen::Vector3d& place) const;
    bool flip_where_better();
    bool relax(Vertex vertex);
    SurfacePoint on_old_surface(const Eigen::Vector3d& place) const;
    void add_vertex(Vertex inserted);

    const Patch& patch;
    Mesh sheet;
    Retriangulation edits;
    std::vector<Mobility> mobility;
    std::vector<char> line;
    std::vector<Step> steps;
};

}  // namespace sherd
