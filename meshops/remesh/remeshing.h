// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <numbers>
#include <vector>

#include "meshops/mesh.h"
#include "meshops/random.h"
#include "meshops/remesh/input_surface.h"
#include "meshops/remesh/size_field.h"

namespace sherd {

/// A mesh that is being remeshed: initially a copy of the surface, then improved edge by edge as in Botsch
/// and Kobbelt (2004), with target lengths that vary. Vertices stay on the surface, and on their lines; no
/// operation turns a face away from the surface.
class Remeshing {
  public:
    /// unsplit: [F] m, length up to which the edges of each face of the surface are not split; 0: the target
    /// length decides. `surface` and `sizes` must outlive this.
    Remeshing(const InputSurface& surface, const SizeField& sizes, const std::vector<double>& unsplit);
    Remeshing(const Remeshing&) = delete;
    Remeshing& operator=(const Remeshing&) = delete;

    /// Updates the target lengths at all vertices.
    void update_sizes();
    /// Splits, collapses and flips edges and moves vertices along the surface, `rounds` times; then removes
    /// small angles.
    void improve(int rounds);

    const Mesh& mesh() const { return work; }
    /// Returns the face of the surface in which the vertex lies.
    Face face_below(Vertex v) const { return site[v].face; }
    double size_at(Vertex v) const { return site[v].size; }  ///< m, target edge length

  private:
    static constexpr double degree = std::numbers::pi / 180;
    using Triangle = std::array<Eigen::Vector3d, 3>;
    /// Place of a vertex on the surface.
    struct Site {
        Face face;
        double size = 0;        ///< m, target edge length
        bool is_fixed = false;  ///< whether it is a corner of lines or a chosen vertex of a shared line
        bool is_on_line = false;
    };
    /// Edge of a line at a vertex, with the places (m) of both ends along the line.
    struct LineEnd {
        Vertex other;
        std::int32_t line;
        double at_vertex, at_other;
    };

    void fix_shared_lines();
    void split_long();
    void split(Edge edge);
    InputSurface::Site below_edge(Vertex a, Vertex b, const Eigen::Vector3d& near) const;
    void flip_edges();
    bool flip(Edge edge);
    void move_vertices(double perturbation = 0);
    bool move(Vertex v, const Eigen::Vector3d& to, double least_angle);
    bool slide(Vertex v, double part, double least_angle);
    bool fits(Vertex v, const Eigen::Vector3d& place, double least_angle) const;

    void collapse_short();
    bool may_collapse(Halfedge h, double slack, double least_angle) const;
    bool keeps_lines(Halfedge h) const;
    void collapse(Halfedge h);
    void improve_angles();
    bool improve_face(Face face);

    std::vector<Edge> edges_by_length(bool longest_first) const;
    double length(Edge edge) const;
    double target_length(Vertex a, Vertex b) const { return (site[a].size + site[b].size) / 2; }
    bool is_line(Edge edge) const { return stretch[edge].line != LineStretch::none; }
    std::vector<LineEnd> line_ends(Vertex v) const;
    void set_line(Edge edge, Vertex v, const LineEnd& end);
    double angle_at(Vertex v) const;
    bool approximates_surface(const std::array<Vertex, 3>& corners, const Triangle& places) const;
    void place_at(Vertex v, const InputSurface::Site& at);

    const InputSurface& surface;
    const SizeField& sizes;
    Mesh work;
    Mesh::Property_map<Vertex, Site> site;
    Mesh::Property_map<Edge, LineStretch> stretch;
    Mesh::Property_map<Edge, double> whole;  ///< m, length up to which an edge is not split
    Random random{1};
};

}  // namespace sherd
