// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/measures/cracks/crack_graph.h"

#include <map>
#include <set>
#include <utility>

namespace sherd {
namespace {

using Ends = std::array<Index, 2>;

Ends ordered(Index a, Index b) {
    return a < b ? Ends{a, b} : Ends{b, a};
}

/// A face that has an edge at rest, and the current vertices of the face's edge.
struct Side {
    std::size_t face;
    Ends now;
};

/// Returns the sides of each edge at rest, by the edge's vertices at rest in ascending order.
std::map<Ends, std::vector<Side>> sides_of_edges(const Snapshot& frame) {
    std::map<Ends, std::vector<Side>> sides;
    for (std::size_t f = 0; f < frame.faces.size(); ++f)
        for (int i = 0; i < 3; ++i) {
            const int next = (i + 1) % 3;
            sides[ordered(frame.rest.faces[f][i], frame.rest.faces[f][next])].push_back(
                {f, ordered(frame.faces[f][i], frame.faces[f][next])});
        }
    return sides;
}

void add_edges(CrackGraph& cracks, const Snapshot& frame) {
    std::set<Ends> failed;
    for (std::size_t e = 0; e < frame.edges.size(); ++e)
        if (frame.edge_state[e] == EdgeState::fractured_interior)
            failed.insert(ordered(frame.edges[e][0], frame.edges[e][1]));
    for (const auto& [ends, sides] : sides_of_edges(frame)) {
        if (sides.size() == 1) cracks.on_rim[ends[0]] = cracks.on_rim[ends[1]] = 1;
        if (sides.size() < 2) continue;
        if (sides[0].now == sides[1].now && !failed.contains(sides[0].now)) continue;
        const double length = (frame.rest.position.col(ends[0]) - frame.rest.position.col(ends[1])).norm();
        cracks.edges.push_back({ends, {sides[0].face, sides[1].face}, length});
        for (const Index end : ends) ++cracks.degree[end];
    }
}

/// Follows the cracks from node to node.
class BranchWalk {
  public:
    explicit BranchWalk(const CrackGraph& cracks)
        : cracks(cracks), at(cracks.degree.size()), walked(cracks.edges.size(), 0) {
        for (std::size_t e = 0; e < cracks.edges.size(); ++e)
            for (const Index end : cracks.edges[e].vertices) at[end].push_back(e);
    }

    std::vector<CrackBranch> branches() {
        for (std::size_t v = 0; v < at.size(); ++v)
            if (is_node(static_cast<Index>(v))) walk_from(static_cast<Index>(v));
        // Only closed lines without nodes are left.
        for (const CrackedEdge& edge : cracks.edges) walk_from(edge.vertices[0]);
        return std::move(found);
    }

  private:
    bool is_node(Index v) const { return cracks.degree[v] != 2 || cracks.on_rim[v] != 0; }

    void walk_from(Index start) {
        for (const std::size_t first : at[start])
            if (!walked[first]) found.push_back(walk(start, first));
    }

    CrackBranch walk(Index start, std::size_t edge) {
        CrackBranch branch{{start}, {}};
        while (true) {
            const auto& [a, b] = cracks.edges[edge].vertices;
            const Index next = branch.vertices.back() == a ? b : a;
            walked[edge] = 1;
            branch.edges.push_back(edge);
            branch.vertices.push_back(next);
            if (is_node(next) || next == start) return branch;
            edge = at[next][0] == edge ? at[next][1] : at[next][0];
        }
    }

    const CrackGraph& cracks;
    std::vector<std::vector<std::size_t>> at;  ///< cracked edges at each vertex
    std::vector<char> walked;                  ///< whether each edge has been visited
    std::vector<CrackBranch> found;
};

}  // namespace

CrackGraph crack_graph(const Snapshot& frame) {
    const auto vertices = static_cast<std::size_t>(frame.rest.position.cols());
    CrackGraph cracks;
    cracks.on_rim.resize(vertices, 0);
    cracks.degree.resize(vertices, 0);
    add_edges(cracks, frame);
    cracks.branches = BranchWalk(cracks).branches();
    return cracks;
}

std::optional<double> tortuosity(const CrackGraph& cracks, const RestMesh& rest) {
    double length = 0, chords = 0;
    for (const CrackBranch& branch : cracks.branches) {
        if (!branch.has_shape() || branch.is_closed()) continue;
        for (const std::size_t edge : branch.edges) length += cracks.edges[edge].length;
        chords +=
            (rest.position.col(branch.vertices.back()) - rest.position.col(branch.vertices.front())).norm();
    }
    if (chords == 0) return std::nullopt;
    return length / chords;
}

}  // namespace sherd
