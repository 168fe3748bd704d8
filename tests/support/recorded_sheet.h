// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "app/recording/recording.h"
#include "core/shell/sheet.h"

namespace sherd::test {

/// A sheet of rubber that is nothing but a surface for SheetContact. thickness: m, body: number of the sheet,
/// of each vertex.
inline Sheet bare_sheet(const Positions& rest, const Positions& position,
                        const std::vector<std::array<Index, 3>>& triangles,
                        const std::vector<double>& thickness, const std::vector<Index>& body) {
    Sheet sheet;
    resize_vertices(sheet, static_cast<Index>(rest.cols()));
    sheet.rest = rest;
    sheet.position = position;
    sheet.young.setConstant(2e6);
    sheet.body = body;
    std::copy(thickness.begin(), thickness.end(), sheet.thickness.begin());
    for (const std::array<Index, 3>& corners : triangles) {
        const Material rubber{
            .density = 1000, .thickness = thickness[corners[0]], .young = 2e6, .poisson = 0.4};
        sheet.triangles.push_back(
            {corners, membrane_triangle(columns(rest, corners), membrane_elasticity(rubber))});
        for (const Index v : corners) sheet.footprint[v] += sheet.triangles.back().membrane.area / 3;
    }
    return sheet;
}

/// The sheets of a frame as such a surface. Vertices that a crack has split are twins, however far apart.
inline Sheet recorded_sheet(const Snapshot& frame) {
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
    Sheet sheet = bare_sheet(rest, frame.position, frame.faces, thickness, body);
    for (const std::vector<Index>& all : copies)
        for (std::size_t i = 0; i < all.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) sheet.twins.push_back({all[j], all[i]});
    std::sort(sheet.twins.begin(), sheet.twins.end());
    return sheet;
}

}  // namespace sherd::test
