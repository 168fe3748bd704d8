// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "meshops/mesh.h"

namespace sherd {

/// Finds points that are near to a segment, by the cells of a grid.
class PointGrid {
  public:
    /// Takes the numbers of the points to be found, ascending, and the side of a cell: the search is fast
    /// where segments are about as long. `points` must outlive the grid.
    PointGrid(const std::vector<Point>& points, std::vector<std::uint32_t> chosen, double cell);

    /// Returns the points within `distance` of the segment between `a` and `b`, ascending.
    std::vector<std::uint32_t> near_segment(const Point& a, const Point& b, double distance) const;
    std::vector<std::uint32_t> near_point(const Point& place, double distance) const {
        return near_segment(place, place, distance);
    }

  private:
    /// Calls visit(key) for each cell that a box meets.
    template <class Visit>
    void for_each_cell(const Point& low, const Point& high, Visit visit) const;
    std::int64_t row(double coordinate, int axis) const;

    /// Points of the cells near a segment, in any order.
    std::vector<std::uint32_t> candidates(const Point& a, const Point& b, double distance) const;

    const std::vector<Point>& points;
    std::vector<std::uint32_t> chosen;
    Point origin{0, 0, 0};
    double cell;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> found;  ///< points of each cell
};

/// The place of a point along the segment from `a` to `b`, from 0 to 1, and its distance from the segment.
struct PlaceOnSegment {
    double share, distance;
};
PlaceOnSegment place_on_segment(const Point& point, const Point& a, const Point& b);

}  // namespace sherd
