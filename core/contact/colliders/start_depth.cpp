// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/colliders/start_depth.h"

#include <algorithm>
#include <utility>

#include "core/contact/detection/near_surface.h"

namespace sherd {
namespace {

/// Returns for each vertex the length, m, of the longest edge at the vertex.
VectorXd longest_edges(const Shell& shell) {
    VectorXd longest = VectorXd::Zero(shell.position.cols());
    for (const TriangleStencil& triangle : shell.triangles)
        for (int i = 0; i < 3; ++i) {
            const Index a = triangle.vertices[i], b = triangle.vertices[(i + 1) % 3];
            const double length = (shell.position.col(a) - shell.position.col(b)).norm();
            longest[a] = std::max(longest[a], length);
            longest[b] = std::max(longest[b], length);
        }
    return longest;
}

/// Overlap, m, of a vertex with a collider at `pose`. margin: m, added to half the sheet's thickness.
double depth(const Shell& shell, const Collider& collider, const Eigen::Isometry3d& pose, Index vertex,
             double margin = 0) {
    return overlap(*collider.shape, pose, shell.position.col(vertex), 0.5 * shell.thickness[vertex] + margin)
        .depth;
}

/// Reduces the exemptions from a rigid collider; returns whether an exemption of elements has ended.
bool shrink(Shell& shell, StartDepth& start, const Collider& collider, const Eigen::Isometry3d& pose) {
    for (Index v = 0; v < static_cast<Index>(start.depth.size()); ++v)
        if (start.depth[v] > 0) start.depth[v] = std::min(start.depth[v], depth(shell, collider, pose, v));
    if (std::ranges::find(start.surface_exempt, char(1)) == start.surface_exempt.end()) return false;
    bool any = false;
    const VectorXd reach = longest_edges(shell);
    for (Index v = 0; v < static_cast<Index>(start.surface_exempt.size()); ++v)
        if (start.surface_exempt[v] && depth(shell, collider, pose, v, reach[v]) <= 0) {
            start.surface_exempt[v] = 0;
            any = true;
        }
    return any;
}

/// Reduces the exemptions from a deforming obstacle, whose surface has no inside and so no exempt depths:
/// elements stay exempt only near the surface. Returns whether an exemption has ended.
bool shrink(Shell& shell, StartDepth& start, const Obstacle& obstacle, double time) {
    VectorXd reach = longest_edges(shell) + 0.5 * shell.thickness;
    for (Index v = 0; v < static_cast<Index>(start.surface_exempt.size()); ++v)
        if (!start.surface_exempt[v]) reach[v] = -1;
    const std::vector<char> before =
        std::exchange(start.surface_exempt, std::vector<char>(start.surface_exempt.size(), 0));
    for (const Index v :
         near_surface(obstacle.points_at(time), obstacle.surface->triangles, shell.position, reach))
        start.surface_exempt[v] = 1;
    return start.surface_exempt != before;
}

bool is_over(const StartDepth& start) {
    return start.depth.maxCoeff() <= 0 &&
           std::ranges::find(start.surface_exempt, char(1)) == start.surface_exempt.end();
}

}  // namespace

void exempt_overlap(Shell& shell, std::size_t colliders, std::size_t collider, Index vertex, double depth,
                    bool surface_exempt) {
    if (shell.start_depths.empty())
        shell.start_depths.assign(
            colliders, {VectorXd::Zero(shell.position.cols()), std::vector<char>(shell.position.cols(), 0)});
    StartDepth& start = shell.start_depths[collider];
    start.depth[vertex] = std::max(start.depth[vertex], depth);
    if (surface_exempt) start.surface_exempt[vertex] = 1;
}

bool shrink_start_depths(Shell& shell, const std::vector<Obstacle>& obstacles,
                         std::span<const RigidBody> bodies, double time) {
    if (shell.start_depths.empty()) return false;
    bool any = false;
    for (std::size_t c = 0; c < shell.start_depths.size(); ++c) {
        const bool is_free = c >= obstacles.size();
        if (!is_free && obstacles[c].deformation != nullptr) {
            any |= shrink(shell, shell.start_depths[c], obstacles[c], time);
            continue;
        }
        const Collider& collider = is_free ? static_cast<const Collider&>(bodies[c - obstacles.size()])
                                           : static_cast<const Collider&>(obstacles[c]);
        const Eigen::Isometry3d pose =
            is_free ? bodies[c - obstacles.size()].pose() : obstacles[c].motion.at(time);
        any |= shrink(shell, shell.start_depths[c], collider, pose);
    }
    if (std::ranges::all_of(shell.start_depths, is_over)) shell.start_depths.clear();
    return any;
}

}  // namespace sherd
