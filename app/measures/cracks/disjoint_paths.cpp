// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/measures/cracks/disjoint_paths.h"

#include <deque>
#include <map>
#include <optional>
#include <vector>

namespace sherd {
namespace {

/// Flow along edges, each of which can carry one unit in one of its directions.
class Flow {
  public:
    Flow(std::span<const std::array<Index, 2>> edges_, std::span<const PathRole> roles_)
        : edges(edges_), roles(roles_), units(edges_.size(), 0) {
        for (std::size_t e = 0; e < edges.size(); ++e)
            if (has_use(edges[e]))
                for (const Index end : edges[e]) at[end].push_back(e);
    }

    /// Adds a unit of flow from a `begin` to an `end` vertex; returns false if there is no path for it.
    bool augment() {
        std::map<Index, std::optional<std::size_t>> reached;  // edge to each vertex; none at the beginning
        std::deque<Index> next;
        for (const auto& [vertex, incident] : at)
            if (role(vertex) == PathRole::begin) reached[vertex] = std::nullopt, next.push_back(vertex);
        for (; !next.empty(); next.pop_front()) {
            const Index from = next.front();
            if (role(from) == PathRole::end) {
                push_back_from(from, reached);
                return true;
            }
            for (const std::size_t e : at[from])
                if (const Index to = other(e, from); units[e] != way(e, from) && !reached.contains(to))
                    reached[to] = e, next.push_back(to);
        }
        return false;
    }

  private:
    PathRole role(Index vertex) const { return roles[static_cast<std::size_t>(vertex)]; }
    Index other(std::size_t e, Index end) const { return edges[e][0] == end ? edges[e][1] : edges[e][0]; }
    /// Returns the sign in `units` of flow along edge `e` that leaves the vertex `from`.
    int way(std::size_t e, Index from) const { return edges[e][0] == from ? 1 : -1; }

    bool has_use(const std::array<Index, 2>& edge) const {
        const PathRole a = role(edge[0]), b = role(edge[1]);
        return a != PathRole::none && b != PathRole::none && (a != b || a == PathRole::between);
    }

    void push_back_from(Index to, const std::map<Index, std::optional<std::size_t>>& reached) {
        while (const std::optional<std::size_t> e = reached.at(to)) {
            const Index from = other(*e, to);
            units[*e] += way(*e, from);
            to = from;
        }
    }

    std::span<const std::array<Index, 2>> edges;
    std::span<const PathRole> roles;
    std::vector<int> units;  ///< flow of each edge: 1 from first to second vertex, -1 backwards, 0 none
    std::map<Index, std::vector<std::size_t>> at;  ///< usable edges of each vertex
};

}  // namespace

std::size_t disjoint_paths(std::span<const std::array<Index, 2>> edges, std::span<const PathRole> roles) {
    Flow flow(edges, roles);
    std::size_t paths = 0;
    while (flow.augment()) ++paths;
    return paths;
}

}  // namespace sherd
