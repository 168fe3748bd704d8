// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/start_faults.h"

#include <fmt/format.h>

#include "app/scene/obstacle_shape.h"
#include "app/scene/place_words.h"
#include "app/scene/scene_start.h"
#include "app/scene/sheet_parting.h"

namespace sherd {

std::string fault_words(const StartFault& fault, const Scene& scene) {
    return fmt::format("face {} of sheet.{} at {}", fault.face, scene.sheets[fault.sheet].name,
                       place_words(fault.at));
}

std::vector<StartFault> start_faults(const Scene& scene, const std::vector<SheetInput>& inputs) {
    std::vector<StartFault> faults = sheet_faults(scene, inputs);
    std::vector<std::string> told;  // by who makes them for the run
    for (const auto* specs : {&scene.obstacles, &scene.bodies}) {
        const std::vector<StartFault> found = obstacle_faults(inputs, make_obstacles(scene, *specs, told));
        faults.insert(faults.end(), found.begin(), found.end());
    }
    return faults;
}

}  // namespace sherd
