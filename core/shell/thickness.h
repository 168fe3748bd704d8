// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shell/shell.h"

namespace sherd {

/// Thickness, m, of an edge, a triangle or a hinge by its vertices: their mean. If no sheet is uneven, it is
/// the first vertex's thickness, from which the other thicknesses differ by round-off.
template <std::size_t N>
double mean_thickness(const Shell& shell, const std::array<Index, N>& vertices) {
    const double first = shell.thickness[vertices[0]];
    if (!shell.uneven) return first;
    double more = 0;  // exactly zero where all are equal
    for (const Index vertex : vertices) more += shell.thickness[vertex] - first;
    return first + more / static_cast<double>(N);
}

}  // namespace sherd
