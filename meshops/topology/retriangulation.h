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
    Eigen::Vector3d normal;  ///< m^2, its length is twice the area
};

/// Changes the triangles of a sheet and records the parents of each new or changed element. Each operation
/// passes the area of the faces that it replaces on to the new faces: fractions of each replaced face. In a
/// plane, a new face receives the area that it covers. On a curved sheet, the fractions are measured after
/// unfolding the faces into a plane: two faces about their common edge; the faces around a vertex with
/// unchanged lengths of the edges at the vertex, and with all angles at the vertex scaled by a common factor.
class Retriangulation {
  public:
    /// `mesh` must outlive this.
    explicit Retriangulation(Mesh& mesh);

    /// Divides the edge of h, and its one or two faces, at the point (1 - t) source + t target of h, 0 < t <
    /// 1. Returns the inserted vertex.
    Vertex split_edge(Halfedge h, double t);
    /// Divides a face into three at the point with these barycentric weights, which are positive and in the
    /// order of face_corners(). Returns the inserted vertex.
    Vertex split_face(Face face, const Eigen::Vector3d& weights);
    /// Whether flip() is possible: the edge has two faces, which form a convex quadrilateral when unfolded;
    /// no edge joins the other two corners yet; and no face turns over.
    bool can_flip(Edge edge) const;
    /// Replaces the edge by the other diagonal of its two faces.
    void flip(Edge edge);
    /// Moves a vertex to `place`, a point on the sheet as it was before all changes. The place must lie
    /// within the faces that the vertex has now. A vertex on the boundary may only slide along the boundary.
    /// If a face turns over, the recorded fractions are wrong.
    void move(Vertex vertex, const SurfacePoint& place);

    /// Returns the old faces that have been replaced so far, as they were before all changes, by number.
    /// Changed faces keep these numbers.
    const std::map<Face, ReplacedFace>& replaced() const { return old_faces; }
    std::vector<Face> changed_faces() const;  ///< replaced and inserted faces, ascending
    bool is_changed(Face face) const { return shares.contains(face); }
    /// Returns the sum of the normals of the parents of a face, m^2. The length of each is twice the area
    /// that the parent has passed on to the face.
    Eigen::Vector3d parent_normal(Face face) const;
    /// Returns the position of a vertex before all changes, m; for an inserted vertex, its present position.
    Eigen::Vector3d old_position(Vertex vertex) const;

    /// Ends the change: new and changed faces and vertices inherit the attributes of the mesh. Returns the
    /// change.
    TopologyChange finish();

  private:
    using Fractions = std::map<Face, double>;  ///< fractions of the areas of old faces
    using VertexWeights = std::map<Vertex, double>;

    void replace(Face face);
    void distribute_fractions(const std::map<Face, Fractions>& received);
    void add_edges(Edge half, Edge copy);
    VertexWeights weights_of(Vertex vertex) const;
    void put(Vertex vertex, const VertexWeights& weights);

    Mesh& mesh;
    std::size_t old_vertices, old_edges, old_face_count;
    std::map<Face, ReplacedFace> old_faces;
    std::map<Face, Fractions> shares;          ///< fractions that each changed face has received
    std::map<Vertex, VertexWeights> places;    ///< weights of old vertices for each inserted or moved vertex
    std::map<Vertex, Eigen::Vector3d> origin;  ///< old position of each moved vertex
    std::vector<WithParents<Edge>> inserted_edges;
    std::vector<Edge> turned;
};

}  // namespace sherd
