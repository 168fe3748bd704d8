// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "meshops/remesh/input_surface.h"

namespace sherd {

/// How long edges are to be at the points of a surface.
class SizeField {
  public:
    /// `edge_length` (m), or, if it is adaptive, less where chords of that length would leave the surface or
    /// a line by more than a part of it. The surface has to outlive this.
    SizeField(const InputSurface& surface, double edge_length, bool adaptive);

    double at(const InputSurface::Site& site) const;  ///< m
    /// Makes edges at a point (m) as short as `size` (m), and those around it shorter as far as they are
    /// near. Returns whether they were longer.
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
