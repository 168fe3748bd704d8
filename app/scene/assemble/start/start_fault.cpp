// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/assemble/start/start_fault.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/messages/place_text.h"
#include "meshops/mesh_measures.h"

namespace sherd {

StartFault start_fault(FaultKind kind, Face face, const BreakableShell& all) {
    const std::span<const Index> sheets = all.face_sheet();
    const Index sheet = sheets[face],
                first = static_cast<Index>(std::ranges::find(sheets, sheet) - sheets.begin());
    return {kind, static_cast<std::size_t>(sheet), static_cast<Index>(face) - first,
            centroid(all.mesh(), face)};
}

std::string fault_place(const StartFault& fault) {
    return fmt::format("face {} at {}", fault.face, place_text(fault.at));
}

std::string fault_text(const StartFault& fault, const Scene& scene) {
    return fmt::format("face {} of sheet.{} at {}", fault.face, scene.sheets[fault.sheet].name,
                       place_text(fault.at));
}

}  // namespace sherd
