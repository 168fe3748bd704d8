// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/build/loads.h"

#include <fmt/format.h>

#include "app/scene/build/selection.h"
#include "meshops/error.h"

namespace sherd {
namespace {

std::vector<Index> numbers_of(const std::vector<char>& selected) {
    std::vector<Index> numbers;
    for (Index v = 0; v < static_cast<Index>(selected.size()); ++v)
        if (selected[v]) numbers.push_back(v);
    return numbers;
}

std::vector<Index> selected_triangles(const Shell& mechanics, const std::vector<char>& selected) {
    std::vector<Index> triangles;
    for (Index t = 0; t < static_cast<Index>(mechanics.triangles.size()); ++t) {
        const std::array<Index, 3>& v = mechanics.triangles[t].vertices;
        if (selected[v[0]] && selected[v[1]] && selected[v[2]]) triangles.push_back(t);
    }
    return triangles;
}

}  // namespace

void add_loads(const Scene& scene, const std::vector<SheetInput>& inputs, const Shell& mechanics,
               SimulationOptions& options) {
    for (const LoadSpec& spec : scene.loads) {
        const std::vector<char> selected = selected_vertices(spec.on, spec.sheet, scene, inputs);
        Load load;
        load.ramp = spec.ramp;
        if (spec.kind == "point")
            load.dead = point_forces(mechanics, numbers_of(selected), spec.force);
        else if (spec.kind == "line")
            load.dead = line_forces(mechanics, boundary_triangle_edges(mechanics, selected), spec.force);
        else if (spec.kind == "area")
            load.spread = area_forces(mechanics, selected_triangles(mechanics, selected), spec.force);
        else if (spec.kind == "moment")
            load.moments = edge_moments(mechanics, boundary_triangle_edges(mechanics, selected), spec.moment);
        else
            load.pressed = selected_triangles(mechanics, selected);
        load.pressure = spec.pressure;
        if (load.dead.empty() && load.spread.empty() && load.pressed.empty() && load.moments.empty())
            throw Error(fmt::format(
                "{}: acts on nothing: {} must be in its box, boundary or group", spec.where,
                spec.kind == "point"                           ? "a vertex"
                : spec.kind == "line" || spec.kind == "moment" ? "both ends of an edge of the boundary"
                                                               : "all vertices of a face"));
        options.stepper.shell.loads.push_back(load);
    }
}

}  // namespace sherd
