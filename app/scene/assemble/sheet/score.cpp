// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/assemble/sheet/score.h"

#include <algorithm>
#include <cstdint>

#include "app/scene/assemble/sheet/edge_list.h"
#include "meshops/attributes.h"
#include "meshops/error.h"
#include "meshops/topology/edge_path.h"

namespace sherd {
namespace {

std::vector<Edge> edges_of(const ScoreFile& score, const Mesh& mesh, const Eigen::Isometry3d&) {
    if (!find_property(mesh, attribute::file_vertex).second)
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

std::vector<Edge> cracked_edges(const Scene& scene, const std::vector<SheetInput>& inputs) {
    std::vector<Edge> all;
    std::size_t first = 0;
    for (std::size_t s = 0; s < inputs.size(); ++s) {
        const SheetSpec& sheet = scene.sheets[s];
        const Mesh& mesh = inputs[s].mesh;
        for (const Score& crack : sheet.fracture ? sheet.fracture->cracks : std::vector<Score>())
            for (const Edge edge : scored_edges(crack, mesh, sheet.place)) {
                if (mesh.is_border(edge))
                    throw Error(crack.where + ": runs along the boundary, where no crack can open");
                all.push_back(Edge(static_cast<Index>(first + edge)));
            }
        first += mesh.number_of_edges();
    }
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

}  // namespace sherd
