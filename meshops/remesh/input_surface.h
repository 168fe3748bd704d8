// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "meshops/mesh.h"
#include "meshops/remesh/feature_lines.h"

namespace sherd {

/// The surface that is remeshed, to be asked for the nearest of its points on the same sheet, which no
/// second wall beside it can be mistaken for.
class InputSurface {
  public:
    /// mesh: without gaps in its numbers; it has to outlive this. smoothing: m, over which normals are
    /// averaged, but not across lines.
    InputSurface(const Mesh& mesh, FeatureLines lines, double smoothing);

    /// A point of the surface.
    struct Site {
        Face face;
        Eigen::Vector3d weights;  ///< of its corners, as face_corners() has them
        Eigen::Vector3d place;    ///< m
    };
    /// The point nearest to `point` (m) among the faces that are reached from `begin` on the way there.
    /// Without `across_lines` these are the faces on its side of feature lines.
    Site nearest(Face begin, const Eigen::Vector3d& point, bool across_lines = true) const;

    const Eigen::Vector3d& normal(Face face) const { return normals[face]; }  ///< unit, averaged
    bool is_line(Halfedge h) const { return lines.of_edge[mesh.edge(h)].line != LineStretch::none; }

    const Mesh& mesh;
    const FeatureLines lines;

  private:
    void average_normals(double smoothing);

    std::vector<Eigen::Vector3d> normals;  ///< [F]
};

}  // namespace sherd
