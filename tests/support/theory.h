// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <functional>

#include "core/time/implicit_stepper.h"
#include "fracture/breakable_sheet.h"
#include "meshops/generate.h"

namespace sherd::test {

/// Of rigidity 1 N m and 1 kg/m^2, so that results are plate theory's dimensionless numbers.
inline Material unit_plate(double poisson, double thickness) {
    const double rigidity_of_unit_young = std::pow(thickness, 3) / (12 * (1 - poisson * poisson));
    return {1 / thickness, thickness, 1 / rigidity_of_unit_young, poisson};
}

inline BreakableSheet flat_plate(double width, double height, double edge_length, const Material& material) {
    SheetInput input;
    input.mesh = generate_rectangle(width, height, {edge_length, Layout::delaunay, 1});
    input.material = material;
    return BreakableSheet({input});
}

inline std::vector<char> select(const Sheet& sheet, const std::function<bool(const Vector3d&)>& holds) {
    std::vector<char> selected(sheet.mass.size());
    for (Index v = 0; v < static_cast<Index>(selected.size()); ++v) selected[v] = holds(sheet.rest.col(v));
    return selected;
}

/// Clamps the sides whose ends are selected; their ends become fixed.
inline std::vector<MirrorHinge> clamp(Sheet& sheet, const std::vector<char>& selected, double stiffness) {
    std::vector<MirrorHinge> hinges;
    for (std::size_t v = 0; v < selected.size(); ++v)
        if (selected[v]) sheet.fixed[v] = 1;
    for (const TriangleSide& side : boundary_sides(sheet, selected))
        hinges.push_back(clamp_hinge(sheet, side, stiffness));
    return hinges;
}

/// Steps until nothing moves any more; implicit Euler with a step far beyond the slowest period takes the
/// vibration out.
inline void settle(Sheet& sheet, StepperOptions options, int steps) {
    options.tolerance = 1e-9;
    ImplicitStepper time_step(sheet, options);
    for (int i = 0; i < steps; ++i) {
        time_step.begin();
        time_step.position = sheet.position;  // nearer to the end than the inertial prediction
        time_step.solve(500);
        time_step.finish();
    }
}

/// Prints a row of the table in core/bending/README.md.
inline void report(const char* what, const std::vector<double>& percent) {
    std::printf("%-44s", what);
    for (const double error : percent) std::printf(" %6.1f", error);
    std::printf("  %%\n");
}

}  // namespace sherd::test
