// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/sheet/sheet.h"

#include "app/scene/read/parts/mesh_spec.h"
#include "app/scene/read/parts/place.h"
#include "app/scene/read/sheet/fracture.h"
#include "app/scene/read/sheet/material.h"
#include "app/scene/read/sheet/supports.h"

namespace sherd {
namespace {

void complete_bend(TomlTable& table, BendSpec& bend) {
    bend.where = table.where("");
}

constexpr std::array bend_keys{
    key<&BendSpec::curvature>(
        "curvature", "curvature of the arcs that lines along `along` become, positive towards the normals",
        {.unit = "1/m", .required = true}),
    direction_key<&BendSpec::along>("along", "direction in the mesh along which the sheet is bent"),
    key<&BendSpec::from>("from", "a point of the line across `along` that stays where it is placed",
                         {.unit = "m"})};
constexpr Section<BendSpec> bend_section{"Initial bending of a flat sheet", bend_keys, complete_bend};

/// Reports moving pins and clamps of a sheet with `bend`, since their motion begins at the rest shape.
void require_still_supports(TomlTable& table, const SheetSpec& sheet) {
    for (const auto* pins : {&sheet.pins, &sheet.clamps})
        for (const PinSpec& pin : *pins)
            if (sheet.bend && !pin.motion.keys.empty())
                table.report("bend", "conflicts with keys of a pin or clamp: let the sheet start flat");
}

void complete_sheet(TomlTable& table, SheetSpec& sheet) {
    if (!table.has("material"))
        table.report("material",
                     "is missing: give { preset = \"stoneware\" }, or density, thickness and young");
    if (sheet.material.tempered > 0 && sheet.fracture && !sheet.fracture->has_toughness())
        table.report("fracture",
                     "needs toughness, or fracture_energy, or preset: the sheet is tempered, and "
                     "its residual stress drives cracks");
    require_still_supports(table, sheet);
}

constexpr std::array sheet_keys{
    special_key("mesh", Form::file | Form::table, "a file name, or a table",
                {.what = "the name of a mesh file", .required = true}, read_mesh, inside_mesh),
    table_key<place_section, &SheetSpec::place>("place", "rotation and translation of the sheet",
                                                {.otherwise = "none"}),
    table_key<bend_section, &SheetSpec::bend>("bend", "initial bending: the sheet starts rolled up",
                                              {.otherwise = "none"}),
    key<&SheetSpec::velocity>("velocity", "velocity at the start", {.unit = "m/s"}),
    key<&SheetSpec::spin>("spin", "angular velocity at the start, about the centre of mass",
                          {.unit = "rad/s"}),
    part_key<material_section>("material", "material and thickness", {.required = true}),
    special_key("fracture", Form::table, "when and how the sheet breaks", {.otherwise = "unbreakable"},
                read_fracture, inside_fracture),
    table_key<pin_section, &SheetSpec::pins>(
        "pin", "vertices that stay where they are placed, or move by `keys`", {.otherwise = "none"}),
    table_key<clamp_section, &SheetSpec::clamps>("clamp", "as `pin`, but holds the sheet's tangent, too",
                                                 {.otherwise = "none"}),
    table_key<symmetry_section, &SheetSpec::symmetries>(
        "symmetry", "symmetry planes, behind which the sheet continues as its mirror image",
        {.otherwise = "none"})};

}  // namespace

constinit const Section<SheetSpec> sheet_section{"A sheet, which bends and breaks", sheet_keys,
                                                 complete_sheet};

}  // namespace sherd
