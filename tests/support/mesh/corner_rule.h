// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>
#include <vector>

namespace sherd::test {

/// Rule by which CrackMesh opens a mesh, as a reference: two corners of faces are at one vertex if faces
/// around this vertex connect them across edges that have not failed. The result does not depend on the order
/// of failures. Found by union-find over the corners of a list of triangles, without halfedges or code in
/// common with CrackMesh. The number of a corner is 3 * face + its place in the face.
class CornerRule {
  public:
    using Triangle = std::array<int, 3>;
    using VertexPair = std::pair<int, int>;

    /// faces: triangles of a manifold mesh, which must outlive this object. failed: the two vertices of each
    /// failed edge, ordered().
    CornerRule(const std::vector<Triangle>& faces, std::vector<VertexPair> failed) : faces(faces) {
        std::sort(failed.begin(), failed.end());
        parent.resize(3 * faces.size());
        std::iota(parent.begin(), parent.end(), 0);
        std::vector<std::pair<VertexPair, int>> sides;  // each face has three
        sides.reserve(parent.size());
        for (int c = 0; c < static_cast<int>(parent.size()); ++c)
            sides.push_back({ordered(faces[c / 3][c % 3], faces[c / 3][(c + 1) % 3]), c / 3});
        std::sort(sides.begin(), sides.end());
        std::vector<std::pair<VertexPair, std::array<int, 2>>> cuts;
        for (std::size_t i = 0; i < sides.size(); ++i) {
            const auto [edge, face] = sides[i];
            if (i + 1 == sides.size() || sides[i + 1].first != edge) {
                border.push_back(edge);
                continue;
            }
            const int other = sides[++i].second;
            if (std::binary_search(failed.begin(), failed.end(), edge))
                cuts.push_back({edge, {face, other}});
            else
                for (const int end : {edge.first, edge.second}) join(corner(face, end), corner(other, end));
        }
        for (const auto& [edge, around] : cuts)
            for (const int end : {edge.first, edge.second})
                if (root(corner(around[0], end)) != root(corner(around[1], end))) open.push_back(edge);
        open.erase(std::unique(open.begin(), open.end()), open.end());
    }

    static VertexPair ordered(int a, int b) { return {std::min(a, b), std::max(a, b)}; }
    /// Returns a number, below 3 * faces, which is equal for two corners if and only if they are at one
    /// vertex of the opened mesh.
    int vertex(int face, int place) { return root(3 * face + place); }
    int vertex_count() const {
        int count = 0;
        for (std::size_t c = 0; c < parent.size(); ++c) count += parent[c] == static_cast<int>(c);
        return count;
    }
    bool is_open(int a, int b) const { return std::binary_search(open.begin(), open.end(), ordered(a, b)); }
    /// Whether the edge has only one face in the unbroken mesh.
    bool is_border(int a, int b) const {
        return std::binary_search(border.begin(), border.end(), ordered(a, b));
    }
    std::size_t open_count() const { return open.size(); }

  private:
    int corner(int face, int vertex) const {
        const Triangle& t = faces[face];
        return 3 * face + static_cast<int>(std::find(t.begin(), t.end(), vertex) - t.begin());
    }
    int root(int c) { return parent[c] == c ? c : parent[c] = root(parent[c]); }
    void join(int a, int b) { parent[root(a)] = root(b); }

    const std::vector<Triangle>& faces;
    std::vector<int> parent;
    std::vector<VertexPair> open, border;  ///< open edges; border edges of the unbroken mesh; ascending
};

}  // namespace sherd::test
