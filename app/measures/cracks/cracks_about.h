// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/measures/cracks/crack_graph.h"

namespace sherd {

/// Cracks about a point of a sheet, as they lie at rest.
struct CracksAbout {
    /// Radial cracks pass through a band around the circle of points at a straight distance of `radius`.
    struct Circle {
        double radius = 0;  ///< m
        std::size_t cracks = 0;
    };
    /// Ring cracks pass through a sector around the half plane that has the normal at the point and `angle`.
    struct Ray {
        double angle = 0;  ///< degrees, counterclockwise about the normal from in_plane_axis()
        std::size_t cracks = 0;
    };

    Vector3d point = Vector3d::Zero();  ///< m
    std::vector<Circle> circles;        ///< ascending by radius
    std::vector<Ray> rays;              ///< rays on which a sheet reaches beyond the smallest circle

    double radial() const;  ///< median over the circles
    double ring() const;    ///< median over the rays
};

/// Counts the cracks of the sheet that is nearest to `point`. Paths without a common edge are counted, so
/// that a zigzag along one line is one crack, and a path along the circle or the ray is none. The band
/// reaches the mean length of cracked edges to either side of the circle, the sector a quarter of the 22.5
/// degrees between rays, or as far as the band if that is more; the sector begins at the smallest circle.
/// radii: m, positive; empty: eighths of the distance from the point to the farthest vertex of its sheet, 1
/// to 7.
CracksAbout cracks_about(const CrackGraph& cracks, const Snapshot& frame, const Vector3d& point,
                         std::vector<double> radii = {});

}  // namespace sherd
