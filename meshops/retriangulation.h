// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "meshops/surface_point.h"
#include "meshops/topology_change.h"

namespace sherd {

/// A face as it was before a change.
struct ReplacedFace {
    std::array<Vertex, 3> corners;
    double area;             ///< m^2
    Eigen::Vector3d normal;  ///< twice the area long, m^2
    FaceTexture texture;     ///< where the mesh has any
};

/// Other triangles for the same sheet, with ancestry. Each of the operations passes the area of the faces
/// that it replaces on to the new ones. Where these are in one plane, what a new face receives is its area.
/// On curved sheets the fractions are measured in the plane into which the faces are unfolded: two faces
/// about their edge; all faces around a vertex with their sides as long, and their angles as large compared
/// with each other, as they are.
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
    /// Gives the edge's faces their other diagonal.
    void flip(Edge edge);
    /// Moves a vertex; place: of the sheet as it was in the beginning, within the faces now at the vertex.
    /// A vertex on the boundary may only slide along it. Where a face turns over by it the fractions are
    /// wrong.
    void move(Vertex vertex, const SurfacePoint& place);

    /// The faces that are replaced so far, by the numbers that they keep, as they were.
    const std::map<Face, ReplacedFace>& replaced() const { return old_faces; }
    std::vector<Face> changed_faces() const;  ///< those and the born ones, ascending
    bool is_changed(Face face) const { return shares.contains(face); }
    /// Sum of the normals of what a face was made of, each by its area.
    Eigen::Vector3d ancestral_normal(Face face) const;
    /// Where a vertex was in the beginning, m; of a born one, where it was put first.
    Eigen::Vector3d old_position(Vertex vertex) const;

    /// Ends the change: texture coordinates, groups and axes of the mesh's faces follow, and what was done is
    /// returned.
    TopologyChange finish();

  private:
    using Fractions = std::map<Face, double>;  ///< of old faces
    using VertexWeights = std::map<Vertex, double>;

    void replace(Face face);
    void pass_on(const std::map<Face, Fractions>& received);
    void add_edges(Edge half, Edge copy);
    VertexWeights weights_of(Vertex vertex) const;
    void put(Vertex vertex, const VertexWeights& weights);

    Mesh& mesh;
    std::size_t old_vertices, old_edges, old_face_count;
    std::map<Face, ReplacedFace> old_faces;
    std::map<Face, Fractions> shares;          ///< of each changed face
    std::map<Vertex, VertexWeights> places;    ///< of each born or moved vertex
    std::map<Vertex, Eigen::Vector3d> origin;  ///< old position of each moved vertex
    std::vector<Born<Edge>> born_edges;
    std::vector<Edge> turned;
};

}  // namespace sherd
