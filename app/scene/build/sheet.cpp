// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/build/sheet.h"

#include <fmt/format.h>

#include <cmath>

#include "app/scene/build/bent_start.h"
#include "app/scene/build/material_axes.h"
#include "app/scene/build/mesh.h"
#include "app/scene/build/strength.h"
#include "app/scene/build/supports.h"
#include "app/scene/build/thickness.h"
#include "meshops/mesh_measures.h"

namespace sherd {
namespace {

/// Warns beyond the paper's limit of validity (section 8).
void warn_of_stretching(const SheetInput& input, const SheetSpec& sheet, std::vector<std::string>& warnings) {
    const Material material = thickest_material(input);
    const double edge = measure(input.mesh).mean_edge, ratio = stretch_over_bend(material, edge);
    if (ratio >= least_stretch_over_bend) return;
    warnings.push_back(
        fmt::format("{}: stretching stiffness Y t is {:.3g} times the hinges' bending stiffness lambda / L^2 "
                    "(edges of L = {:.3g} m, thickness t = {:.3g} m); thin-shell bending needs {:.0f}: where "
                    "the sheet bends, make the edges {:.2g} m or longer",
                    sheet.where, ratio, edge, material.thickness, least_stretch_over_bend,
                    edge * std::sqrt(least_stretch_over_bend / ratio)));
}

/// Whether the sheet's material, strength or toughness depend on the material axis.
bool has_directions(const SheetSpec& sheet) {
    if (!is_isotropic(sheet.material)) return true;
    return sheet.fracture && (sheet.fracture->strength.along != sheet.fracture->strength.across ||
                              sheet.fracture->toughness_across);
}

}  // namespace

SheetInput make_sheet(const SheetSpec& sheet, const Scene& scene, std::vector<std::string>& warnings,
                      std::string* remeshed) {
    SheetInput input;
    input.mesh = make_mesh(sheet, scene, warnings, remeshed);
    if (sheet.bend) input.start = bent_start(*sheet.bend, input.mesh, sheet.place);
    input.pinned = pinned_vertices(sheet, input.mesh);
    input.moving_pins = moving_pins(sheet, input.mesh);
    input.material = sheet.material;
    set_thickness(sheet, input, warnings);
    std::vector<std::string> axis_warnings;
    std::vector<Vector3d> axes = material_axes(sheet.axis, input.mesh, sheet.place, axis_warnings);
    if (has_directions(sheet)) {
        input.axes = std::move(axes);
        warnings.insert(warnings.end(), axis_warnings.begin(), axis_warnings.end());
    }
    warn_of_stretching(input, sheet, warnings);
    if (sheet.fracture) {
        input.strength = sheet_strength(sheet, scene, input.mesh, warnings);
        input.toughness = sheet_toughness(sheet, input.mesh, warnings);
        input.art_direction = sheet.fracture->art_direction;
    }
    input.velocity = sheet.velocity;
    input.spin = sheet.spin;
    return input;
}

}  // namespace sherd
