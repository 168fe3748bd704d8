// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "meshops/mesh.h"
#include "meshops/remesh/feature_lines.h"

namespace sherd {

/// The surface that is remeshed. The point of the surface that is nearest to another point is searched over
/// connected faces, so that a second wall beside a sheet is not mistaken for the sheet.
class InputSurface {
  public:
    /// mesh: must have no gaps in its numbers, and must outlive this. smoothing: m, distance over which
    /// normals are averaged, though not across feature lines.
    InputSurface(const Mesh& mesh, FeatureLines lines, double smoothing);

    /// A point of the surface.
    struct Site {
        Face face;
        Eigen::Vector3d weights;  ///< barycentric, in the order of face_corners()
        Eigen::Vector3d place;    ///< m
    };
    /// Returns the point of the surface nearest to `point` (m). The search begins at the face `begin` and
    /// goes on over neighbouring faces; without `across_lines`, it does not cross feature lines.
    Site nearest(Face begin, const Eigen::Vector3d& point, bool across_lines = true) const;

    const Eigen::Vector3d& normal(Face face) const { return normals[face]; }  ///< unit, averaged
    bool is_line(Halfedge h) const { return lines.of_edge[mesh.edge(h)].line != LineStretch::none; }

    const Mesh& mesh;
    const FeatureLines lines;

  private:
    void average_normals(double smoothing);

    std::vector<Eigen::Vector3d> normals;  ///< [F] unit, averaged
};

}  // namespace sherd
