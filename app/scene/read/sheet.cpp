// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/sheet.h"

#include "app/scene/read/fracture.h"
#include "app/scene/read/material.h"
#include "app/scene/read/mesh_spec.h"
#include "app/scene/read/place.h"
#include "app/scene/read/supports.h"

namespace sherd {
namespace {

std::variant<GeneratedMesh, MeshFile> read_mesh_spec(TomlTable& sheet,
                                                     const std::filesystem::path& directory) {
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
    const bool generated = table->has("generate"), from_file = table->has("file");
    if (generated && from_file) table->report("file", "conflicts with generate: give one of them");
    if (!generated && !from_file) table->report("", "needs one of generate and file");
    if (generated == from_file) return GeneratedMesh{};
    if (generated) return read_shape(*table);
    MeshFile mesh = read_mesh_file(*table, directory);
    if (table->has("remesh")) mesh.remesh = table->number("remesh", "m, target edge length", positive);
    table->finish();
    return mesh;
}

}  // namespace

SheetSpec read_sheet(const std::string& name, TomlTable& table, const std::filesystem::path& directory) {
    SheetSpec sheet;
    sheet.name = name;
    sheet.mesh = read_mesh_spec(table, directory);
    sheet.where = table.where("mesh");
    if (auto place = table.table("place")) sheet.place = read_place(*place);
    sheet.velocity = table.vector("velocity", "m/s", Vector3d::Zero());
    sheet.spin = table.vector("spin", "rad/s", Vector3d::Zero());
    const MaterialPreset* preset = nullptr;
    if (auto material = table.table("material")) {
        sheet.axis = read_axis(*material, directory);
        preset = read_preset(*material);
        sheet.material = read_material(*material, preset);
    } else if (!table.has("material")) {
        table.report("material",
                     "is missing: give { preset = \"stoneware\" }, or density, thickness and young");
    }
    if (auto fracture = table.table("fracture")) sheet.fracture = read_fracture(*fracture, directory, preset);
    read_supports(table, sheet);
    table.finish();
    return sheet;
}

}  // namespace sherd
