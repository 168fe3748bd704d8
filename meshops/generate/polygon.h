// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace sherd {

/// Points (m) that are joined by straight lines.
using Polyline = std::vector<Eigen::Vector2d>;

/// A flat region inside its outline and outside its holes, open along its slits. Outline and holes are closed
/// without repeating their first point, in any orientation.
struct Polygon {
    Polyline outline;
    std::vector<Polyline> holes, slits;
};

/// Fault of a polygon, and the member of Polygon that has it.
struct PolygonFault {
    std::string part;  ///< "outline", "holes" or "slits"
    std::string what;  ///< such as "hole 2 crosses itself" (counted from 1); of the outline "crosses itself"
};

/// Returns a fault, if there is any. Outline and holes must be simple polygons of three points or more, holes
/// must be inside the outline and apart from each other, and slits inside the region. A slit may end on the
/// outline or on a hole, cross other slits and end on them.
std::optional<PolygonFault> fault_of(const Polygon& polygon);

/// Returns the polygon with a common point of the lines at each junction. The end of a slit that is on the
/// outline or on a hole, up to the round-off of its decimals, is moved onto that line exactly, and the line
/// gets a point there. Slits that meet get a point there, too. The polygon must have no fault.
Polygon with_junctions(Polygon polygon);

double area(const Polygon& polygon);  ///< m^2
double length(const Polyline& line);  ///< m, length of the line; if it is a loop, without its last side

/// Returns the distance (m) of a point from the straight segment between `a` and `b`.
double distance_from_side(const Eigen::Vector2d& point, const Eigen::Vector2d& a, const Eigen::Vector2d& b);

}  // namespace sherd
