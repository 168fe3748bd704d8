// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/kept_loads.h"

namespace sherd {

void keep_loads(BreakableShell& sheets, const ShellEnergyOptions& options) {
    const Shell& shell = sheets.mechanics();
    std::vector<Index> kept;
    for (const Load& load : options.loads) {
        for (const CornerForce& dead : load.dead)
            kept.push_back(shell.triangles[dead.triangle].vertices[dead.corner]);
        for (const EdgeMoment& moment : load.moments) {
            const auto [from, to, apex] = edge_and_apex(shell, moment.side);
            kept.insert(kept.end(), {from, to});
        }
        sheets.keep_border(load.pressed);
    }
    for (const Wind& wind : options.winds) sheets.keep_border(wind.triangles);
    sheets.keep_place(kept);
}

}  // namespace sherd
