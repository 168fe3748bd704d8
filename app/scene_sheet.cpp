// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene_sheet.h"

#include <numbers>

#include "app/scene_material.h"
#include "app/scene_shape.h"

namespace sherd {
namespace {

MeshFile read_mesh_file(TomlTable& table, const std::filesystem::path& directory) {
    MeshFile mesh;
    const std::string name = table.string("file", "the name of a mesh file");
    mesh.path = directory / name;
    mesh.repair = table.flag("repair", false);
    mesh.join = table.flag("join", false);
    mesh.scale = table.number("scale", "m per unit of the file", positive, 1);
    if (table.has("remesh")) mesh.remesh = table.number("remesh", "m, target edge length", positive);
    table.finish();
    return mesh;
}

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
    return read_mesh_file(*table, directory);
}

Eigen::Isometry3d read_place(TomlTable& table) {
    Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
    for (TomlTable& rotation : table.tables("rotate")) {
        const Vector3d axis = rotation.vector("axis", "");
        const double degrees = rotation.number("degrees", "degrees", any_number);
        if (axis.isZero(0)) rotation.report("axis", "must not be zero: give a direction, such as [1, 0, 0]");
        // stableNormalized, since the squares of tiny or huge components leave the range of double.
        const Eigen::AngleAxisd turn(degrees * std::numbers::pi / 180, axis.stableNormalized());
        place.prerotate(turn.toRotationMatrix());
        rotation.finish();
    }
    place.pretranslate(table.vector("translate", "m", Vector3d::Zero()));
    table.finish();
    return place;
}

Selection read_selection(TomlTable& table) {
    Selection selection;
    selection.where = table.where("");
    selection.boundary = table.flag("boundary", false);
    if (table.has("box")) {
        const std::vector<Eigen::VectorXd> corners = table.rows("box", "m", 2, 3);
        if (corners.size() == 2)
            selection.box.emplace(corners[0], corners[1]);
        else if (!corners.empty())
            table.report("box", "must be [lower corner, upper corner], two arrays of 3 numbers");
        if (selection.box && (selection.box->first.array() > selection.box->second.array()).any())
            table.report("box", "has a lower corner above its upper one: order them in x, y and z");
        if (selection.boundary) table.report("boundary", "conflicts with box: write a pin for each");
    } else if (!selection.boundary) {
        table.report("", "holds nothing: give box = [[...], [...]] or boundary = true");
    }
    table.finish();
    return selection;
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
    if (auto material = table.table("material")) {
        sheet.axis = read_axis(*material, directory);
        sheet.material = read_material(*material);
    } else if (!table.has("material")) {
        table.report("material",
                     "is missing: give { preset = \"stoneware\" }, or density, thickness and young");
    }
    if (auto fracture = table.table("fracture")) {
        sheet.strain_threshold = fracture->number("strain", "1/m", positive);
        fracture->finish();
    }
    for (TomlTable& pin : table.tables("pin")) sheet.pins.push_back(read_selection(pin));
    table.finish();
    return sheet;
}

}  // namespace sherd
