// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/repeated_polygons.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "meshops/soup_edges.h"

namespace sherd {
namespace {

using PolygonCorners = std::vector<std::size_t>;
using PolygonSide = std::pair<std::size_t, std::size_t>;

/// The corners in an order that does not depend on where they begin and which way round they go.
PolygonCorners ordered_corners(const PolygonCorners& corners) {
    PolygonCorners best;
    PolygonCorners turned(corners.rbegin(), corners.rend());
    for (PolygonCorners way : {corners, turned}) {
        std::rotate(way.begin(), std::ranges::min_element(way), way.end());
        if (best.empty() || way < best) best = way;
    }
    return best;
}

void append_sides(const PolygonCorners& corners, std::vector<PolygonSide>& sides) {
    for (std::size_t i = 0; i < corners.size(); ++i)
        sides.push_back(std::minmax({corners[i], corners[(i + 1) % corners.size()]}));
}

/// The sides that are there an odd number of times: those between two parts of a polygon go.
std::vector<PolygonSide> outline(std::vector<PolygonSide> sides) {
    std::ranges::sort(sides);
    std::vector<PolygonSide> result;
    for (const PolygonSide& side : sides) {
        if (!result.empty() && result.back() == side)
            result.pop_back();
        else
            result.push_back(side);
    }
    return result;
}

/// Polygons by the points that they use.
class PolygonsAt {
  public:
    explicit PolygonsAt(const PolygonSoup& soup) : soup(soup), first(soup.points.size() + 1, 0) {
        for (const auto& corners : soup.polygons)
            for (const std::size_t point : corners) ++first[point + 1];
        std::partial_sum(first.begin(), first.end(), first.begin());
        polygons.resize(first.back());
        std::vector<std::size_t> next = first;
        for (std::size_t i = 0; i < soup.polygons.size(); ++i)
            for (const std::size_t point : soup.polygons[i]) polygons[next[point]++] = i;
    }

    /// Returns the polygons of fewer corners, all of which are corners of this one; ascending.
    std::vector<std::size_t> parts_of(std::size_t polygon) const {
        const PolygonCorners& corners = soup.polygons[polygon];
        const auto is_corner = [&](std::size_t point) {
            return std::ranges::find(corners, point) != corners.end();
        };
        std::vector<std::size_t> parts;
        for (const std::size_t point : corners)
            for (std::size_t i = first[point]; i < first[point + 1]; ++i) {
                const PolygonCorners& other = soup.polygons[polygons[i]];
                if (other.size() < corners.size() && std::ranges::all_of(other, is_corner))
                    parts.push_back(polygons[i]);
            }
        std::ranges::sort(parts);
        parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
        return parts;
    }

  private:
    const PolygonSoup& soup;
    std::vector<std::size_t> first,
        polygons;  ///< those at point p are `polygons` from first[p] to first[p + 1]
};

void add_repeated_wholes(const PolygonSoup& soup, std::vector<RepeatedPolygon>& repeated) {
    std::vector<std::pair<PolygonCorners, std::size_t>> known;
    for (std::size_t i = 0; i < soup.polygons.size(); ++i)
        if (soup.polygons[i].size() > 3) known.emplace_back(ordered_corners(soup.polygons[i]), i);
    std::ranges::sort(known);
    for (std::size_t i = 1, whole = 0; i < known.size(); ++i) {
        if (known[i].first == known[whole].first)
            repeated.push_back({known[i].second, known[whole].second});
        else
            whole = i;
    }
}

/// Whether the parts, each taken once, have the outline of the polygon.
bool fill(const PolygonSoup& soup, const std::vector<std::size_t>& parts, std::size_t polygon) {
    std::vector<PolygonCorners> different;
    for (const std::size_t part : parts) different.push_back(ordered_corners(soup.polygons[part]));
    std::ranges::sort(different);
    different.erase(std::unique(different.begin(), different.end()), different.end());
    std::vector<PolygonSide> sides, whole;
    for (const PolygonCorners& corners : different) append_sides(corners, sides);
    append_sides(soup.polygons[polygon], whole);
    return outline(sides) == outline(whole);
}

void add_repeated_parts(const PolygonSoup& soup, std::vector<RepeatedPolygon>& repeated) {
    std::vector<bool> is_repeated(soup.polygons.size(), false);
    for (const RepeatedPolygon& known : repeated) is_repeated[known.polygon] = true;
    const PolygonsAt polygons_at(soup);
    for (std::size_t i = 0; i < soup.polygons.size(); ++i) {
        if (soup.polygons[i].size() <= 3 || is_repeated[i]) continue;
        std::vector<std::size_t> parts = polygons_at.parts_of(i);
        std::erase_if(parts, [&](std::size_t part) { return is_repeated[part]; });
        if (parts.empty() || !fill(soup, parts, i)) continue;
        if (parts[0] < i) {
            repeated.push_back({i, parts[0]});
            is_repeated[i] = true;
            continue;
        }
        for (const std::size_t part : parts) {
            repeated.push_back({part, i});
            is_repeated[part] = true;
        }
    }
}

/// Two triangles at an edge, which is a diagonal of the quadrilateral of their corners.
struct FilledQuadrilateral {
    std::array<std::uint32_t, 2> diagonal, other;  ///< ends, and the other corners, each ascending
    std::array<std::size_t, 2> triangles;          ///< ascending

    auto quadrilateral() const {
        std::array<std::uint32_t, 4> corners{diagonal[0], diagonal[1], other[0], other[1]};
        std::ranges::sort(corners);
        return corners;
    }
    auto order() const { return std::tuple(quadrilateral(), triangles[0], triangles[1]); }
};

FilledQuadrilateral pair_at(const TriangleSoup& soup, const SoupSide& a, const SoupSide& b) {
    const auto apex = [&](const SoupSide& side) {
        return soup.triangles[side.triangle][(side.corner + 2) % 3];
    };
    const auto [low, high] = std::minmax({apex(a), apex(b)});
    return {{a.low, a.high}, {low, high}, {a.triangle, b.triangle}};
}

struct EdgeUse {
    std::array<std::uint32_t, 2> ends;
    std::size_t triangles;
};

/// Whether one triangle begins where the other ends, at the diagonal.
bool lie_on_both_sides(const TriangleSoup& soup, const FilledQuadrilateral& pair) {
    const Point& start = soup.points[pair.diagonal[0]];
    const auto along = soup.points[pair.diagonal[1]] - start;
    const auto normal = [&](std::uint32_t apex) {
        return CGAL::cross_product(along, soup.points[apex] - start);
    };
    return normal(pair.other[0]) * normal(pair.other[1]) < 0;
}

/// The pairs whose other diagonal is an edge, too. uses: gets all edges, ascending.
std::vector<FilledQuadrilateral> crossed_pairs(const TriangleSoup& soup, std::vector<EdgeUse>& uses) {
    constexpr std::size_t most = 8;  // triangles at an edge: more are no sheet that is there twice
    std::vector<FilledQuadrilateral> pairs;
    for_each_soup_edge(soup, [&](std::span<const SoupSide> sides) {
        uses.push_back({{sides[0].low, sides[0].high}, sides.size()});
        if (sides.size() > most) return;
        for (std::size_t i = 0; i < sides.size(); ++i)
            for (std::size_t k = i + 1; k < sides.size(); ++k)
                pairs.push_back(pair_at(soup, sides[i], sides[k]));
    });
    std::erase_if(pairs, [&](const FilledQuadrilateral& pair) {
        return pair.other[0] == pair.other[1] || !lie_on_both_sides(soup, pair) ||
               !std::ranges::binary_search(uses, pair.other, {}, &EdgeUse::ends);
    });
    return pairs;
}

Kernel::Vector_3 area_vector(const TriangleSoup& soup, std::size_t triangle) {
    const auto& [a, b, c] = soup.triangles[triangle];
    return CGAL::cross_product(soup.points[b] - soup.points[a], soup.points[c] - soup.points[a]);
}

/// Whether two pairs lie in one plane, up to the sine of an angle, and cover the same of it.
bool coincide(const TriangleSoup& soup, const FilledQuadrilateral& a, const FilledQuadrilateral& b,
              double sine) {
    const auto reference = area_vector(soup, a.triangles[0]);
    std::array<double, 2> area{};
    for (const auto& [pair, sum] : {std::pair(&a, &area[0]), std::pair(&b, &area[1])})
        for (const std::size_t triangle : pair->triangles) {
            const auto vector = area_vector(soup, triangle);
            const double length = std::sqrt(vector.squared_length() * reference.squared_length());
            if (std::sqrt(CGAL::cross_product(vector, reference).squared_length()) > sine * length)
                return false;
            *sum += std::sqrt(vector.squared_length());
        }
    return std::abs(area[0] - area[1]) <= sine * std::max(area[0], area[1]);
}

/// Whether an edge around a quadrilateral has more than its two pairs: then these are no body of their own.
bool goes_on(const std::vector<EdgeUse>& uses, const FilledQuadrilateral& pair) {
    for (const std::uint32_t a : pair.diagonal)
        for (const std::uint32_t b : pair.other) {
            const std::array<std::uint32_t, 2> ends{std::min(a, b), std::max(a, b)};
            const auto use = std::ranges::lower_bound(uses, ends, {}, &EdgeUse::ends);
            if (use != uses.end() && use->ends == ends && use->triangles > 2) return true;
        }
    return false;
}

}  // namespace

std::vector<RepeatedPolygon> repeated_polygons(const PolygonSoup& soup) {
    std::vector<RepeatedPolygon> repeated;
    const auto is_triangle = [](const PolygonCorners& corners) { return corners.size() <= 3; };
    if (std::ranges::all_of(soup.polygons, is_triangle)) return repeated;
    add_repeated_wholes(soup, repeated);
    add_repeated_parts(soup, repeated);
    std::ranges::sort(repeated, {}, &RepeatedPolygon::polygon);
    return repeated;
}

std::vector<std::size_t> repeated_quadrilaterals(const TriangleSoup& soup, bool alone) {
    constexpr double flat = 1e-9, thin = 0.5;  // sines of angles between faces
    std::vector<EdgeUse> uses;
    std::vector<FilledQuadrilateral> pairs = crossed_pairs(soup, uses);
    std::ranges::sort(pairs, {}, &FilledQuadrilateral::order);
    std::vector<std::size_t> repeated;
    for (std::size_t i = 0, first = 0; i < pairs.size(); ++i) {
        if (pairs[i].quadrilateral() != pairs[first].quadrilateral()) first = i;
        if (pairs[i].diagonal == pairs[first].diagonal) continue;
        const bool is_part = goes_on(uses, pairs[i]);
        if ((is_part || alone) && coincide(soup, pairs[first], pairs[i], is_part ? thin : flat))
            repeated.insert(repeated.end(), pairs[i].triangles.begin(), pairs[i].triangles.end());
    }
    std::ranges::sort(repeated);
    repeated.erase(std::unique(repeated.begin(), repeated.end()), repeated.end());
    return repeated;
}

}  // namespace sherd
