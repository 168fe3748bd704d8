// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/assemble/yield_message.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/messages/place_text.h"

namespace sherd {

bool bends_plastically(const Scene& scene, const SheetSpec& sheet) {
    const StepperOptions& stepper = scene.simulation.stepper;
    const bool to_the_end = stepper.scheme == Scheme::implicit_euler || stepper.scheme == Scheme::bdf2 ||
                            stepper.scheme == Scheme::statics;
    return sheet.material.yield > 0 && to_the_end && !scene.simulation.alternates &&
           stepper.shell.bending.model == BendingModel::coupled &&
           !(sheet.fracture && sheet.fracture->has_toughness());
}

std::vector<double> plastic_yields(const Scene& scene) {
    std::vector<double> yields;
    for (const SheetSpec& sheet : scene.sheets)
        yields.push_back(bends_plastically(scene, sheet) ? sheet.material.yield : 0);
    if (std::ranges::all_of(yields, [](double yield) { return yield == 0; })) yields.clear();
    return yields;
}

std::string yield_message(double ratio, const FacePlace& place, const Scene& scene) {
    return fmt::format("{:.3g} times the yield stress, in sheet.{} at {} at rest", ratio,
                       scene.sheets[place.sheet].name, place_text(place.rest));
}

}  // namespace sherd
