// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/assemble/start/start_faults.h"

#include "app/scene/assemble/obstacle/obstacles.h"
#include "app/scene/assemble/start/obstacle_start.h"
#include "app/scene/assemble/start/sheet_separation.h"

namespace sherd {

std::vector<StartFault> start_faults(const Scene& scene, const std::vector<SheetInput>& inputs,
                                     const BreakableShell& all) {
    std::vector<StartFault> faults = sheet_faults(scene, inputs, all);
    std::vector<std::string> told;  // not printed: build_scene() returns the same warnings
    for (const auto* specs : {&scene.obstacles, &scene.bodies}) {
        const std::vector<StartFault> found =
            obstacle_faults(inputs, all, make_obstacles(*specs, thickness_range(inputs), told));
        faults.insert(faults.end(), found.begin(), found.end());
    }
    return faults;
}

}  // namespace sherd
