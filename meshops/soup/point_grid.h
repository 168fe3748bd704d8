// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "meshops/mesh.h"

namespace sherd {

/// Finds points near a segment, with the cells of a grid.
class PointGrid {
  public:
    /// chosen: numbers of the points that can be found, ascending. cell: side of a cell; the search is fast
    /// if segments are about as long. `points` must outlive the grid.
    PointGrid(const std::vector<Point>& points, std::vector<std::uint32_t> chosen, double cell);

    /// Returns the chosen points within `distance` of the segment between `a` and `b`, ascending.
    std::vector<std::uint32_t> near_segment(const Point& a, const Point& b, double distance) const;
    std::vector<std::uint32_t> near_point(const Point& place, double distance) const {
        return near_segment(place, place, distance);
    }

  private:
    /// Calls visit(key) for each cell that the box from `low` to `high` meets.
    template <class Visit>
    void for_each_cell(const Point& low, const Point& high, Visit visit) const;
    std::int64_t row(double coordinate, int axis) const;

    /// Returns points, in any order and perhaps repeated, among which are all chosen points within `distance`
    /// of the segment.
    std::vector<std::uint32_t> candidates(const Point& a, const Point& b, double distance) const;

    const std::vector<Point>& points;
    std::vector<std::uint32_t> chosen;
    Point origin{0, 0, 0};
    double cell;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> found;  ///< points of each cell
};

/// Place on a segment that is nearest to a point: `share`, its fraction of the segment from the start, and
/// `distance`, its distance from the point.
struct PlaceOnSegment {
    double share, distance;
};
PlaceOnSegment place_on_segment(const Point& point, const Point& a, const Point& b);

}  // namespace sherd
