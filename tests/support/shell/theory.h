// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <functional>

#include "core/time/implicit_stepper.h"
#include "fracture/shell/breakable_shell.h"
#include "meshops/generate/generate.h"

namespace sherd::test {

/// Material with a bending rigidity of 1 N m and 1 kg/m^2, so that results are plate theory's dimensionless
/// numbers.
inline Material unit_plate(double poisson, double thickness) {
    const double rigidity_of_unit_young = std::pow(thickness, 3) / (12 * (1 - poisson * poisson));
    return {1 / thickness, thickness, 1 / rigidity_of_unit_young, poisson};
}

inline BreakableShell flat_plate(double width, double height, double edge_length, const Material& material) {
    SheetInput input;
    input.mesh = generate_rectangle(width, height, {edge_length, Layout::delaunay, 1});
    input.material = material;
    return BreakableShell({input});
}

inline std::vector<char> select(const Shell& shell, const std::function<bool(const Vector3d&)>& holds) {
    std::vector<char> selected(shell.mass.size());
    for (Index v = 0; v < static_cast<Index>(selected.size()); ++v) selected[v] = holds(shell.rest.col(v));
    return selected;
}

/// Clamps the boundary edges whose two ends are selected: fixes these vertices, and returns the hinges that
/// hold the slope.
inline std::vector<MirrorHinge> clamp(Shell& shell, const std::vector<char>& selected, double stiffness) {
    std::vector<MirrorHinge> hinges;
    for (std::size_t v = 0; v < selected.size(); ++v)
        if (selected[v]) shell.fixed[v] = 1;
    for (const TriangleEdge& side : boundary_triangle_edges(shell, selected))
        hinges.push_back(clamp_hinge(shell, side, stiffness));
    return hinges;
}

/// Makes `steps` steps of implicit Euler, which damp vibrations, so that the sheet comes to rest. Their
/// length, in `options`, must be far beyond the slowest period.
inline void settle(Shell& shell, StepperOptions options, int steps) {
    options.tolerance = 1e-9;
    ImplicitStepper time_step(shell, options);
    for (int i = 0; i < steps; ++i) {
        time_step.begin();
        time_step.position = shell.position;  // nearer to the solution than the inertial prediction
        time_step.solve(500);
        time_step.finish();
    }
}

/// Prints a row of the table in docs/theory/bending.md. percent: errors, %.
inline void report(const char* what, const std::vector<double>& percent) {
    std::printf("%-44s", what);
    for (const double error : percent) std::printf(" %6.1f", error);
    std::printf("  %%\n");
}

}  // namespace sherd::test
