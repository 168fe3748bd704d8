// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "app/recording/recording.h"
#include "core/shell/shell.h"

namespace sherd::test {

/// Rubber sheet, with what SheetContact needs of it. thickness: [V] m. body: [V] number of each vertex's
/// sheet.
inline Shell bare_sheet(const Positions& rest, const Positions& position,
                        const std::vector<std::array<Index, 3>>& triangles,
                        const std::vector<double>& thickness, const std::vector<Index>& body) {
    Shell shell;
    resize_vertices(shell, static_cast<Index>(rest.cols()));
    shell.rest = rest;
    shell.position = position;
    shell.young.setConstant(2e6);
    shell.vertex_sheet = body;
    std::copy(thickness.begin(), thickness.end(), shell.thickness.begin());
    for (const std::array<Index, 3>& corners : triangles) {
        const Material rubber{
            .density = 1000, .thickness = thickness[corners[0]], .young = 2e6, .poisson = 0.4};
        shell.triangles.push_back(
            {corners, membrane_triangle(columns(rest, corners), membrane_elasticity(rubber))});
        for (const Index v : corners) shell.footprint[v] += shell.triangles.back().membrane.area / 3;
    }
    return shell;
}

/// Sheets of a recorded frame, as a bare_sheet(). Copies of a vertex that a crack has split are exempt from
/// contact with each other, however far apart they are.
inline Shell recorded_sheet(const Snapshot& frame) {
    const std::size_t count = frame.position.cols();
    Positions rest(3, count);
    std::vector<double> thickness(count);
    std::vector<Index> body(count);
    std::vector<std::vector<Index>> copies(frame.rest.position.cols());
    for (std::size_t v = 0; v < count; ++v) {
        rest.col(v) = frame.rest.position.col(frame.original[v]);
        copies[frame.original[v]].push_back(static_cast<Index>(v));
    }
    for (std::size_t f = 0; f < frame.faces.size(); ++f)
        for (const Index v : frame.faces[f]) {
            thickness[v] = frame.rest.thickness[f];
            body[v] = frame.face_sheet[f];
        }
    Shell shell = bare_sheet(rest, frame.position, frame.faces, thickness, body);
    for (const std::vector<Index>& all : copies)
        for (std::size_t i = 0; i < all.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) shell.exempt_pairs.push_back({all[j], all[i]});
    std::sort(shell.exempt_pairs.begin(), shell.exempt_pairs.end());
    return shell;
}

}  // namespace sherd::test
