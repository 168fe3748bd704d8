// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/assemble/sheet/thickness.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/messages/place_text.h"
#include "app/scene/assemble/sheet/map_values.h"
#include "meshops/error.h"
#include "meshops/mesh_measures.h"

namespace sherd {
namespace {

double thickness_of(const ThicknessMap& map, double value) {
    return map.range ? std::lerp((*map.range)[0], (*map.range)[1], std::min(value, 1.0)) : map.scale * value;
}

std::vector<double> mapped_thickness(const ThicknessMap& map, const SheetSpec& sheet, const Mesh& placed,
                                     std::vector<std::string>& warnings) {
    std::vector<double> thickness = vertex_values(map.source, sheet, placed, warnings);
    for (const Vertex v : placed.vertices()) {
        double& at = thickness[v];
        const double value = at;
        at = thickness_of(map, value);
        if (!(at > 0 && std::isfinite(at)))
            throw Error(fmt::format(
                "{} is {:.4g} at vertex {}, at {}, which makes the sheet {:.4g} m thick: it needs "
                "a thickness above 0",
                source_text(map.source), value, v.idx(), place_text(position(placed, v)), at));
    }
    return thickness;
}

/// Returns the mean thickness, m, weighted by area.
double mean_by_area(const Mesh& mesh, const std::vector<double>& thickness) {
    const double first = thickness.front();
    double area = 0, more = 0;  // `more` sums differences from `first`, and is exactly zero if all are equal
    for (const Face face : mesh.faces()) {
        const double part = face_area(mesh, face);
        area += part;
        for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(face)))
            more += part * (thickness[v] - first) / 3;
    }
    return first + more / area;
}

}  // namespace

void set_thickness(const SheetSpec& sheet, SheetInput& input, std::vector<std::string>& warnings) {
    if (!sheet.thickness) return;
    std::vector<std::string> found;
    input.thickness = with_context(
        sheet.thickness->where, [&] { return mapped_thickness(*sheet.thickness, sheet, input.mesh, found); });
    for (const std::string& warning : found)
        warnings.push_back(fmt::format("{}: {}", sheet.thickness->where, warning));
    input.material.thickness = mean_by_area(input.mesh, input.thickness);
}

std::string thickness_text(const SheetInput& input) {
    const double thinnest = input.thinnest(), thickest = input.thickest();
    return thinnest == thickest ? fmt::format("{:.3g}", thinnest)
                                : fmt::format("{:.3g} to {:.3g}", thinnest, thickest);
}

Material thickest_material(const SheetInput& input) {
    Material material = input.material;
    material.thickness = input.thickest();
    return material;
}

ThicknessRange thickness_range(const std::vector<SheetInput>& inputs) {
    ThicknessRange range{std::numeric_limits<double>::infinity(), 0};
    for (const SheetInput& input : inputs) {
        range.thinnest = std::min(range.thinnest, input.thinnest());
        range.thickest = std::max(range.thickest, input.thickest());
    }
    return range;
}

}  // namespace sherd
