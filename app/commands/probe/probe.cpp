// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/probe/probe.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "app/scene/assemble/sheet/material_axes.h"
#include "app/scene/read/sheet/material.h"
#include "app/scene/toml/toml_file.h"
#include "core/bending/coupled_bending.h"
#include "core/bending/cubic_bending.h"
#include "core/bending/nonlinear_bending.h"
#include "core/elements/principal_values.h"
#include "core/membrane/arc_membrane.h"
#include "core/membrane/membrane_energy.h"
#include "fracture/shell/breakable_shell.h"
#include "meshops/error.h"
#include "meshops/read_write/read_mesh.h"
#include "meshops/soup/polygon_soup.h"

namespace sherd {
namespace {

std::string corners_of(const PolygonSoup& soup, std::size_t polygon) {
    if (polygon >= soup.polygons.size()) return "not there";
    return fmt::format("({})", fmt::join(soup.polygons[polygon], ", "));
}

void require_same_faces(const PolygonSoup& rest, const PolygonSoup& deformed) {
    const auto [first, other] = std::mismatch(rest.polygons.begin(), rest.polygons.end(),
                                              deformed.polygons.begin(), deformed.polygons.end());
    if (first == rest.polygons.end() && other == deformed.polygons.end()) return;
    const auto face = static_cast<std::size_t>(first - rest.polygons.begin());
    throw Error(fmt::format(
        "{}: the faces of the two meshes differ: face {} is {} in '{}' and {} in '{}'; give "
        "two shapes with the same faces in the same order",
        face < deformed.polygons.size() ? place_of_polygon(deformed, face) : deformed.file.string(), face,
        corners_of(rest, face), rest.file.string(), corners_of(deformed, face), deformed.file.string()));
}

/// Sums an energy and its forces over its elements. Throws Error (input) if they are not finite.
template <class Elements>
ProbedEnergy sum(const std::string& name, const Elements& elements, const Positions& x) {
    ProbedEnergy total{name, 0, Positions::Zero(3, x.cols())};
    for (std::size_t e = 0; e < elements.size(); ++e) {
        const auto vertices = elements.vertices(e);
        const auto local = columns(x, vertices);
        const double amount = elements.value(e, local);
        const auto slope = elements.gradient(e, local);
        if (!std::isfinite(amount) || !slope.allFinite())
            throw Error(
                fmt::format("{} is not a finite number for the vertices {}: the deformed mesh is "
                            "collapsed or too large there",
                            name, fmt::join(vertices, ", ")));
        total.energy += amount;
        for (std::size_t i = 0; i < vertices.size(); ++i)
            total.force.col(vertices[i]) -= slope.col(static_cast<Eigen::Index>(i));
    }
    return total;
}

/// Evaluates an energy whose elements depend on their neighbours, after sum() has refused degenerate hinges.
ProbedEnergy whole(const std::string& name, const Energy& energy, const Positions& x) {
    ProbedEnergy total{name, energy.value(x), Positions::Zero(3, x.cols())};
    energy.add_gradient(x, total.force);
    total.force = -total.force;
    return total;
}

/// The mechanics of the sheet at rest, its vertices numbered as in the file.
Shell file_sheet(const ProbeShapes& shapes, const MaterialFile& material,
                 std::vector<std::string>& warnings) {
    SheetInput input;
    input.mesh = shapes.rest;
    input.material = material.material;
    if (!is_isotropic(input.material))
        input.axes = material_axes(material.axis, input.mesh, Eigen::Isometry3d::Identity(), warnings);
    Shell sheet = BreakableShell({input}).mechanics();
    const Positions rest = sheet.rest;
    sheet.rest.setZero(3, shapes.deformed.cols());
    sheet.thickness.setConstant(shapes.deformed.cols(), input.material.thickness);
    for (std::size_t v = 0; v < shapes.file_vertex.size(); ++v)
        sheet.rest.col(shapes.file_vertex[v]) = rest.col(static_cast<Eigen::Index>(v));
    for (TriangleStencil& triangle : sheet.triangles)
        for (Index& vertex : triangle.vertices) vertex = shapes.file_vertex[vertex];
    for (HingeStencil& hinge : sheet.hinges) {
        for (Index& vertex : hinge.vertices) vertex = shapes.file_vertex[vertex];
        if (material.bending_stiffness)
            hinge = hinge_stencil(sheet, hinge.vertices, *material.bending_stiffness);
    }
    return sheet;
}

}  // namespace

MaterialFile read_material_file(const std::filesystem::path& file) {
    const toml::table document = parse_toml(read_toml_text(file, "material"), file);
    Problems problems;
    TomlTable table(document, "", problems, file.parent_path());
    MaterialFile result;
    if (table.has("bending_stiffness"))
        result.bending_stiffness = table.number("bending_stiffness", "N m", positive);
    SheetSpec sheet;
    read_section(table, material_section, sheet);
    if (table.is_table("thickness"))
        table.report("thickness", "must be a positive number (m), not a table: it is that of all vertices");
    result.axis = sheet.axis;
    result.material = sheet.material;
    problems.throw_if_any();
    return result;
}

ProbeShapes read_probe_shapes(const std::filesystem::path& rest, const std::filesystem::path& deformed,
                              std::vector<std::string>& warnings) {
    ProbeShapes shapes;
    shapes.rest = read_mesh(rest, {.repair_advice = "", .join_advice = ""}, warnings);
    const PolygonSoup rest_soup = read_polygon_soup(rest), deformed_soup = read_polygon_soup(deformed);
    check_polygon_soup(deformed_soup);
    require_same_faces(rest_soup, deformed_soup);
    const auto number = find_property(shapes.rest, attribute::file_vertex).first;
    shapes.deformed.setZero(3, static_cast<Eigen::Index>(rest_soup.points.size()));
    for (const Vertex vertex : shapes.rest.vertices()) {
        const Point& p = deformed_soup.points[number[vertex]];
        shapes.file_vertex.push_back(static_cast<Index>(number[vertex]));
        shapes.deformed.col(number[vertex]) = Vector3d(p.x(), p.y(), p.z());
    }
    return shapes;
}

Probe probe(const ProbeShapes& shapes, const MaterialFile& material, std::vector<std::string>& warnings) {
    const Shell sheet = file_sheet(shapes, material, warnings);
    const Positions& x = shapes.deformed;
    Probe result;
    result.energies = {sum("bending_nonlinear", NonlinearHinges(sheet.hinges, sheet.rest), x),
                       sum("bending_cubic", CubicHinges(sheet.hinges, sheet.rest), x),
                       sum("bending_cubic_2007", CubicHinges2007(sheet.hinges, sheet.rest), x),
                       sum("membrane", MembraneElements{&sheet.triangles}, x),
                       whole("membrane_arc", ArcMembrane(sheet, {}), x)};
    // Coupled hinges have the rigidity of the material, which a given stiffness of hinges does not define.
    if (!material.bending_stiffness)
        result.energies.push_back(whole("bending_coupled", CoupledBending(sheet, {}), x));
    for (const HingeStencil& hinge : sheet.hinges) {
        const HingePositions local = columns(x, hinge.vertices);
        result.hinges.push_back({hinge.vertices, hinge_angle(local), hinge.rest.angle,
                                 hinge_strain(hinge.rest, local), hinge.stiffness});
    }
    for (const TriangleStencil& triangle : sheet.triangles) {
        const Vector3d strain = green_strain(triangle.membrane, columns(x, triangle.vertices));
        result.faces.push_back({triangle.vertices, principal_strain(strain)});
    }
    result.fields = face_fields(sheet, green_strains(sheet, x), CoupledBending(sheet, {}).curvatures(x),
                                {true, true, true});
    return result;
}

}  // namespace sherd
