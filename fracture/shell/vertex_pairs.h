// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <vector>

#include "core/state_visitor.h"
#include "meshops/mesh.h"

namespace sherd {

/// Unordered pairs of vertices. Each pair has a reach: two elements, one with each vertex of the pair, repel
/// each other only below this distance.
class VertexPairs {
  public:
    using Partners = std::map<Vertex, double>;  ///< partners of a vertex, with the reach, m; 0: no collision
    struct Pair {
        std::array<Vertex, 2> vertices;  ///< ascending
        double reach;                    ///< m
    };

    bool empty() const { return partners.empty(); }
    bool has(Vertex vertex) const { return partners.contains(vertex); }
    bool has(Vertex a, Vertex b) const {
        const auto found = partners.find(a);
        return found != partners.end() && found->second.contains(b);
    }
    /// The partners of a vertex; they are copied, so that pairs may be added meanwhile.
    Partners of(Vertex vertex) const {
        const auto found = partners.find(vertex);
        return found == partners.end() ? Partners() : found->second;
    }
    /// Adds a pair; if the pair exists, it keeps the smaller reach.
    void add(Vertex a, Vertex b, double reach = 0) {
        for (const auto& [from, to] : {std::array{a, b}, std::array{b, a}}) {
            const auto [at, is_new] = partners[from].emplace(to, reach);
            if (reach < at->second) at->second = reach;
        }
    }
    void erase(Vertex a, Vertex b) {
        for (const auto& [from, to] : {std::array{a, b}, std::array{b, a}}) {
            Partners& left = partners[from];
            left.erase(to);
            if (left.empty()) partners.erase(from);
        }
    }
    /// All pairs, each once, ascending.
    std::vector<Pair> all() const {
        std::vector<Pair> all;
        for (const auto& [vertex, others] : partners)
            for (const auto& [other, reach] : others)
                if (vertex < other) all.push_back({{vertex, other}, reach});
        return all;
    }

    void visit_state(StateVisitor& visit) {
        auto& [partners] = *this;
        visit(partners);
    }

  private:
    std::map<Vertex, Partners> partners;  ///< each pair is stored at both of its vertices
};

}  // namespace sherd
