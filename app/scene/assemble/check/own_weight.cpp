// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/assemble/check/own_weight.h"

#include <fmt/format.h>

#include "app/scene/assemble/built_scene.h"
#include "app/scene/assemble/check/plausibility.h"
#include "meshops/error.h"

namespace sherd {
namespace {

/// Largest share of the strength that the static stress may take without a warning: a load that acts at once
/// causes twice the strain of a load that grows slowly.
constexpr double borne_at_once = 0.5;
/// Periods of the slowest vibration over which a load must grow to act as in statics.
constexpr double slow = 10;

/// Returns a static scene with this sheet alone, which bears its own weight only.
Scene alone(const Scene& scene, const SheetSpec& sheet) {
    Scene result = scene;
    result.sheets = {sheet};
    for (auto* held : {&result.sheets[0].pins, &result.sheets[0].clamps})
        for (PinSpec& pin : *held) pin.motion = {};
    result.obstacles.clear();
    result.bodies.clear();
    result.loads.clear();
    result.winds.clear();
    result.gauges.clear();
    result.simulation.stepper.scheme = Scheme::statics;
    result.simulation.alternates = result.simulation.stepper.arc_length = false;
    result.simulation.stepper.step = result.simulation.stepper.last_load = result.duration = 1;
    result.simulation.until_crack = true;
    result.simulation.stepper.shell.damping = {};
    return result;
}

/// Returns the share of its strength that the sheet's weight takes in statics: the largest ratio of a hinge's
/// measure to its strength, or, if a hinge fails under a part of the weight, the reciprocal of that part.
/// Returns 0 if statics fail.
double overload(const Scene& scene, const SheetSpec& sheet, SheetInput input) try {
    std::vector<std::string> ignored;
    input.velocity = input.spin = Vector3d::Zero();
    BuiltScene built = build_scene(alone(scene, sheet), {std::move(input)}, ignored);
    Simulation simulation(std::move(built.sheets), built.options);
    double most = 0;
    while (!simulation.arrived() && simulation.time() < 1) most = simulation.step().peak_overload;
    return simulation.arrived() ? 1 / simulation.time() : most;
} catch (const Error&) {
    return 0;
}

}  // namespace

void warn_of_own_weight(const Scene& scene, const std::vector<SheetInput>& inputs,
                        std::vector<std::string>& warnings) {
    if (scene.is_static() || scene.simulation.stepper.gravity.isZero(0)) return;
    for (std::size_t s = 0; s < inputs.size(); ++s) {
        const SheetSpec& sheet = scene.sheets[s];
        if (!sheet.fracture || !sheet.is_supported() || sheet.bend) continue;
        const double share = overload(scene, sheet, inputs[s]);
        if (share <= borne_at_once) continue;
        const Material& material = inputs[s].material;
        const Vector3d weight = material.density * material.thickness * scene.simulation.stepper.gravity;
        warnings.push_back(fmt::format(
            "{}: the weight of sheet.{} alone takes {:.2g} of its strength in statics, and acts at once: the "
            "sheet swings to up to twice that stress and may break before anything hits it; let the weight "
            "grow instead: force.gravity = [0, 0, 0], and [[force.load]] with sheet = \"{}\", area = "
            "[{:.3g}, {:.3g}, {:.3g}], ramp = {:.2g} (what falls in the scene then needs a velocity)",
            sheet.where, sheet.name, share, sheet.name, weight.x(), weight.y(), weight.z(),
            slow * slowest_period(inputs[s])));
    }
}

}  // namespace sherd
