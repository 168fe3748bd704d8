// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/sheet.h"

#include "app/scene/read/fracture.h"
#include "app/scene/read/material.h"
#include "app/scene/read/mesh_spec.h"
#include "app/scene/read/place.h"
#include "app/scene/read/supports.h"

namespace sherd {
namespace {

constexpr Range feature_degrees{[](double x) { return x > 0 && x <= 180; },
                                "a number above 0, and 180 at most"};

/// Reads `remesh = 0.006` or `remesh = { edge_length = 0.006, ... }` of a mesh from a file.
RemeshOptions read_remesh(TomlTable& mesh) {
    RemeshOptions options;
    if (!mesh.is_table("remesh")) {
        options.edge_length = mesh.number("remesh", "m, target edge length", positive);
        return options;
    }
    TomlTable table = *mesh.table("remesh");
    options.edge_length = table.number("edge_length", "m", positive);
    options.features = table.number("features", "degrees", feature_degrees, options.features);
    options.adaptive = table.flag("adaptive", options.adaptive);
    table.finish();
    return options;
}

GivenMeshName read_given_mesh(TomlTable& table) {
    GivenMeshName mesh{table.string("given", "the name that a program gives the mesh by")};
    if (table.has("remesh")) mesh.remesh = read_remesh(table);
    table.finish();
    return mesh;
}

decltype(SheetSpec::mesh) read_mesh_spec(TomlTable& sheet, const std::filesystem::path& directory) {
    if (sheet.is_string("mesh")) {
        MeshFile mesh;
        mesh.path = directory / sheet.string("mesh", "the name of a mesh file");
        return mesh;
    }
    std::optional<TomlTable> table = sheet.table("mesh");
    if (!table) {
        if (!sheet.has("mesh"))
            sheet.report("mesh", "is missing: give a file name, or { generate = \"disc\", ... }");
        return GeneratedMesh{};
    }
    if (table->has("given")) return read_given_mesh(*table);
    const bool generated = table->has("generate"), from_file = table->has("file");
    if (generated && from_file) table->report("file", "conflicts with generate: give one of them");
    if (!generated && !from_file) table->report("", "needs one of generate and file");
    if (generated == from_file) return GeneratedMesh{};
    if (generated) return read_shape(*table);
    MeshFile mesh = read_mesh_file(*table, directory);
    if (table->has("remesh")) mesh.remesh = read_remesh(*table);
    table->finish();
    return mesh;
}

BendSpec read_bend(TomlTable& table) {
    BendSpec bend;
    bend.where = table.where("");
    bend.curvature = table.number("curvature", "1/m", any_number);
    bend.along = read_direction(table, "along", Vector3d::UnitX());
    bend.from = table.vector("from", "m", Vector3d::Zero());
    table.finish();
    return bend;
}

/// What moves by keys is placed by its shape at rest.
void require_still_supports(TomlTable& table, const SheetSpec& sheet) {
    for (const auto* pins : {&sheet.pins, &sheet.clamps})
        for (const PinSpec& pin : *pins)
            if (sheet.bend && !pin.motion.keys.empty())
                table.report("bend", "conflicts with keys of a pin or clamp: let the sheet start flat");
}

}  // namespace

SheetSpec read_sheet(const std::string& name, TomlTable& table, const std::filesystem::path& directory) {
    SheetSpec sheet;
    sheet.name = name;
    sheet.mesh = read_mesh_spec(table, directory);
    sheet.where = table.where("mesh");
    if (auto place = table.table("place")) sheet.place = read_place(*place);
    if (auto bend = table.table("bend")) sheet.bend = read_bend(*bend);
    sheet.velocity = table.vector("velocity", "m/s", Vector3d::Zero());
    sheet.spin = table.vector("spin", "rad/s", Vector3d::Zero());
    const MaterialPreset* preset = nullptr;
    if (auto material = table.table("material")) {
        sheet.axis = read_axis(*material, directory);
        preset = read_preset(*material);
        sheet.thickness = read_thickness_map(*material, directory);
        sheet.material = read_material(*material, preset, sheet.thickness.has_value());
    } else if (!table.has("material")) {
        table.report("material",
                     "is missing: give { preset = \"stoneware\" }, or density, thickness and young");
    }
    if (auto fracture = table.table("fracture")) sheet.fracture = read_fracture(*fracture, directory, preset);
    if (sheet.material.tempered > 0 && sheet.fracture && !sheet.fracture->has_toughness())
        table.report("fracture",
                     "needs toughness, or fracture_energy, or preset: the sheet is tempered, and "
                     "its residual stress drives cracks");
    read_supports(table, sheet);
    require_still_supports(table, sheet);
    table.finish();
    return sheet;
}

}  // namespace sherd
