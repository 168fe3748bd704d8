// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/repair/seams.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "meshops/soup/triangle_soup.h"

namespace sherd {

std::vector<std::array<std::uint32_t, 2>> seam_edges(const TriangleSoup& soup) {
    struct Placed {
        std::array<Point, 2> ends;
        std::array<std::uint32_t, 2> points;
    };
    std::vector<Placed> borders;
    for_each_soup_edge(soup, [&](std::span<const SoupSide> sides) {
        if (sides.size() != 1) return;
        const auto a = sides[0].low, b = sides[0].high;
        const bool rising = soup.points[a] < soup.points[b];
        borders.push_back({{soup.points[rising ? a : b], soup.points[rising ? b : a]}, {a, b}});
    });
    std::ranges::sort(borders, [](const Placed& a, const Placed& b) {
        return a.ends != b.ends ? a.ends < b.ends : a.points < b.points;
    });
    std::vector<std::array<std::uint32_t, 2>> seams;
    for (std::size_t i = 0; i < borders.size(); ++i) {
        const bool as_before = i > 0 && borders[i].ends == borders[i - 1].ends;
        const bool as_next = i + 1 < borders.size() && borders[i].ends == borders[i + 1].ends;
        if (as_before || as_next) seams.push_back(borders[i].points);
    }
    std::ranges::sort(seams);
    return seams;
}

namespace {

using EdgePoints = std::array<std::uint32_t, 2>;

/// The boundary edges of a soup, ascending, with a grid in which their ends are searched.
class SoupBorder {
  public:
    explicit SoupBorder(const TriangleSoup& soup) : soup(soup) {
        for_each_soup_edge(soup, [&](std::span<const SoupSide> sides) {
            if (sides.size() != 1) return;
            edges.push_back({sides[0].low, sides[0].high});
            apexes.push_back(soup.triangles[sides[0].triangle][(sides[0].corner + 2) % 3]);
        });
        std::vector<std::uint32_t> ends;
        double sum = 0;
        for (const EdgePoints& edge : edges) {
            ends.insert(ends.end(), edge.begin(), edge.end());
            sum += length(edge);
        }
        std::ranges::sort(ends);
        ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
        grid.emplace(soup.points, std::move(ends),
                     sum / static_cast<double>(std::max<std::size_t>(edges.size(), 1)));
    }

    double length(const EdgePoints& edge) const { return distance(edge[0], edge[1]); }
    double distance(std::uint32_t a, std::uint32_t b) const {
        return std::sqrt(CGAL::squared_distance(soup.points[a], soup.points[b]));
    }
    std::vector<std::uint32_t> near(std::uint32_t point, double within) const {
        return grid->near_point(soup.points[point], within);
    }
    std::vector<std::uint32_t> near(const EdgePoints& edge, double within) const {
        return grid->near_segment(soup.points[edge[0]], soup.points[edge[1]], within);
    }
    bool has(std::uint32_t a, std::uint32_t b) const {
        return std::ranges::binary_search(edges, EdgePoints{std::min(a, b), std::max(a, b)});
    }

    const TriangleSoup& soup;
    std::vector<EdgePoints> edges;
    std::vector<std::uint32_t> apexes;  ///< third corner of each edge's triangle

  private:
    std::optional<PointGrid> grid;
};

/// Returns the gap between an edge and the nearest other boundary edge: the larger of the two distances
/// between corresponding ends. Returns nullopt if no other edge has both ends within `within`.
std::optional<double> gap_of(const SoupBorder& border, const EdgePoints& edge, double within) {
    std::optional<double> least;
    const std::vector<std::uint32_t> ends = border.near(edge[1], within);
    for (const std::uint32_t a : border.near(edge[0], within))
        for (const std::uint32_t b : ends) {
            if ((a == edge[0] && b == edge[1]) || a == edge[1] || b == edge[0] || !border.has(a, b)) continue;
            const double gap = std::max(border.distance(edge[0], a), border.distance(edge[1], b));
            least = std::min(least.value_or(gap), gap);
        }
    return least;
}

}  // namespace

NearSeams near_seams(const TriangleSoup& soup, double share) {
    const SoupBorder border(soup);
    NearSeams seams;
    for (const EdgePoints& edge : border.edges) {
        const double length = border.length(edge);
        const std::optional<double> gap = gap_of(border, edge, share * length);
        if (!gap || *gap == 0) continue;
        seams.edges.push_back(edge);
        seams.length += length;
        seams.gap = std::max(seams.gap, *gap);
    }
    return seams;
}

std::vector<Junction> junctions(const TriangleSoup& soup, double share, double distance) {
    const SoupBorder border(soup);
    std::vector<Junction> found;
    for (std::size_t i = 0; i < border.edges.size(); ++i) {
        const EdgePoints& edge = border.edges[i];
        const double within = std::min(share * border.length(edge), distance);
        const std::size_t before = found.size();
        for (const std::uint32_t point : border.near(edge, within)) {
            if (point == border.apexes[i] || border.distance(point, edge[0]) <= within ||
                border.distance(point, edge[1]) <= within)
                continue;
            const Point &a = soup.points[edge[0]], &b = soup.points[edge[1]];
            found.push_back({edge, point, place_on_segment(soup.points[point], a, b)});
        }
        std::sort(found.begin() + static_cast<std::ptrdiff_t>(before), found.end(),
                  [](const Junction& a, const Junction& b) {
                      return std::pair(a.place.share, a.point) < std::pair(b.place.share, b.point);
                  });
    }
    return found;
}

namespace {

/// Divides triangles of a soup by points on their edges.
class JunctionDivision {
  public:
    JunctionDivision(TriangleSoup& soup, std::vector<Junction> junctions)
        : soup(soup), junctions(std::move(junctions)) {}

    void divide() {
        const TriangleSoup old = soup;
        soup.triangles.clear(), soup.texture.clear(), soup.polygon.clear();
        for (std::size_t t = 0; t < old.triangles.size(); ++t) {
            Part whole{old.triangles[t], {}, old.polygon[t], {true, true, true}};
            if (!old.texture.empty()) whole.texture = old.texture[t];
            add(whole);
        }
    }

  private:
    /// A triangle of the old soup or a part of such a triangle.
    struct Part {
        std::array<std::uint32_t, 3> corners;
        std::optional<FaceTexture> texture;
        std::size_t polygon;
        std::array<bool, 3> is_open;  ///< for each side, whether points may lie on it
    };

    std::span<const Junction> on_side(const Part& part, int side) const {
        if (!part.is_open[side]) return {};
        const auto [low, high] = std::minmax(part.corners[side], part.corners[(side + 1) % 3]);
        const EdgePoints edge{low, high};
        return {std::ranges::lower_bound(junctions, edge, {}, &Junction::edge),
                std::ranges::upper_bound(junctions, edge, {}, &Junction::edge)};
    }

    void add(const Part& part) {
        for (int side = 0; side < 3; ++side)
            if (const auto points = on_side(part, side); !points.empty())
                return add_parts(part, side, points);
        soup.triangles.push_back(part.corners);
        soup.polygon.push_back(part.polygon);
        if (part.texture) soup.texture.push_back(*part.texture);
    }

    /// Divides a triangle at the points on its side number `side`, beginning at the start of that side.
    void add_parts(const Part& whole, int side, std::span<const Junction> points) {
        const int end = (side + 1) % 3, last = (side + 2) % 3;
        const bool is_rising = whole.corners[side] < whole.corners[end];
        Part rest = whole;
        rest.is_open[side] = false;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Junction& junction = points[is_rising ? i : points.size() - 1 - i];
            const double share = is_rising ? junction.place.share : 1 - junction.place.share;
            Part part = rest;
            part.corners[end] = rest.corners[side] = junction.point;
            part.is_open[end] = rest.is_open[last] = false;
            if (whole.texture)
                (*part.texture)[end] = (*rest.texture)[side] =
                    (1 - share) * (*whole.texture)[side] + share * (*whole.texture)[end];
            add(part);
        }
        add(rest);
    }

    TriangleSoup& soup;
    std::vector<Junction> junctions;
};

}  // namespace

std::size_t split_at_junctions(TriangleSoup& soup, double distance) {
    std::vector<Junction> found = junctions(soup, 1, distance);
    std::size_t edges = 0;
    for (std::size_t i = 0; i < found.size(); ++i) edges += i == 0 || found[i].edge != found[i - 1].edge;
    if (edges > 0) JunctionDivision(soup, std::move(found)).divide();
    return edges;
}

}  // namespace sherd
