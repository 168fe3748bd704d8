// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/scene_support.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "app/scene/scene_mesh.h"
#include "app/scene/scene_place.h"
#include "core/material/orthotropy.h"
#include "meshops/error.h"
#include "meshops/face_groups.h"
#include "meshops/mesh_measures.h"

namespace sherd {
namespace {

constexpr double at_rest = 1e-12;  // of the first key's rotation and way, m
constexpr double on_plane = 1e-6;  // of the mesh's diagonal: single-precision files are no better

void read_box(TomlTable& table, Selection& selection) {
    const std::vector<Eigen::VectorXd> corners = table.rows("box", "m", 2, 3);
    if (corners.size() == 2)
        selection.box.emplace(corners[0], corners[1]);
    else if (!corners.empty())
        table.report("box", "must be [lower corner, upper corner], two arrays of 3 numbers");
    if (selection.box && (selection.box->first.array() > selection.box->second.array()).any())
        table.report("box", "has a lower corner above its upper one: order them in x, y and z");
}

PinSpec read_pin(TomlTable& table) {
    PinSpec pin;
    pin.on = read_selection(table);
    read_motion(table, pin.motion);
    if (table.has("centre")) pin.centre = table.vector("centre", "m");
    if (pin.centre && pin.motion.keys.empty())
        table.report("centre", "needs keys = [{ time = 0 }, { time = 1, ... }]");
    if (!pin.motion.at(0).matrix().isIdentity(at_rest))
        table.report("keys", "must begin where the sheet is placed: without translate and rotate at first");
    table.finish();
    return pin;
}

SymmetrySpec read_symmetry(TomlTable& table) {
    SymmetrySpec plane;
    plane.where = table.where("");
    plane.point = table.vector("point", "m", Vector3d::Zero());
    plane.normal = read_direction(table, "normal");
    table.finish();
    return plane;
}

std::vector<char> vertices_on(const SymmetrySpec& plane, const SheetInput& input, Index first, Index count) {
    const MeshMeasures extent = measure(input.mesh);
    const double tolerance = on_plane * (extent.upper - extent.lower).norm();
    std::vector<char> selected(count, 0);
    for (const Vertex v : input.mesh.vertices())
        selected[first + static_cast<Index>(v)] =
            std::abs(plane.normal.dot(position(input.mesh, v) - plane.point)) <= tolerance;
    return selected;
}

bool holds_a_triangle(const Sheet& mechanics, const std::vector<char>& selected) {
    return std::any_of(mechanics.triangles.begin(), mechanics.triangles.end(), [&](const auto& triangle) {
        return std::all_of(triangle.vertices.begin(), triangle.vertices.end(),
                           [&](Index v) { return selected[v] != 0; });
    });
}

/// Leaves a vertex the directions of its planes' intersection.
void slide(std::map<Index, Matrix3d>& freedom, const std::vector<char>& selected, const Vector3d& normal) {
    for (Index v = 0; v < static_cast<Index>(selected.size()); ++v) {
        if (!selected[v]) continue;
        Matrix3d& free = freedom.try_emplace(v, Matrix3d::Identity()).first->second;
        const Vector3d lost = free * normal;
        // Zero when an earlier plane has the same normal.
        if (lost.norm() > on_plane) free -= lost.normalized() * lost.normalized().transpose();
    }
}

}  // namespace

Selection read_selection(TomlTable& table) {
    Selection selection;
    selection.where = table.where(table.has("group") ? "group" : "");
    selection.boundary = table.flag("boundary", false);
    if (table.has("box")) read_box(table, selection);
    if (table.has("group")) {
        selection.group = table.string("group", "the name of a group of the mesh file");
    }
    std::string given;
    for (const auto& [key, is_given] :
         {std::pair("box", table.has("box")), std::pair("group", table.has("group")),
          std::pair("boundary", selection.boundary)}) {
        if (!is_given) continue;
        if (!given.empty())
            table.report(key, fmt::format("conflicts with {}: write a table for each", given));
        given = key;
    }
    if (given.empty())
        table.report("", "holds nothing: give box = [[...], [...]], boundary = true or group = \"NAME\"");
    return selection;
}

void read_supports(TomlTable& table, SheetSpec& sheet) {
    for (const auto& [key, pins] : {std::pair("pin", &sheet.pins), std::pair("clamp", &sheet.clamps)})
        for (TomlTable& entry : table.tables(key)) pins->push_back(read_pin(entry));
    for (TomlTable& plane : table.tables("symmetry")) sheet.symmetries.push_back(read_symmetry(plane));
}

namespace {

/// The middle of the box around what a pin holds.
Vector3d middle(const std::vector<Index>& vertices, const Mesh& placed) {
    Eigen::AlignedBox3d box;
    for (const Index v : vertices) box.extend(position(placed, Vertex(v)));
    return box.center();
}

}  // namespace

std::vector<MovingPin> moving_pins(const SheetSpec& sheet, const Mesh& placed) {
    std::vector<PinSpec> pins = sheet.pins;
    pins.insert(pins.end(), sheet.clamps.begin(), sheet.clamps.end());
    std::vector<MovingPin> moving;
    std::vector<const PinSpec*> holder(placed.number_of_vertices());
    for (const PinSpec& pin : pins) {
        MovingPin held{{}, pin.motion};
        for (const Vertex v : placed.vertices()) {
            if (!selects(pin.on, placed, v)) continue;
            const PinSpec* const other = std::exchange(holder[v], &pin);
            if (other && !(pin.motion.keys.empty() && other->motion.keys.empty()))
                throw Error(
                    fmt::format("{}: holds a vertex that {} holds too, and one of them moves: give "
                                "each its own vertices",
                                pin.on.where, other->on.where));
            held.vertices.push_back(static_cast<Index>(v));
        }
        held.motion.pivot = pin.centre.value_or(middle(held.vertices, placed));
        if (!pin.motion.keys.empty()) moving.push_back(held);
    }
    return moving;
}

std::vector<char> selected_vertices(const Selection& selection, const std::string& sheet, const Scene& scene,
                                    const std::vector<SheetInput>& inputs) {
    std::vector<char> selected;
    std::vector<std::string> known;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        if (!sheet.empty() && scene.sheets[i].name != sheet) continue;
        const std::vector<std::string> names = group_names(inputs[i].mesh);
        known.insert(known.end(), names.begin(), names.end());
    }
    check_group(selection, known);
    for (std::size_t i = 0; i < inputs.size(); ++i)
        for (const Vertex v : inputs[i].mesh.vertices())
            selected.push_back((sheet.empty() || scene.sheets[i].name == sheet) &&
                               selects(selection, inputs[i].mesh, v));
    return selected;
}

namespace {

/// lambda (N m) of the hinge on a boundary side. first_face: number of the sheet's first face in the
/// mechanics.
double side_stiffness(const SheetInput& input, const Sheet& mechanics, const TriangleSide& side,
                      Index first_face) {
    if (input.axes.empty()) return hinge_stiffness(input.material);
    const TrianglePositions rest = columns(mechanics.rest, side_vertices(mechanics, side));
    return hinge_stiffness(input.material, axis_angle(rest, input.axes[side.triangle - first_face]));
}

}  // namespace

void add_supports(const Scene& scene, const std::vector<SheetInput>& inputs, const Sheet& mechanics,
                  SimulationOptions& options) {
    std::map<Index, Matrix3d> freedom;
    Index first = 0, first_face = 0;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const auto stiffness = [&](const TriangleSide& side) {
            return side_stiffness(inputs[i], mechanics, side, first_face);
        };
        for (const PinSpec& clamp : scene.sheets[i].clamps) {
            const std::vector<char> held = selected_vertices(clamp.on, scene.sheets[i].name, scene, inputs);
            const std::vector<TriangleSide> sides = boundary_sides(mechanics, held);
            if (sides.empty() && !holds_a_triangle(mechanics, held))
                throw Error(
                    fmt::format("{}: holds no tangent: it must hold both ends of an edge of the "
                                "boundary, or a whole face",
                                clamp.on.where));
            for (const TriangleSide& side : sides)
                options.stepper.shell.mirrors.push_back(clamp_hinge(mechanics, side, stiffness(side)));
        }
        for (const SymmetrySpec& plane : scene.sheets[i].symmetries) {
            const std::vector<char> held =
                vertices_on(plane, inputs[i], first, static_cast<Index>(mechanics.mass.size()));
            const std::vector<TriangleSide> sides = boundary_sides(mechanics, held);
            if (sides.empty())
                throw Error(
                    fmt::format("{}: the sheet, as placed, has no boundary edge in this plane", plane.where));
            for (const TriangleSide& side : sides)
                options.stepper.shell.mirrors.push_back(
                    symmetry_hinge(mechanics, side, plane.normal, stiffness(side)));
            slide(freedom, held, plane.normal);
        }
        first += static_cast<Index>(inputs[i].mesh.number_of_vertices());
        first_face += static_cast<Index>(inputs[i].mesh.number_of_faces());
    }
    for (const auto& [vertex, free] : freedom) options.sliding.push_back({vertex, free});
}

}  // namespace sherd
