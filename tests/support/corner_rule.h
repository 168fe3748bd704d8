// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace sherd::test {

/// The order-free statement of the opening rule, by union-find over the corners of a triangle list; shares no
/// code with the engine and knows no halfedge. A corner is 3 * face + its place in the face.
class CornerRule {
  public:
    using Triangle = std::array<int, 3>;
    using VertexPair = std::pair<int, int>;

    /// failed: unordered pairs of vertices of `faces`.
    CornerRule(const std::vector<Triangle>& faces, const std::set<VertexPair>& failed) : faces(faces) {
        parent.resize(3 * faces.size());
        std::iota(parent.begin(), parent.end(), 0);
        std::map<VertexPair, std::vector<int>> sides;  // faces of each edge
        for (std::size_t f = 0; f < faces.size(); ++f)
            for (int i = 0; i < 3; ++i)
                sides[ordered(faces[f][i], faces[f][(i + 1) % 3])].push_back(static_cast<int>(f));
        for (const auto& [edge, around] : sides) {
            if (around.size() != 2 || failed.count(edge)) continue;
            for (const int end : {edge.first, edge.second})
                join(corner(around[0], end), corner(around[1], end));
        }
        for (const VertexPair& edge : failed) {
            const std::vector<int>& around = sides.at(edge);
            for (const int end : {edge.first, edge.second})
                if (root(corner(around[0], end)) != root(corner(around[1], end))) open.insert(edge);
        }
    }

    static VertexPair ordered(int a, int b) { return {std::min(a, b), std::max(a, b)}; }
    /// Number that two corners share if and only if they are one vertex.
    int vertex(int face, int place) { return root(3 * face + place); }
    int vertex_count() {
        std::set<int> roots;
        for (std::size_t c = 0; c < parent.size(); ++c) roots.insert(root(static_cast<int>(c)));
        return static_cast<int>(roots.size());
    }
    bool is_open(int a, int b) const { return open.count(ordered(a, b)) > 0; }
    std::size_t open_count() const { return open.size(); }

  private:
    int corner(int face, int vertex) const {
        const Triangle& t = faces[face];
        return 3 * face + static_cast<int>(std::find(t.begin(), t.end(), vertex) - t.begin());
    }
    int root(int c) { return parent[c] == c ? c : parent[c] = root(parent[c]); }
    void join(int a, int b) { parent[root(a)] = root(b); }

    std::vector<Triangle> faces;
    std::vector<int> parent;
    std::set<VertexPair> open;
};

}  // namespace sherd::test
