// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/step/load_locks.h"

namespace sherd {

void lock_load_geometry(BreakableShell& sheets, const ShellEnergyOptions& options) {
    const Shell& shell = sheets.mechanics();
    std::vector<Index> kept;
    for (const Load& load : options.loads) {
        for (const CornerForce& dead : load.dead)
            kept.push_back(shell.triangles[dead.triangle].vertices[dead.corner]);
        for (const EdgeMoment& moment : load.moments) {
            const auto [from, to, apex] = edge_and_apex(shell, moment.side);
            kept.insert(kept.end(), {from, to});
        }
        sheets.lock_border(load.pressed);
    }
    for (const Wind& wind : options.winds) sheets.lock_border(wind.triangles);
    sheets.lock_vertices(kept);
}

}  // namespace sherd
