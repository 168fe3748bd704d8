// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/repair/separate_sheets.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "meshops/disjoint_sets.h"
#include "meshops/soup/triangle_soup.h"

namespace sherd {
namespace {

using EdgeSides = std::span<const SoupSide>;
using SidePair = std::array<SoupSide, 2>;

/// Two triangles at an edge where more than two meet, with the criteria that decide which pairs stay joined:
/// pairs with a small key() are preferred.
struct SheetPair {
    SidePair sides;
    bool disagree;   ///< whether their orientations disagree
    bool only_here;  ///< whether no edges of two triangles connect them elsewhere
    double bend;     ///< dihedral angle in 1e-6 rad, rounded so that round-off does not decide
    bool inward;     ///< whether they bend towards their normals

    auto key() const { return std::tuple(disagree, only_here, bend, inward); }
    auto order() const { return std::tuple(key(), sides[0].triangle, sides[1].triangle); }
    bool has(const SoupSide& side) const {
        return side.key() == sides[0].key() || side.key() == sides[1].key();
    }
};

Kernel::Vector_3 unit(const Kernel::Vector_3& v) {
    return v / std::sqrt(v.squared_length());
}

/// Returns the unit vector in the plane of the triangle of a side that is perpendicular to the side and
/// points into the triangle.
Kernel::Vector_3 away_from(const TriangleSoup& soup, const SoupSide& side) {
    const auto& triangle = soup.triangles[side.triangle];
    const Point& start = soup.points[triangle[side.corner]];
    const auto along = unit(soup.points[triangle[(side.corner + 1) % 3]] - start);
    const auto apex = soup.points[triangle[(side.corner + 2) % 3]] - start;
    return unit(apex - along * (along * apex));
}

SheetPair sheet_pair(const TriangleSoup& soup, DisjointSets& parts, const SoupSide& a, const SoupSide& b) {
    const auto way_a = away_from(soup, a), way_b = away_from(soup, b);
    const auto& triangle = soup.triangles[a.triangle];
    const auto along = soup.points[triangle[(a.corner + 1) % 3]] - soup.points[triangle[a.corner]];
    const auto normal = CGAL::cross_product(along, way_a);
    const double sine = std::sqrt(CGAL::cross_product(way_a, way_b).squared_length());
    return {{a, b},
            a.is_rising == b.is_rising,
            parts.find(a.triangle) != parts.find(b.triangle),
            std::round(1e6 * std::atan2(sine, -(way_a * way_b))),
            a.is_rising != b.is_rising && normal * way_b > 0};
}

/// Returns the pairs of triangles at an edge that stay joined. sides: the sides of all triangles at the edge;
/// parts: result of parts_of().
std::vector<SidePair> sheets_at(const TriangleSoup& soup, DisjointSets& parts, EdgeSides sides) {
    if (sides.size() == 2) return {{sides[0], sides[1]}};
    std::vector<SheetPair> candidates;
    for (std::size_t i = 0; i < sides.size(); ++i)
        for (std::size_t k = i + 1; k < sides.size(); ++k)
            candidates.push_back(sheet_pair(soup, parts, sides[i], sides[k]));
    std::ranges::sort(candidates, {}, &SheetPair::order);
    std::vector<SidePair> pairs;
    while (!candidates.empty()) {
        const SheetPair best = candidates.front();
        const auto meets = [](const SheetPair& one) {
            return
                [&one](const SheetPair& other) { return other.has(one.sides[0]) || other.has(one.sides[1]); };
        };
        const auto rival = std::ranges::find_if(
            candidates.begin() + 1, candidates.end(),
            [&](const auto& other) { return other.key() == best.key() && meets(best)(other); });
        if (rival == candidates.end())
            pairs.push_back(best.sides);
        else
            std::erase_if(candidates, meets(SheetPair(*rival)));
        std::erase_if(candidates, meets(best));
    }
    return pairs;
}

/// Returns the sets of triangles that are connected by edges of two triangles.
DisjointSets parts_of(const TriangleSoup& soup) {
    DisjointSets parts(soup.triangles.size());
    for_each_soup_edge(soup, [&](EdgeSides sides) {
        if (sides.size() == 2) parts.join(sides[0].triangle, sides[1].triangle);
    });
    return parts;
}

std::uint32_t double_point(TriangleSoup& soup, std::uint32_t point) {
    soup.points.push_back(Point(soup.points[point]));
    soup.file_vertex.push_back(std::uint32_t{soup.file_vertex[point]});
    return static_cast<std::uint32_t>(soup.points.size() - 1);
}

/// Returns the fans as sets of triangle corners, numbered 3 t + corner: the corners at a point of triangles
/// that stay joined at an edge of this point are in one set.
DisjointSets fans(const TriangleSoup& soup) {
    DisjointSets parts = parts_of(soup), sets(3 * soup.triangles.size());
    const auto corner = [](const SoupSide& side, bool low) {
        return 3 * side.triangle + static_cast<std::size_t>((side.corner + (side.is_rising != low)) % 3);
    };
    for_each_soup_edge(soup, [&](EdgeSides sides) {
        if (sides.size() < 2) return;
        for (const auto& [a, b] : sheets_at(soup, parts, sides))
            for (const bool low : {true, false}) sets.join(corner(a, low), corner(b, low));
    });
    return sets;
}

/// At each point, gives each fan except the first a point of its own. Returns the points that were
/// duplicated.
std::vector<std::uint32_t> separate_fans(TriangleSoup& soup) {
    DisjointSets sets = fans(soup);
    constexpr std::uint32_t none = -1;
    std::vector<std::uint32_t> point_of_fan(3 * soup.triangles.size(), none);
    std::vector<bool> is_taken(soup.points.size(), false);
    std::vector<std::uint32_t> doubled;
    for (std::size_t corner = 0; corner < point_of_fan.size(); ++corner) {
        std::uint32_t& point = soup.triangles[corner / 3][corner % 3];
        std::uint32_t& fan_point = point_of_fan[sets.find(corner)];
        if (fan_point == none && is_taken[point]) {
            doubled.push_back(point);
            fan_point = double_point(soup, point);
        } else if (fan_point == none) {
            fan_point = point;
            is_taken[point] = true;
        }
        point = fan_point;
    }
    return doubled;
}

/// Detaches all triangles except one pair from each edge of three or more. Returns the points that were
/// duplicated.
std::vector<std::uint32_t> detach_surplus(TriangleSoup& soup) {
    DisjointSets parts = parts_of(soup);
    std::vector<std::size_t> surplus;
    for_each_soup_edge(soup, [&](EdgeSides sides) {
        if (sides.size() < 3) return;
        const auto sheets = sheets_at(soup, parts, sides);
        const SidePair kept = sheets.empty() ? SidePair{sides[0], sides[1]} : sheets[0];
        for (const SoupSide& side : sides)
            if (side.key() != kept[0].key() && side.key() != kept[1].key()) surplus.push_back(side.triangle);
    });
    std::ranges::sort(surplus);
    surplus.erase(std::unique(surplus.begin(), surplus.end()), surplus.end());
    std::vector<std::uint32_t> doubled;
    for (const std::size_t triangle : surplus) {
        for (auto& point : soup.triangles[triangle]) {
            doubled.push_back(point);
            point = double_point(soup, point);
        }
    }
    return doubled;
}

}  // namespace

std::vector<std::uint32_t> separate_sheets(TriangleSoup& soup) {
    std::vector<std::uint32_t> doubled;
    while (true) {
        auto now = separate_fans(soup);
        // If triangles still share an edge of three or more, they belong to one fan at each of its ends.
        if (now.empty()) now = detach_surplus(soup);
        if (now.empty()) break;
        doubled.insert(doubled.end(), now.begin(), now.end());
    }
    std::ranges::sort(doubled);
    doubled.erase(std::unique(doubled.begin(), doubled.end()), doubled.end());
    return doubled;
}

}  // namespace sherd
