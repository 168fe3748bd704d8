// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "meshops/remesh/input_surface.h"

namespace sherd {

/// Target edge length at the points of a surface.
class SizeField {
  public:
    /// Target length `edge_length` (m) or, if it is adaptive, less where chords of that length would deviate
    /// from the surface or a line by more than a fraction of it. The surface has to outlive this.
    SizeField(const InputSurface& surface, double edge_length, bool adaptive);

    double at(const InputSurface::Site& site) const;  ///< m
    /// Reduces the target length at a point to `size` (m), and less so around it. Returns whether it was
    /// larger.
    bool refine(const InputSurface::Site& site, double size);

  private:
    struct Source {
        Eigen::Vector3d place;
        double size;
    };

    const InputSurface& surface;
    std::vector<double> sizes;  ///< [V] m, by curvature
    std::vector<Source> sources;
};

}  // namespace sherd
