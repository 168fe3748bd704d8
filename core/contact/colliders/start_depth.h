// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/contact/colliders/obstacle.h"
#include "core/contact/colliders/rigid_body.h"
#include "core/shell/shell.h"

namespace sherd {

/// How deep, m, a vertex may be in a collider before it is pushed, because it was at the start.
inline double start_depth(const Shell& shell, std::size_t collider, Index vertex) {
    return shell.start_depths.empty() ? 0 : shell.start_depths[collider].depth[vertex];
}

/// Overlaps of a vertex with a collider that is there at the start: from now on it is pushed only when it is
/// deeper (m), and with `unseen` elements with it do not meet the collider's surface. colliders: how many
/// obstacles and bodies there are.
void let_overlap(Shell& shell, std::size_t colliders, std::size_t collider, Index vertex, double depth,
                 bool unseen);

/// Lets the depths shrink to those of the shell where it is, and elements meet the surface again where they
/// are so far from the collider that they cannot reach it. time: s, when obstacles are where they are.
/// Returns whether there are elements that meet a surface again.
bool shrink_start_depths(Shell& shell, const std::vector<Obstacle>& obstacles,
                         std::span<const RigidBody> bodies, double time);

}  // namespace sherd
