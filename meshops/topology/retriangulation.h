// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "meshops/topology/surface_point.h"
#include "meshops/topology/topology_change.h"

namespace sherd {

/// A face as it was before a change.
struct ReplacedFace {
    std::array<Vertex, 3> corners;
    double area;             ///< m^2
    Eigen::Vector3d normal;  ///< with twice the area as its length, m^2
};

/// Changes the triangles of a sheet and records the parents of each new element. Each operation distributes
/// the area of the faces that it replaces among the new ones. In a plane each new face receives its own area.
/// On curved sheets the fractions are measured in the plane into which the faces are unfolded: two faces
/// about their edge; the faces around a vertex with unchanged side lengths and with all angles scaled by a
/// common factor.
class Retriangulation {
  public:
    /// `mesh` must outlive this.
    explicit Retriangulation(Mesh& mesh);

    /// Cuts an edge with its one or two faces at (1 - t) source + t target of a halfedge of it, 0 < t < 1.
    Vertex split_edge(Halfedge h, double t);
    /// Cuts a face into three; weights: positive, in the order of the face's corners.
    Vertex split_face(Face face, const Eigen::Vector3d& weights);
    /// Whether flip() is possible: the edge has two faces which form a convex quadrilateral when unfolded,
    /// the other diagonal is no edge yet, and no face turns over.
    bool can_flip(Edge edge) const;
    /// Replaces the edge by the other diagonal of its two faces.
    void flip(Edge edge);
    /// Moves a vertex to `place`, a point of the sheet before all changes that lies within the faces now at
    /// the vertex. A vertex on the boundary may only slide along the boundary. If a face turns over, the
    /// fractions are wrong.
    void move(Vertex vertex, const SurfacePoint& place);

    /// The faces replaced so far, in their earlier state, by their numbers, which they keep.
    const std::map<Face, ReplacedFace>& replaced() const { return old_faces; }
    std::vector<Face> changed_faces() const;  ///< replaced and inserted faces, ascending
    bool is_changed(Face face) const { return shares.contains(face); }
    /// Sum of the normals of a face's parents, weighted by the areas that have passed to the face, m^2.
    Eigen::Vector3d parent_normal(Face face) const;
    /// Position of a vertex before all changes, m; for an inserted vertex, its present position.
    Eigen::Vector3d old_position(Vertex vertex) const;

    /// Ends the change: the new faces and vertices inherit the attributes of the mesh, and the change is
    /// returned.
    TopologyChange finish();

  private:
    using Fractions = std::map<Face, double>;  ///< by old face
    using VertexWeights = std::map<Vertex, double>;

    void replace(Face face);
    void distribute_fractions(const std::map<Face, Fractions>& received);
    void add_edges(Edge half, Edge copy);
    VertexWeights weights_of(Vertex vertex) const;
    void put(Vertex vertex, const VertexWeights& weights);

    Mesh& mesh;
    std::size_t old_vertices, old_edges, old_face_count;
    std::map<Face, ReplacedFace> old_faces;
    std::map<Face, Fractions> shares;          ///< fractions of old faces in each changed face
    std::map<Vertex, VertexWeights> places;    ///< weights of old vertices in each inserted or moved vertex
    std::map<Vertex, Eigen::Vector3d> origin;  ///< old position of each moved vertex
    std::vector<WithParents<Edge>> inserted_edges;
    std::vector<Edge> turned;
};

}  // namespace sherd
