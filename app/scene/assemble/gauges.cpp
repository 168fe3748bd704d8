// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/assemble/gauges.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/messages/place_text.h"
#include "meshops/error.h"

namespace sherd {
namespace {

Index sheet_number(const Scene& scene, const std::string& name) {
    if (name.empty()) return -1;
    const auto found = std::ranges::find(scene.sheets, name, &SheetSpec::name);
    return static_cast<Index>(found - scene.sheets.begin());
}

double longest_edge(const Shell& mechanics, Index face) {
    const TrianglePositions x = columns(mechanics.rest, mechanics.triangles[face].vertices);
    double longest = 0;
    for (int i = 0; i < 3; ++i) longest = std::max(longest, (x.col(i) - x.col((i + 1) % 3)).norm());
    return longest;
}

}  // namespace

void add_gauges(const Scene& scene, const Shell& mechanics, SimulationOptions& options) {
    for (const GaugeSpec& spec : scene.gauges) {
        Gauge gauge = nearest_gauge(mechanics, spec.at, sheet_number(scene, spec.sheet));
        const double distance = (gauge.place - spec.at).norm();
        if (distance > longest_edge(mechanics, gauge.face))
            throw Error(
                fmt::format("{}: is {:.3g} m from the nearest point of {}, as placed, {}; at most an edge "
                            "length is allowed",
                            spec.where, distance, spec.sheet.empty() ? "any sheet" : "sheet." + spec.sheet,
                            place_text(gauge.place)));
        gauge.displacement = spec.displacement;
        gauge.fields = spec.fields;
        options.gauges.push_back(gauge);
    }
}

}  // namespace sherd
