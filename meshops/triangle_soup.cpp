// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/triangle_soup.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <tuple>

namespace sherd {
namespace {

/// A side of a triangle, with its points in ascending order.
struct Side {
    std::uint32_t low, high;
    std::size_t triangle;
    int corner;      ///< the corner where it starts
    bool is_rising;  ///< whether it starts at `low`

    auto edge() const { return std::tuple(low, high); }
    auto key() const { return std::tuple(low, high, triangle, corner); }
};

/// Calls visit(sides) for each edge, with its sides in the order of the triangles.
template <typename Visit>
void for_each_edge(const TriangleSoup& soup, Visit visit) {
    std::vector<Side> sides;
    sides.reserve(3 * soup.triangles.size());
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
        for (int corner = 0; corner < 3; ++corner) {
            const auto a = soup.triangles[t][corner], b = soup.triangles[t][(corner + 1) % 3];
            sides.push_back({std::min(a, b), std::max(a, b), t, corner, a < b});
        }
    }
    std::ranges::sort(sides, {}, &Side::key);
    for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
        while (end < sides.size() && sides[end].edge() == sides[begin].edge()) ++end;
        visit(std::span<const Side>(sides).subspan(begin, end - begin));
    }
}

/// Disjoint sets of numbers; each set is represented by its lowest number.
class DisjointSets {
  public:
    explicit DisjointSets(std::size_t count) : parent(count) {
        std::iota(parent.begin(), parent.end(), std::size_t{0});
    }
    std::size_t find(std::size_t i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    }
    void join(std::size_t a, std::size_t b) {
        a = find(a), b = find(b);
        parent[std::max(a, b)] = std::min(a, b);
    }

  private:
    std::vector<std::size_t> parent;
};

std::uint32_t double_point(TriangleSoup& soup, std::uint32_t point) {
    soup.points.push_back(Point(soup.points[point]));
    soup.file_vertex.push_back(std::uint32_t{soup.file_vertex[point]});
    return static_cast<std::uint32_t>(soup.points.size() - 1);
}

/// Sets of corners (3 t + corner) at a point that are connected across edges of exactly two triangles.
DisjointSets fans(const TriangleSoup& soup) {
    DisjointSets sets(3 * soup.triangles.size());
    for_each_edge(soup, [&](std::span<const Side> sides) {
        if (sides.size() != 2) return;
        const auto corner = [](const Side& side, bool low) {
            return 3 * side.triangle + static_cast<std::size_t>((side.corner + (side.is_rising != low)) % 3);
        };
        sets.join(corner(sides[0], true), corner(sides[1], true));
        sets.join(corner(sides[0], false), corner(sides[1], false));
    });
    return sets;
}

/// Gives each fan but the first at a point a point of its own. Returns the points that were duplicated.
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

/// Detaches all but the first two triangles of each edge with three or more. Returns the points that were
/// duplicated.
std::vector<std::uint32_t> detach_surplus(TriangleSoup& soup) {
    std::vector<std::size_t> surplus;
    for (const auto& edge : non_manifold_edges(soup)) {
        surplus.insert(surplus.end(), edge.triangles.begin() + 2, edge.triangles.end());
    }
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

/// A neighbour across an edge of two triangles.
struct Neighbour {
    std::size_t triangle;
    bool agrees;
};

std::vector<std::vector<Neighbour>> neighbours(const TriangleSoup& soup) {
    std::vector<std::vector<Neighbour>> result(soup.triangles.size());
    for_each_edge(soup, [&](std::span<const Side> sides) {
        if (sides.size() != 2) return;
        const bool agrees = sides[0].is_rising != sides[1].is_rising;
        result[sides[0].triangle].push_back({sides[1].triangle, agrees});
        result[sides[1].triangle].push_back({sides[0].triangle, agrees});
    });
    return result;
}

void turn_over(TriangleSoup& soup, std::size_t triangle) {
    std::swap(soup.triangles[triangle][1], soup.triangles[triangle][2]);
    if (!soup.texture.empty()) std::swap(soup.texture[triangle][1], soup.texture[triangle][2]);
}

}  // namespace

std::vector<std::size_t> zero_area_triangles(const TriangleSoup& soup) {
    // Corners are collinear up to round-off if the height is below this share of the longest side.
    constexpr double least_height = 1e-12;
    std::vector<std::size_t> result;
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
        const auto& [a, b, c] = soup.triangles[t];
        const auto u = soup.points[b] - soup.points[a], v = soup.points[c] - soup.points[a], w = v - u;
        const double longest = std::max({u.squared_length(), v.squared_length(), w.squared_length()});
        const double twice_area = std::sqrt(CGAL::cross_product(u, v).squared_length());
        if (!(twice_area > least_height * longest)) result.push_back(t);
    }
    return result;
}

std::vector<std::size_t> repeated_triangles(const TriangleSoup& soup) {
    std::vector<std::pair<std::array<std::uint32_t, 3>, std::size_t>> sorted;
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
        sorted.emplace_back(soup.triangles[t], t);
        std::ranges::sort(sorted.back().first);
    }
    std::ranges::sort(sorted);
    std::vector<std::size_t> result;
    for (std::size_t i = 1; i < sorted.size(); ++i) {
        if (sorted[i].first == sorted[i - 1].first) result.push_back(sorted[i].second);
    }
    std::ranges::sort(result);
    return result;
}

void erase_triangles(TriangleSoup& soup, const std::vector<std::size_t>& ascending) {
    const auto erase = [&](auto& values) {
        if (values.empty()) return;
        std::size_t kept = 0;
        auto next = ascending.begin();
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (next != ascending.end() && *next == i) {
                ++next;
            } else {
                values[kept++] = values[i];
            }
        }
        values.resize(kept);
    };
    erase(soup.triangles);
    erase(soup.texture);
    erase(soup.polygon);
}

std::vector<NonManifoldEdge> non_manifold_edges(const TriangleSoup& soup) {
    std::vector<NonManifoldEdge> result;
    for_each_edge(soup, [&](std::span<const Side> sides) {
        if (sides.size() < 3) return;
        result.push_back({{sides[0].low, sides[0].high}, {}});
        for (const Side& side : sides) result.back().triangles.push_back(side.triangle);
    });
    return result;
}

std::vector<std::uint32_t> separate(TriangleSoup& soup) {
    std::vector<std::uint32_t> doubled;
    while (true) {
        auto now = separate_fans(soup);
        // Triangles that still share such an edge are connected all around both of its ends.
        if (now.empty()) now = detach_surplus(soup);
        if (now.empty()) break;
        doubled.insert(doubled.end(), now.begin(), now.end());
    }
    std::ranges::sort(doubled);
    doubled.erase(std::unique(doubled.begin(), doubled.end()), doubled.end());
    return doubled;
}

Orientation orient(TriangleSoup& soup) {
    const auto adjacent = neighbours(soup);
    Orientation result;
    enum class State : char { unseen, kept, turned };
    std::vector<State> state(soup.triangles.size(), State::unseen);
    for (std::size_t seed = 0; seed < state.size(); ++seed) {
        if (state[seed] != State::unseen) continue;
        state[seed] = State::kept;
        std::vector<std::size_t> component{seed};
        for (std::size_t i = 0; i < component.size(); ++i) {
            for (const auto& [other, agrees] : adjacent[component[i]]) {
                const bool is_turned = (state[component[i]] == State::turned) == agrees;
                const State wanted = is_turned ? State::turned : State::kept;
                if (state[other] == State::unseen) {
                    state[other] = wanted;
                    component.push_back(other);
                } else if (state[other] != wanted && !result.one_sided) {
                    result.one_sided = component[i];
                }
            }
        }
        const auto turned = static_cast<std::size_t>(
            std::ranges::count_if(component, [&](std::size_t t) { return state[t] == State::turned; }));
        const State smaller = 2 * turned > component.size() ? State::kept : State::turned;
        std::ranges::copy_if(component, std::back_inserter(result.turned),
                             [&](std::size_t t) { return state[t] == smaller; });
    }
    std::ranges::sort(result.turned);
    if (result.one_sided) return result;
    for (const std::size_t triangle : result.turned) turn_over(soup, triangle);
    return result;
}

}  // namespace sherd
