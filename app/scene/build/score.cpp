// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/build/score.h"

#include <cstdint>

#include "app/scene/build/edge_list.h"
#include "meshops/edge_path.h"
#include "meshops/error.h"

namespace sherd {
namespace {

std::vector<Edge> edges_of(const ScoreFile& score, const Mesh& mesh, const Eigen::Isometry3d&) {
    if (!mesh.property_map<Vertex, std::uint32_t>(property::file_vertex).second)
        throw Error("a list of edges needs a mesh from a file, without remesh: give a line instead");
    return read_edge_list(score.path, mesh);
}

std::vector<Edge> edges_of(const ScoreLine& score, const Mesh& mesh, const Eigen::Isometry3d& place) {
    std::vector<Eigen::Vector3d> placed;
    for (const Eigen::Vector3d& point : score.points) placed.push_back(place * point);
    return edge_path(mesh, placed);
}

}  // namespace

std::vector<Edge> scored_edges(const Score& score, const Mesh& placed, const Eigen::Isometry3d& place) {
    return with_context(score.where, [&] {
        return std::visit([&](const auto& kind) { return edges_of(kind, placed, place); }, score.kind);
    });
}

}  // namespace sherd
