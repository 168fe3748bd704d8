// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/assemble/sheet/supports.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app/scene/assemble/sheet/selection.h"
#include "core/material/orthotropy.h"
#include "core/shell/thickness.h"
#include "meshops/error.h"
#include "meshops/face_groups.h"
#include "meshops/mesh_measures.h"

namespace sherd {
namespace {

constexpr double on_plane = 1e-6;  // tolerance, as a share of the mesh's diagonal: accuracy of
                                   // single-precision files

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

/// The supports of each vertex, and the directions in which the vertex is still free.
class Holds {
  public:
    explicit Holds(std::size_t vertices) : by(vertices), freedom(vertices, Matrix3d::Identity()) {}

    void add(Index support, const std::vector<char>& selected, const Vector3d& direction) {
        for (std::size_t v = 0; v < selected.size(); ++v) {
            if (!selected[v]) continue;
            const Vector3d lost = freedom[v] * direction;
            if (lost.norm() <= on_plane) continue;  // an earlier support holds the vertex in this direction
            const Matrix3d held = lost.normalized() * lost.normalized().transpose();
            freedom[v] -= held;
            if (by[v].empty() || by[v].back().support != support)
                by[v].push_back({support, Matrix3d::Zero()});
            by[v].back().directions += held;
        }
    }
    void add(const PinSpec& pin, Index support, const std::vector<char>& selected) {
        for (int axis = 0; axis < 3; ++axis)
            if (!pin.free[axis]) add(support, selected, Vector3d::Unit(axis));
    }
    std::vector<SupportedVertex> supported_vertices() const {
        std::vector<SupportedVertex> held;
        for (std::size_t v = 0; v < by.size(); ++v)
            if (!by[v].empty()) held.push_back({static_cast<Index>(v), by[v]});
        return held;
    }

  private:
    std::vector<std::vector<SupportDirections>> by;
    std::vector<Matrix3d> freedom;
};

/// Returns the centre, m, of the bounding box of some vertices.
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

std::size_t partly_pinned_vertices(const SheetSpec& sheet, const Mesh& placed) {
    const std::vector<std::int32_t> pinned = pinned_vertices(sheet, placed);
    std::size_t count = 0;
    for (const Vertex v : placed.vertices())
        count +=
            !std::ranges::binary_search(pinned, static_cast<std::int32_t>(v.idx())) &&
            std::ranges::any_of(sheet.pins, [&](const PinSpec& pin) { return selects(pin.on, placed, v); });
    return count;
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

/// Adds the supports of sheets, in the order of support_names().
class SupportBuilder {
  public:
    SupportBuilder(const Scene& scene, const std::vector<SheetInput>& inputs, const Shell& mechanics,
                   SimulationOptions& options)
        : scene(scene),
          inputs(inputs),
          mechanics(mechanics),
          options(options),
          holds(static_cast<std::size_t>(mechanics.mass.size())) {}

    void add_sheet(std::size_t number) {
        sheet = number;
        const SheetSpec& spec = scene.sheets[sheet];
        for (const PinSpec& pin : spec.pins) holds.add(pin, options.stepper.supports++, selected(pin));
        for (const PinSpec& clamp : spec.clamps) add_clamp(clamp);
        for (const SymmetrySpec& plane : spec.symmetries) add_symmetry(plane);
        first += static_cast<Index>(inputs[sheet].mesh.number_of_vertices());
        first_face += static_cast<Index>(inputs[sheet].mesh.number_of_faces());
    }
    void finish() { options.supported_vertices = holds.supported_vertices(); }

  private:
    std::vector<char> selected(const PinSpec& pin) const {
        return selected_vertices(pin.on, scene.sheets[sheet].name, scene, inputs);
    }

    void add_clamp(const PinSpec& clamp) {
        const std::vector<char> held = selected(clamp);
        const std::vector<TriangleEdge> sides = boundary_triangle_edges(mechanics, held);
        if (sides.empty() && !holds_a_triangle(mechanics, held))
            throw Error(
                fmt::format("{}: holds no tangent: it must hold both ends of an edge of the "
                            "boundary, or a whole face",
                            clamp.on.where));
        for (const TriangleEdge& side : sides) add(clamp_hinge(mechanics, side, stiffness(side)));
        holds.add(clamp, options.stepper.supports++, held);
    }

    void add_symmetry(const SymmetrySpec& plane) {
        const std::vector<char> held =
            vertices_on(plane, inputs[sheet], first, static_cast<Index>(mechanics.mass.size()));
        const std::vector<TriangleEdge> sides = boundary_triangle_edges(mechanics, held);
        if (sides.empty())
            throw Error(
                fmt::format("{}: the sheet, as placed, has no boundary edge in this plane", plane.where));
        for (const TriangleEdge& side : sides)
            add(symmetry_hinge(mechanics, side, plane.normal, stiffness(side)));
        holds.add(options.stepper.supports++, held, plane.normal);
    }

    /// Adds a mirror hinge of the support that is added next.
    void add(const MirrorHinge& hinge) {
        options.stepper.shell.mirrors.push_back(hinge);
        options.stepper.shell.mirror_supports.push_back(options.stepper.supports);
    }

    /// Returns the stiffness lambda (N m) of the mirror hinge on an edge of the boundary.
    double stiffness(const TriangleEdge& side) const {
        const SheetInput& input = inputs[sheet];
        Material material = input.material;
        if (!input.thickness.empty())
            material.thickness = mean_thickness(mechanics, mechanics.triangles[side.triangle].vertices);
        if (input.axes.empty()) return hinge_stiffness(material);
        const TrianglePositions rest = columns(mechanics.rest, edge_and_apex(mechanics, side));
        return hinge_stiffness(material, axis_angle(rest, input.axes[side.triangle - first_face]));
    }

    const Scene& scene;
    const std::vector<SheetInput>& inputs;
    const Shell& mechanics;
    SimulationOptions& options;
    Holds holds;
    std::size_t sheet = 0;
    Index first = 0, first_face = 0;  ///< number of the sheet's first vertex, and of its first face, in the
                                      ///< mechanics
};

}  // namespace

std::vector<SupportName> support_names(const Scene& scene) {
    std::vector<SupportName> names;
    for (const SheetSpec& sheet : scene.sheets)
        for (const auto& [kind, count] :
             {std::pair("pin", sheet.pins.size()), std::pair("clamp", sheet.clamps.size()),
              std::pair("symmetry", sheet.symmetries.size())})
            for (std::size_t i = 0; i < count; ++i) {
                const std::string number = count > 1 ? fmt::format("[{}]", i) : "";
                names.push_back({fmt::format("sheet.{}.{}{}", sheet.name, kind, number), kind});
            }
    for (const ObstacleSpec& obstacle : scene.obstacles)
        names.push_back({"obstacle." + obstacle.name, "obstacle"});
    return names;
}

void add_supports(const Scene& scene, const std::vector<SheetInput>& inputs, const Shell& mechanics,
                  SimulationOptions& options) {
    SupportBuilder builder(scene, inputs, mechanics, options);
    for (std::size_t sheet = 0; sheet < inputs.size(); ++sheet) builder.add_sheet(sheet);
    builder.finish();
}

}  // namespace sherd
