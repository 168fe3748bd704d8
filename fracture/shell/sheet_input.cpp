// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/shell/sheet_input.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "meshops/error.h"
#include "meshops/mesh_measures.h"

namespace sherd {

Vector3d SheetInput::starts_at(Vertex vertex) const {
    return start.cols() > 0 ? Vector3d(start.col(static_cast<Index>(vertex))) : position(mesh, vertex);
}

double SheetInput::thinnest() const {
    return thickness.empty() ? material.thickness : *std::ranges::min_element(thickness);
}

double SheetInput::thickest() const {
    return thickness.empty() ? material.thickness : *std::ranges::max_element(thickness);
}

void require_thickness(const SheetInput& input, std::size_t sheet) {
    const std::string of_sheet = "sheet " + std::to_string(sheet) + ": ";
    const std::size_t count = input.mesh.number_of_vertices(), given = input.thickness.size();
    if (given != count && given > 0)
        throw Error(of_sheet + std::to_string(given) + " thicknesses for " + std::to_string(count) +
                    " vertices");
    for (std::size_t v = 0; v < given; ++v)
        if (!(input.thickness[v] > 0 && std::isfinite(input.thickness[v])))
            throw Error(of_sheet + "the thickness of vertex " + std::to_string(v) + ", " +
                        std::to_string(input.thickness[v]) + " m, is not a positive number");
}

}  // namespace sherd
