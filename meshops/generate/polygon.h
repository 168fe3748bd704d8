// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace sherd {

/// Points (m) that are joined by straight lines.
using Polyline = std::vector<Eigen::Vector2d>;

/// A flat region inside its outline and outside its holes, open along its slits. Outline and holes close by
/// themselves and may have either orientation.
struct Polygon {
    Polyline outline;
    std::vector<Polyline> holes, slits;
};

/// Fault of a polygon, and the member that has it.
struct PolygonFault {
    std::string part;  ///< "outline", "holes" or "slits"
    std::string what;  ///< without the part's name: "hole 2 crosses itself"; numbers are from 1
};

/// Returns a fault unless outline and holes are simple polygons of three points or more, holes are inside the
/// outline and apart, and slits are inside the region. A slit may end on the outline or a hole, cross other
/// slits and end on them.
std::optional<PolygonFault> fault_of(const Polygon& polygon);

/// Returns the polygon with common points at its junctions: ends of slits that are on the outline or a hole,
/// up to round-off of their decimals, are moved onto it exactly and become points of both, and slits that
/// meet get a point in both. The polygon must have no fault.
Polygon with_junctions(Polygon polygon);

double area(const Polygon& polygon);  ///< m^2
double length(const Polyline& line);  ///< m, without the side that closes it

/// Returns the distance (m) of a point from the straight line between two others.
double distance_from_side(const Eigen::Vector2d& point, const Eigen::Vector2d& a, const Eigen::Vector2d& b);

}  // namespace sherd
