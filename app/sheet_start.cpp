// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sheet_start.h"

#include <fmt/format.h>

#include <algorithm>

#include "fracture/start_overlaps.h"
#include "meshops/error.h"

namespace sherd {
namespace {

constexpr std::size_t most_shown = 5;

/// "face 12 of sheet.plate"; faces of all sheets are numbered in the sheets' order.
std::string name_of(Index face, const Scene& scene, const BreakableSheet& all) {
    const auto of_face = all.face_sheet();
    const Index sheet = of_face[face];
    const auto first = std::find(of_face.begin(), of_face.end(), sheet) - of_face.begin();
    return fmt::format("face {} of sheet.{}", face - first, scene.sheets[sheet].name);
}

std::string sentence(const StartOverlap& overlap, const Scene& scene, const BreakableSheet& all) {
    const std::string a = name_of(overlap.faces[0], scene, all), b = name_of(overlap.faces[1], scene, all);
    if (overlap.crossing) return fmt::format("{} and {} cross or touch", a, b);
    return fmt::format("{} and {} are {:.3g} m apart, less than {:.3g} m", a, b, overlap.distance,
                       overlap.needed);
}

}  // namespace

void require_sheets_apart(const Scene& scene, const BreakableSheet& all) {
    const std::vector<StartOverlap> overlaps = start_overlaps(all);
    if (overlaps.empty()) return;
    std::string text;
    for (std::size_t i = 0; i < std::min(most_shown, overlaps.size()); ++i)
        text += "\n  " + sentence(overlaps[i], scene, all);
    if (overlaps.size() > most_shown)
        text += fmt::format("\n  and {} pairs more", overlaps.size() - most_shown);
    throw Error(fmt::format(
        "{}: sheets do not start apart, with half their thickness on either side:{}\nmove the sheets, make "
        "them "
        "thinner, or set contact.sheets = false",
        scene.file.string(), text));
}

}  // namespace sherd
