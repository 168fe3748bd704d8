// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/measures/cracks/crack_graph.h"

namespace sherd {

/// Numbers of cracks about a point of a sheet. All positions are at rest.
struct CracksAbout {
    /// A circle: all points of the sheet at the straight distance `radius` from the point. Radial cracks pass
    /// through a band around the circle.
    struct Circle {
        double radius = 0;  ///< m
        std::size_t cracks = 0;
    };
    /// A half plane that begins at the sheet's normal at the point, and has the direction `angle`. Ring
    /// cracks pass through a sector around the half plane.
    struct Ray {
        double angle = 0;  ///< degrees, counterclockwise about the normal from in_plane_axis()
        std::size_t cracks = 0;
    };

    Vector3d point = Vector3d::Zero();  ///< m
    std::vector<Circle> circles;        ///< ascending by radius
    std::vector<Ray> rays;              ///< only rays on which the sheet reaches beyond the smallest circle

    double radial() const;  ///< median number of radial cracks over the circles
    double ring() const;    ///< median number of ring cracks over the rays
};

/// Counts the cracks of the sheet that is nearest to `point`. A crack is a path along cracked edges from one
/// side of a band or a sector to the other side. Counted paths have no common edge, so that a zigzag along
/// one line is one crack; a path that only follows the circle or the ray is no crack. A band reaches to both
/// sides of its circle by the mean length of cracked edges, but at most by half the radius. A sector reaches
/// to both sides of its ray by a quarter of the 22.5 degrees between rays, or by the mean length of cracked
/// edges if that is farther; the sector begins at the smallest circle. radii: radii of the circles, m,
/// positive; if empty, 1/8 to 7/8 of the distance from the point to the farthest vertex of its sheet.
CracksAbout cracks_about(const CrackGraph& cracks, const Snapshot& frame, const Vector3d& point,
                         std::vector<double> radii = {});

}  // namespace sherd
