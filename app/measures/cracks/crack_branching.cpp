// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/measures/cracks/crack_branching.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "app/measures/cracks/crack_directions.h"

namespace sherd {
namespace {

/// Branches of cracks that end at a vertex.
struct Arms {
    std::vector<Vector3d> chords;  ///< m, from the vertex to a point of each branch
    bool are_clear = true;         ///< whether all of the branches have a shape
};

/// Returns the branches that end at each junction of `cracks`, by the vertex of the junction.
std::map<Index, Arms> arms_of(const CrackGraph& cracks, const RestMesh& rest) {
    std::map<Index, Arms> arms;
    constexpr std::size_t most = 3;  // largest number of edges that a chord spans
    for (const CrackBranch& branch : cracks.branches) {
        const auto& [vertices, edges] = branch;
        const std::size_t reach = std::min(edges.size(), most), last = edges.size();
        for (const auto& [end, at] :
             {std::pair{vertices[0], vertices[reach]}, std::pair{vertices[last], vertices[last - reach]}}) {
            if (cracks.on_rim[end] != 0 || cracks.degree[end] < 3) continue;
            arms[end].chords.emplace_back(rest.position.col(at) - rest.position.col(end));
            if (!branch.has_shape()) arms[end].are_clear = false;
        }
    }
    return arms;
}

/// Returns for each vertex the sum of the normals of its faces, each times twice the face's area.
Positions vertex_normals(const RestMesh& rest) {
    Positions normals = Positions::Zero(3, rest.position.cols());
    for (const std::array<Index, 3>& face : rest.faces) {
        const Vector3d a = rest.position.col(face[0]), b = rest.position.col(face[1]),
                       c = rest.position.col(face[2]);
        for (const Index corner : face) normals.col(corner) += (b - a).cross(c - a);
    }
    return normals;
}

std::vector<double> angles_between(std::span<const Vector3d> chords, const Vector3d& normal) {
    const Vector3d first = in_plane_axis(normal), second = normal.cross(first);
    std::vector<double> around;
    for (const Vector3d& chord : chords)
        around.push_back(std::atan2(chord.dot(second), chord.dot(first)) * 180 / std::numbers::pi);
    std::ranges::sort(around);
    std::vector<double> angles;
    for (std::size_t i = 0; i + 1 < around.size(); ++i) angles.push_back(around[i + 1] - around[i]);
    angles.push_back(360 - (around.back() - around.front()));
    return angles;
}

}  // namespace

double CrackJunction::smallest_angle() const {
    return *std::ranges::min_element(angles);
}

std::vector<CrackJunction> crack_junctions(const CrackGraph& cracks, const RestMesh& rest) {
    const Positions normals = vertex_normals(rest);
    std::vector<CrackJunction> junctions;
    for (const auto& [vertex, arms] : arms_of(cracks, rest)) {
        junctions.push_back({rest.position.col(vertex), arms.chords.size()});
        if (arms.are_clear)
            junctions.back().angles = angles_between(arms.chords, normals.col(vertex).normalized());
    }
    return junctions;
}

std::optional<double> branching_angle(std::span<const CrackJunction> junctions) {
    double sum = 0;
    std::size_t clear = 0;
    for (const CrackJunction& junction : junctions) {
        if (junction.angles.empty()) continue;
        sum += junction.smallest_angle();
        ++clear;
    }
    if (clear == 0) return std::nullopt;
    return sum / static_cast<double>(clear);
}

}  // namespace sherd
