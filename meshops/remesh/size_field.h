// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "meshops/remesh/input_surface.h"

namespace sherd {

/// Target edge length at the points of a surface.
class SizeField {
  public:
    /// The target length is `edge_length` (m). If it is adaptive, it is less where chords of that length
    /// would deviate from the surface, or from a line, by more than a fraction of `edge_length`. `surface`
    /// must outlive this.
    SizeField(const InputSurface& surface, double edge_length, bool adaptive);

    double at(const InputSurface::Site& site) const;  ///< m, target length
    /// Reduces the target length at a point to `size` (m), and by less around the point. Returns whether it
    /// was larger before.
    bool refine(const InputSurface::Site& site, double size);

  private:
    struct Source {
        Eigen::Vector3d place;
        double size;
    };

    const InputSurface& surface;
    std::vector<double> sizes;  ///< [V] m, target lengths by curvature
    std::vector<Source> sources;
};

}  // namespace sherd
