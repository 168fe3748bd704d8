// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/topology/edge_path.h"

#include <algorithm>
#include <functional>
#include <map>
#include <queue>
#include <string>

#include "meshops/error.h"
#include "meshops/mesh_measures.h"

namespace sherd {
namespace {

using Eigen::Vector3d;

double edge_length(const Mesh& mesh, Edge edge) {
    return (position(mesh, mesh.vertex(edge, 1)) - position(mesh, mesh.vertex(edge, 0))).norm();
}

double longest_edge(const Mesh& mesh, Vertex v) {
    double longest = 0;
    for (const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(v)))
        longest = std::max(longest, edge_length(mesh, mesh.edge(h)));
    return longest;
}

Vertex nearest_vertex(const Mesh& mesh, const Vector3d& point, std::size_t number) {
    const auto distance = [&](Vertex v) { return (position(mesh, v) - point).norm(); };
    const auto nearer = [&](Vertex a, Vertex b) { return distance(a) < distance(b); };
    const Vertex nearest = *std::min_element(mesh.vertices().begin(), mesh.vertices().end(), nearer);
    if (!(distance(nearest) <= 2 * longest_edge(mesh, nearest)))
        throw Error("point " + std::to_string(number) +
                    " of the line (counted from 0) is off the sheet: its nearest vertex, " +
                    std::to_string(nearest.idx()) + ", is more than two edge lengths away");
    return nearest;
}

double distance_to_segment(const Vector3d& point, const Vector3d& start, const Vector3d& end) {
    const Vector3d along = end - start;
    const double squared = along.squaredNorm();
    const double t = squared > 0 ? std::clamp((point - start).dot(along) / squared, 0.0, 1.0) : 0;
    return (point - start - t * along).norm();
}

/// Returns the halfedges of the cheapest path from `start` to `goal`, the last one first; none if there is no
/// path. cost(edge) must be positive.
template <class Cost>
std::vector<Halfedge> cheapest_path_back(const Mesh& mesh, Vertex start, Vertex goal, const Cost& cost) {
    struct Arrival {
        double cost;
        Halfedge by;
    };
    using Candidate = std::pair<double, Vertex>;
    std::map<Vertex, Arrival> arrivals{{start, {0, Mesh::null_halfedge()}}};
    std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> queue;
    for (queue.emplace(0, start); !queue.empty() && queue.top().second != goal;) {
        const Candidate here = queue.top();
        queue.pop();
        if (here.first > arrivals.at(here.second).cost) continue;
        for (const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(here.second))) {
            const Halfedge onward = mesh.opposite(h);
            const double sum = here.first + cost(mesh.edge(h));
            const auto [known, is_new] = arrivals.try_emplace(mesh.target(onward), Arrival{sum, onward});
            if (!is_new && sum >= known->second.cost) continue;
            known->second = {sum, onward};
            queue.emplace(sum, mesh.target(onward));
        }
    }
    std::vector<Halfedge> way;
    for (Vertex v = goal; v != start && arrivals.contains(v); v = mesh.source(way.back()))
        way.push_back(arrivals.at(v).by);
    return way;
}

}  // namespace

std::vector<Edge> edge_path(const Mesh& mesh, std::span<const Vector3d> line) {
    const double mean = measure(mesh).mean_edge;
    std::vector<Vertex> stops;
    for (const Vector3d& point : line) stops.push_back(nearest_vertex(mesh, point, stops.size()));
    std::vector<Edge> path;
    std::vector<bool> taken(mesh.number_of_edges(), false);
    for (std::size_t i = 1; i < stops.size(); ++i) {
        const auto cost = [&](Edge e) {
            const Vector3d middle =
                (position(mesh, mesh.vertex(e, 0)) + position(mesh, mesh.vertex(e, 1))) / 2;
            return edge_length(mesh, e) * (mean + distance_to_segment(middle, line[i - 1], line[i]));
        };
        const std::vector<Halfedge> way = cheapest_path_back(mesh, stops[i - 1], stops[i], cost);
        if (way.empty() && stops[i - 1] != stops[i])
            throw Error("points " + std::to_string(i - 1) + " and " + std::to_string(i) +
                        " of the line (counted from 0) lie on parts of the mesh that are not connected");
        for (auto h = way.rbegin(); h != way.rend(); ++h)
            if (!taken[mesh.edge(*h)]) {
                taken[mesh.edge(*h)] = true;
                path.push_back(mesh.edge(*h));
            }
    }
    if (path.empty())
        throw Error("the line is shorter than an edge and touches one vertex only: make it longer");
    return path;
}

}  // namespace sherd
