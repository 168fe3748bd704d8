// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/generate/polygon.h"

#include <CGAL/Polygon_2.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "meshops/mesh.h"
#include "meshops/plane.h"

namespace sherd {
namespace {

using Eigen::Vector2d;
using Segment = std::array<Vector2d, 2>;

constexpr double round_off = 1e-6;  // fraction of the outline's diagonal: nearer points coincide

Kernel::Point_2 exact(const Vector2d& p) {
    return {p.x(), p.y()};
}

Vector2d nearest_on_side(const Vector2d& point, const Vector2d& a, const Vector2d& b) {
    const Vector2d side = b - a;
    return a + std::clamp((point - a).dot(side) / side.squaredNorm(), 0.0, 1.0) * side;
}

std::vector<Segment> sides_of(const Polyline& line, bool is_closed) {
    std::vector<Segment> sides;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) sides.push_back({line[i], line[i + 1]});
    if (is_closed) sides.push_back({line.back(), line.front()});
    return sides;
}

bool boxes_meet(const Segment& a, const Segment& b) {
    return (a[0].cwiseMin(a[1]).array() <= b[0].cwiseMax(b[1]).array()).all() &&
           (b[0].cwiseMin(b[1]).array() <= a[0].cwiseMax(a[1]).array()).all();
}

bool meet(const Segment& a, const Segment& b) {
    return boxes_meet(a, b) && CGAL::do_intersect(Kernel::Segment_2(exact(a[0]), exact(a[1])),
                                                  Kernel::Segment_2(exact(b[0]), exact(b[1])));
}

bool meet(const std::vector<Segment>& some, const std::vector<Segment>& others) {
    return std::ranges::any_of(some, [&](const Segment& a) {
        return std::ranges::any_of(others, [&](const Segment& b) { return meet(a, b); });
    });
}

CGAL::Polygon_2<Kernel> exact(const Polyline& loop) {
    CGAL::Polygon_2<Kernel> polygon;
    for (const Vector2d& p : loop) polygon.push_back(exact(p));
    return polygon;
}

bool is_inside(const Polyline& loop, const Vector2d& p) {
    const CGAL::Polygon_2<Kernel> polygon = exact(loop);
    return CGAL::bounded_side_2(polygon.begin(), polygon.end(), exact(p), Kernel()) == CGAL::ON_BOUNDED_SIDE;
}

double tolerance(const Polygon& polygon) {
    Vector2d lower = polygon.outline.front(), upper = lower;
    for (const Vector2d& p : polygon.outline) {
        lower = lower.cwiseMin(p);
        upper = upper.cwiseMax(p);
    }
    return round_off * (upper - lower).norm();
}

std::string fault_of_points(const Polyline& line, std::size_t least, bool is_closed) {
    if (line.size() < least)
        return "has " + std::to_string(line.size()) + " points, but needs " + std::to_string(least) +
               " or more";
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (!line[i].allFinite())
            return "has a coordinate that is NaN or infinite, at point " + std::to_string(i + 1);
        const std::size_t next = (i + 1) % line.size();
        if ((next > 0 || is_closed) && line[i] == line[next])
            return "has the same point twice, as points " + std::to_string(i + 1) + " and " +
                   std::to_string(next + 1) + ": leave one out" +
                   (next == 0 ? " (a loop is closed without it)" : "");
    }
    return {};
}

std::string fault_of_loop(const Polyline& loop) {
    if (std::string fault = fault_of_points(loop, 3, true); !fault.empty()) return fault;
    return exact(loop).is_simple() ? "" : "crosses or touches itself";
}

std::string fault_of_hole(const Polygon& polygon, std::size_t number) {
    const Polyline& hole = polygon.holes[number];
    if (std::string fault = fault_of_loop(hole); !fault.empty()) return fault;
    const std::vector<Segment> own = sides_of(hole, true);
    if (meet(own, sides_of(polygon.outline, true)))
        return "crosses or touches the outline: cut it out of the outline instead";
    if (!is_inside(polygon.outline, hole.front())) return "is outside of the outline";
    for (std::size_t i = 0; i < number; ++i) {
        const Polyline& other = polygon.holes[i];
        if (meet(own, sides_of(other, true)) || is_inside(other, hole.front()) ||
            is_inside(hole, other.front()))
            return "meets hole " + std::to_string(i + 1) + ": merge the two";
    }
    return {};
}

/// Returns all sides of outline and holes.
std::vector<Segment> borders_of(const Polygon& polygon) {
    std::vector<Segment> all = sides_of(polygon.outline, true);
    for (const Polyline& hole : polygon.holes) {
        const std::vector<Segment> sides = sides_of(hole, true);
        all.insert(all.end(), sides.begin(), sides.end());
    }
    return all;
}

bool is_on(const std::vector<Segment>& borders, const Vector2d& p, double reach) {
    return std::ranges::any_of(
        borders, [&](const Segment& side) { return distance_from_side(p, side[0], side[1]) <= reach; });
}

/// Returns the points in which two sides meet: ends of one side that are on the other, or the point where
/// they cross.
std::vector<Vector2d> meeting_points(const Segment& a, const Segment& b, double reach) {
    std::vector<Vector2d> found;
    const auto add = [&](const Vector2d& p, const Segment& other) {
        const bool known =
            std::ranges::any_of(found, [&](const Vector2d& q) { return (q - p).norm() <= reach; });
        if (!known && distance_from_side(p, other[0], other[1]) <= reach) found.push_back(p);
    };
    for (const Vector2d& end : a) add(end, b);
    for (const Vector2d& end : b) add(end, a);
    if (found.empty() && meet(a, b)) {
        const Vector2d along = a[1] - a[0], across = b[1] - b[0];
        found.push_back(a[0] + cross(b[0] - a[0], across) / cross(along, across) * along);
    }
    return found;
}

/// Returns the fault of a slit where it meets itself or slits before it; empty if there is none.
std::string fault_of_meetings(const Polygon& polygon, std::size_t number, double reach) {
    const std::vector<Segment> own = sides_of(polygon.slits[number], false);
    for (std::size_t i = 0; i <= number; ++i) {
        const std::vector<Segment> others = sides_of(polygon.slits[i], false);
        for (std::size_t a = 0; a < own.size(); ++a)
            for (std::size_t b = 0; b < others.size(); ++b) {
                if (i == number && b + 1 >= a) break;
                if (meeting_points(own[a], others[b], reach).size() > 1)
                    return "runs along slit " + std::to_string(i + 1) + ": merge the two";
                if (i == number && !meeting_points(own[a], others[b], reach).empty())
                    return "meets itself: divide it into several slits";
            }
    }
    return {};
}

std::string fault_of_slit(const Polygon& polygon, std::size_t number) {
    const Polyline& slit = polygon.slits[number];
    if (std::string fault = fault_of_points(slit, 2, false); !fault.empty()) return fault;
    const double reach = tolerance(polygon);
    const std::vector<Segment> borders = borders_of(polygon);
    std::vector<Segment> sides = sides_of(slit, false);
    for (const auto& [side, end] : {std::pair(0u, 0), std::pair(unsigned(sides.size() - 1), 1)}) {
        Vector2d& tip = sides[side][end];
        const Vector2d inward = sides[side][1 - end] - tip;
        // An end on the outline or on a hole is moved a little along the slit, so that the slit does not
        // touch these if it has no fault.
        if (is_on(borders, tip, reach)) tip += std::min(0.5, 4 * reach / inward.norm()) * inward;
    }
    const Vector2d tip = sides.front()[0];
    const bool is_in_hole =
        std::ranges::any_of(polygon.holes, [&](const Polyline& hole) { return is_inside(hole, tip); });
    if (!is_inside(polygon.outline, tip) || is_in_hole) return "is outside of the outline, or in a hole";
    if (meet(sides, borders)) return "crosses or touches an outline or a hole on its way: end it there";
    return fault_of_meetings(polygon, number, reach);
}

/// Inserts `point` into the line's side number `side`, on which it lies. If an end of the side is within
/// `reach` (m) of the point, it is moved there instead.
void put(Polyline& line, std::size_t side, const Vector2d& point, double reach) {
    for (const std::size_t end : {side, (side + 1) % line.size()})
        if ((line[end] - point).norm() <= reach) {
            line[end] = point;
            return;
        }
    line.insert(line.begin() + static_cast<std::ptrdiff_t>(side) + 1, point);
}

/// Moves `tip`, the end of a slit, onto the outline or hole that is within `reach` (m) of it, if any, and
/// gives that a point there.
void attach(Vector2d& tip, Polygon& polygon, double reach) {
    std::vector<Polyline*> loops{&polygon.outline};
    for (Polyline& hole : polygon.holes) loops.push_back(&hole);
    for (Polyline* loop : loops)
        for (std::size_t i = 0; i < loop->size(); ++i) {
            const Vector2d &a = (*loop)[i], &b = (*loop)[(i + 1) % loop->size()];
            if (distance_from_side(tip, a, b) > reach) continue;
            tip = nearest_on_side(tip, a, b);
            for (const Vector2d& corner : {a, b})
                if ((tip - corner).norm() <= reach) tip = corner;
            return put(*loop, i, tip, reach);
        }
}

void join(Polyline& one, Polyline& other, double reach) {
    for (std::size_t a = 0; a + 1 < one.size(); ++a)
        for (std::size_t b = 0; b + 1 < other.size(); ++b)
            for (const Vector2d& point :
                 meeting_points({one[a], one[a + 1]}, {other[b], other[b + 1]}, reach)) {
                put(one, a, point, reach);
                put(other, b, point, reach);
            }
}

}  // namespace

double distance_from_side(const Vector2d& point, const Vector2d& a, const Vector2d& b) {
    return (nearest_on_side(point, a, b) - point).norm();
}

std::optional<PolygonFault> fault_of(const Polygon& polygon) {
    if (std::string fault = fault_of_loop(polygon.outline); !fault.empty())
        return PolygonFault{"outline", fault};
    for (std::size_t i = 0; i < polygon.holes.size(); ++i)
        if (std::string fault = fault_of_hole(polygon, i); !fault.empty())
            return PolygonFault{"holes", "hole " + std::to_string(i + 1) + " " + fault};
    for (std::size_t i = 0; i < polygon.slits.size(); ++i)
        if (std::string fault = fault_of_slit(polygon, i); !fault.empty())
            return PolygonFault{"slits", "slit " + std::to_string(i + 1) + " " + fault};
    return {};
}

Polygon with_junctions(Polygon polygon) {
    const double reach = tolerance(polygon);
    for (Polyline& slit : polygon.slits) {
        attach(slit.front(), polygon, reach);
        attach(slit.back(), polygon, reach);
    }
    for (std::size_t i = 0; i < polygon.slits.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) join(polygon.slits[i], polygon.slits[j], reach);
    return polygon;
}

double area(const Polygon& polygon) {
    const auto within = [](const Polyline& loop) {
        double twice = 0;
        for (const auto& [a, b] : sides_of(loop, true)) twice += cross(a - loop.front(), b - loop.front());
        return std::abs(twice) / 2;
    };
    double sum = within(polygon.outline);
    for (const Polyline& hole : polygon.holes) sum -= within(hole);
    return sum;
}

double length(const Polyline& line) {
    double sum = 0;
    for (const auto& [a, b] : sides_of(line, false)) sum += (b - a).norm();
    return sum;
}

}  // namespace sherd
