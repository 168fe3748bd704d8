// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/shell/shell.h"

namespace sherd {

/// The faces around each vertex of a shell, as the shell was at construction.
class VertexFaces {
  public:
    explicit VertexFaces(const Shell& shell);
    /// Faces with this corner, by ascending number.
    std::span<const Index> operator[](Index vertex) const {
        return {faces.data() + first[vertex], faces.data() + first[vertex + 1]};
    }
    Index vertices() const { return static_cast<Index>(first.size()) - 1; }

  private:
    std::vector<Index> first;  ///< [V + 1] where each vertex's faces begin
    std::vector<Index> faces;
};

/// The tip of a crack and the vertices around it, all in the rest shape.
struct CrackTip {
    Index vertex = 0;
    Vector3d direction = Vector3d::UnitX();  ///< unit vector in the tangent plane, away from the crack
    Vector3d normal = Vector3d::UnitZ();     ///< unit normal of the tangent plane
    /// Ring d has the vertices d edges away from the tip, including vertices of the crack faces. Ring 0 is
    /// the tip. All rings are nearer to the tip than any foreign vertex (crack_tip()).
    std::vector<std::vector<Index>> rings;
    /// The vertices along each crack face, from the one nearest to the tip on: one vertex more than there are
    /// rings, or fewer if the crack face is shorter.
    std::array<std::vector<Index>, 2> crack_faces;

    /// Axes of the tangent plane, one a column: along the direction, and to its left as seen against the
    /// normal.
    Eigen::Matrix<double, 3, 2> axes() const;
};

/// The tip at a vertex on which exactly two boundary sides end, one on each crack face; the tip's direction
/// is away from these sides. foreign: [V] 1 if a vertex is the tip of another crack or lies on the outer
/// boundary. If the nearest foreign vertex is d edges away, the tip has the rings 0 to min(most, d - 1).
/// Throws std::invalid_argument if the number of boundary sides at the vertex is not two.
CrackTip crack_tip(const Shell& shell, const VertexFaces& around, Index vertex, std::span<const char> foreign,
                   int most = 4);

/// Unit normal of the rest shape at a vertex: the mean of its faces' normals, weighted by area.
Vector3d rest_normal(const Shell& shell, const VertexFaces& around, Index vertex);

/// The rotation by the smallest angle that takes one unit vector to another; they must not be opposite.
Matrix3d smallest_turn(const Vector3d& from, const Vector3d& to);

/// The rotation of the rest shape at a vertex to x [3, V] m: the polar factor of the mean of its faces'
/// deformation gradients, weighted by area.
Matrix3d rotation_at(const Shell& shell, const VertexFaces& around, Index vertex, const Positions& x);

/// Sorts numbers, and removes duplicates.
void make_unique(std::vector<Index>& numbers);

/// The faces with a corner in any of the rings up to number `last`, by ascending number.
std::vector<Index> faces_around(const VertexFaces& around, const CrackTip& tip, int last);

}  // namespace sherd
