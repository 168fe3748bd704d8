// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/build/supports.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "app/scene/build/selection.h"
#include "core/material/orthotropy.h"
#include "meshops/error.h"
#include "meshops/face_groups.h"
#include "meshops/mesh_measures.h"

namespace sherd {
namespace {

constexpr double on_plane = 1e-6;  // of the mesh's diagonal: single-precision files are no better

std::vector<char> vertices_on(const SymmetrySpec& plane, const SheetInput& input, Index first, Index count) {
    const MeshMeasures extent = measure(input.mesh);
    const double tolerance = on_plane * (extent.upper - extent.lower).norm();
    std::vector<char> selected(count, 0);
    for (const Vertex v : input.mesh.vertices())
        selected[first + static_cast<Index>(v)] =
            std::abs(plane.normal.dot(position(input.mesh, v) - plane.point)) <= tolerance;
    return selected;
}

bool holds_a_triangle(const Shell& mechanics, const std::vector<char>& selected) {
    return std::any_of(mechanics.triangles.begin(), mechanics.triangles.end(), [&](const auto& triangle) {
        return std::all_of(triangle.vertices.begin(), triangle.vertices.end(),
                           [&](Index v) { return selected[v] != 0; });
    });
}

/// Takes the direction `normal` from the freedom of the selected vertices, which keep what all of their
/// supports leave them.
void slide(std::map<Index, Matrix3d>& freedom, const std::vector<char>& selected, const Vector3d& normal) {
    for (Index v = 0; v < static_cast<Index>(selected.size()); ++v) {
        if (!selected[v]) continue;
        Matrix3d& free = freedom.try_emplace(v, Matrix3d::Identity()).first->second;
        const Vector3d lost = free * normal;
        // Zero when an earlier support has taken the same direction.
        if (lost.norm() > on_plane) free -= lost.normalized() * lost.normalized().transpose();
    }
}

/// The middle of the box around what a pin holds.
Vector3d middle(const std::vector<Index>& vertices, const Mesh& placed) {
    Eigen::AlignedBox3d box;
    for (const Index v : vertices) box.extend(position(placed, Vertex(v)));
    return box.center();
}

}  // namespace

std::vector<std::int32_t> pinned_vertices(const SheetSpec& sheet, const Mesh& placed) {
    std::vector<bool> held(placed.number_of_vertices(), false);
    std::vector<PinSpec> holds = sheet.pins;
    holds.insert(holds.end(), sheet.clamps.begin(), sheet.clamps.end());
    for (const PinSpec& hold : holds) {
        const Selection& pin = hold.on;
        check_group(pin, group_names(placed));
        bool any = false;
        for (const Vertex v : placed.vertices())
            if (selects(pin, placed, v)) {
                any = true;
                if (hold.holds_all_directions()) held[v] = true;
            }
        if (!any)
            throw Error(fmt::format(
                "{}: holds no vertex: its box, boundary or group must reach the placed sheet", pin.where));
    }
    std::vector<std::int32_t> numbers;
    for (std::size_t v = 0; v < held.size(); ++v)
        if (held[v]) numbers.push_back(static_cast<std::int32_t>(v));
    return numbers;
}

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

namespace {

/// lambda (N m) of the hinge on a boundary side. first_face: number of the sheet's first face in the
/// mechanics.
double side_stiffness(const SheetInput& input, const Shell& mechanics, const TriangleEdge& side,
                      Index first_face) {
    if (input.axes.empty()) return hinge_stiffness(input.material);
    const TrianglePositions rest = columns(mechanics.rest, edge_and_apex(mechanics, side));
    return hinge_stiffness(input.material, axis_angle(rest, input.axes[side.triangle - first_face]));
}

}  // namespace

void add_supports(const Scene& scene, const std::vector<SheetInput>& inputs, const Shell& mechanics,
                  SimulationOptions& options) {
    std::map<Index, Matrix3d> freedom;
    Index first = 0, first_face = 0;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const auto stiffness = [&](const TriangleEdge& side) {
            return side_stiffness(inputs[i], mechanics, side, first_face);
        };
        for (const PinSpec& clamp : scene.sheets[i].clamps) {
            const std::vector<char> held = selected_vertices(clamp.on, scene.sheets[i].name, scene, inputs);
            const std::vector<TriangleEdge> sides = boundary_triangle_edges(mechanics, held);
            if (sides.empty() && !holds_a_triangle(mechanics, held))
                throw Error(
                    fmt::format("{}: holds no tangent: it must hold both ends of an edge of the "
                                "boundary, or a whole face",
                                clamp.on.where));
            for (const TriangleEdge& side : sides)
                options.stepper.shell.mirrors.push_back(clamp_hinge(mechanics, side, stiffness(side)));
        }
        for (const PinSpec& pin : scene.sheets[i].pins) {
            if (pin.holds_all_directions()) continue;
            const std::vector<char> held = selected_vertices(pin.on, scene.sheets[i].name, scene, inputs);
            for (int axis = 0; axis < 3; ++axis)
                if (!pin.free[axis]) slide(freedom, held, Vector3d::Unit(axis));
        }
        for (const SymmetrySpec& plane : scene.sheets[i].symmetries) {
            const std::vector<char> held =
                vertices_on(plane, inputs[i], first, static_cast<Index>(mechanics.mass.size()));
            const std::vector<TriangleEdge> sides = boundary_triangle_edges(mechanics, held);
            if (sides.empty())
                throw Error(
                    fmt::format("{}: the sheet, as placed, has no boundary edge in this plane", plane.where));
            for (const TriangleEdge& side : sides)
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
