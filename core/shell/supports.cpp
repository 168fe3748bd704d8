// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shell/supports.h"

namespace sherd {

void constrain(const Shell& shell, Positions& displacement) {
    for (Index v = 0; v < static_cast<Index>(shell.fixed.size()); ++v)
        displacement.col(v) = constrained(shell, v, displacement.col(v));
}

void place_scripted(const Shell& shell, double time, Positions& x) {
    std::vector<Eigen::Isometry3d> poses;
    for (const Motion& motion : shell.motions) poses.push_back(motion.at(time));
    for (std::size_t v = 0; v < shell.script.size(); ++v)
        if (shell.script[v] != 0) x.col(v) = poses[shell.script[v] - 1] * Vector3d(shell.rest.col(v));
}

Positions scripted_part(const Shell& shell, const Positions& displacement) {
    Positions carried = displacement;
    for (std::size_t v = 0; v < shell.script.size(); ++v)
        if (shell.script[v] == 0) carried.col(v).setZero();
    return carried;
}

void add_reactions(const Shell& shell, const Positions& x, const Positions& forces,
                   std::span<Reaction> of_supports) {
    for (std::size_t v = 0; v < shell.support_set.size(); ++v) {
        if (shell.support_set[v] == 0) continue;
        for (const auto& [support, directions] : shell.support_sets[shell.support_set[v] - 1])
            of_supports[support].add(x.col(v), directions * forces.col(v));
    }
}

}  // namespace sherd
