// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/assemble/start/sheet_separation.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "fracture/shell/start_overlaps.h"
#include "meshops/error.h"
#include "meshops/mesh_measures.h"

namespace sherd {
namespace {

constexpr std::size_t most_shown = 5;
constexpr double farthest = 0.05;  // largest displacement of a sheet, as a share of its thickness
constexpr double steepest = 0.5;   // least cosine between a normal of contact and the mean normal

/// Returns the fault of `face`, one of the two faces of an overlap. It is numbered over all sheets.
StartFault fault_of(Index face, const StartOverlap& overlap, const BreakableShell& all) {
    return start_fault(overlap.crossing ? FaultKind::crossing : FaultKind::too_near, Face(face), all);
}

std::string sentence(const StartOverlap& overlap, const Scene& scene, const BreakableShell& all) {
    const std::string a = fault_text(fault_of(overlap.faces[0], overlap, all), scene),
                      b = fault_text(fault_of(overlap.faces[1], overlap, all), scene);
    if (overlap.crossing) return fmt::format("{} and {} cross or touch", a, b);
    return fmt::format("{} and {} are {:.3g} m apart, less than {:.3g} m", a, b, overlap.distance,
                       overlap.needed);
}

std::string sentences(const Scene& scene, const BreakableShell& all,
                      const std::vector<StartOverlap>& overlaps) {
    std::string text;
    for (std::size_t i = 0; i < std::min(most_shown, overlaps.size()); ++i)
        text += "\n  " + sentence(overlaps[i], scene, all);
    if (overlaps.size() > most_shown)
        text += fmt::format("\n  and {} pairs more", overlaps.size() - most_shown);
    return text;
}

Error not_apart(const Scene& scene, const BreakableShell& all, const std::vector<StartOverlap>& overlaps) {
    return Error(fmt::format(
        "{}: sheets overlap at the start, with half their thickness on either side of the mesh:{}\n"
        "move the sheets, make them thinner, or set contact.start = \"exempt\", so that these faces do not "
        "collide until they have separated",
        scene.file.string(), sentences(scene, all, overlaps)));
}

std::string exemption(const Scene& scene, const BreakableShell& all,
                      const std::vector<StartOverlap>& overlaps) {
    const auto crossing = std::ranges::count_if(overlaps, &StartOverlap::crossing);
    return fmt::format(
        "{}: {} pairs of faces cross or touch at the start and {} are too near; until they have separated, "
        "the former do not collide, and the latter only if they come nearer (contact.start = \"error\" makes "
        "this an error):{}",
        scene.file.string(), crossing, overlaps.size() - static_cast<std::size_t>(crossing),
        sentences(scene, all, overlaps));
}

/// A sheet, and the displacement of this sheet (m) that removes an overlap.
struct Parting {
    Index sheet;
    Vector3d way;
};

/// Returns the displacement of sheet a or b that removes their overlaps; none if no single translation does
/// so, or if both sheets are supported. overlaps: all of these two sheets; their normals point from a to b.
std::optional<Parting> parting(const Scene& scene, Index a, Index b,
                               const std::vector<StartOverlap>& overlaps) {
    Vector3d mean = Vector3d::Zero();
    for (const StartOverlap& overlap : overlaps) mean += overlap.normal;
    const Vector3d normal = mean.normalized();  // from a to b
    double way = 0;
    for (const StartOverlap& overlap : overlaps) {
        const double cosine = overlap.normal.dot(normal);
        if (!(cosine > steepest)) return {};
        way = std::max(way, (overlap.needed - overlap.distance) / cosine);
    }
    const bool a_is_held = scene.sheets[a].is_supported(), b_is_held = scene.sheets[b].is_supported();
    if (a_is_held && b_is_held) return {};
    const bool a_is_above = normal.dot(scene.simulation.stepper.gravity) > 0;
    if (b_is_held || (a_is_above && !a_is_held)) return Parting{a, -way * normal};
    return Parting{b, way * normal};
}

/// Overlaps, grouped by the pair of their sheets. by_sheets() returns none if faces intersect, or overlap
/// within a sheet: no displacement of whole sheets removes such an overlap.
using OverlapsOfSheets = std::map<std::array<Index, 2>, std::vector<StartOverlap>>;

std::optional<OverlapsOfSheets> by_sheets(const BreakableShell& all,
                                          const std::vector<StartOverlap>& overlaps) {
    OverlapsOfSheets found;
    for (const StartOverlap& overlap : overlaps) {
        const Index a = all.face_sheet()[overlap.faces[0]], b = all.face_sheet()[overlap.faces[1]];
        if (overlap.crossing || a == b) return {};
        found[{a, b}].push_back(overlap);
    }
    return found;
}

void move(SheetInput& input, const Vector3d& way) {
    for (const Vertex v : input.mesh.vertices()) {
        Point& at = input.mesh.point(v);
        at = Point(at.x() + way.x(), at.y() + way.y(), at.z() + way.z());
    }
    input.start.colwise() += way;
}

/// Sheets that have been moved apart, and the displacement of each of them, m.
struct PartedSheets {
    std::vector<SheetInput> inputs;
    BreakableShell all;
    std::vector<Vector3d> moved;
};

/// Moves sheets until no faces overlap; returns none if that is not possible, or if a sheet would have to
/// move too far.
std::optional<PartedSheets> part(const Scene& scene, const std::vector<SheetInput>& inputs,
                                 const BreakableShell& all, std::vector<StartOverlap> overlaps) {
    PartedSheets parted{inputs, all, std::vector<Vector3d>(inputs.size(), Vector3d::Zero())};
    for (std::size_t sweep = 0; sweep <= inputs.size(); ++sweep) {
        const auto of_sheets = by_sheets(parted.all, overlaps);
        if (!of_sheets) return {};
        if (of_sheets->empty()) return parted;
        for (const auto& [sheets, found] : *of_sheets) {
            const auto next = parting(scene, sheets[0], sheets[1], found);
            if (!next) return {};
            const auto& [sheet, way] = *next;
            parted.moved[sheet] += way;
            if (parted.moved[sheet].norm() > farthest * inputs[sheet].thinnest()) return {};
            move(parted.inputs[sheet], way);
        }
        parted.all = BreakableShell(parted.inputs);
        overlaps = start_overlaps(parted.all);
    }
    return {};
}

}  // namespace

void separate_overlapping_sheets(const Scene& scene, std::vector<SheetInput>& inputs, BreakableShell& all,
                                 std::vector<std::string>& warnings) {
    if (!scene.simulation.stepper.contact.sheets) return;
    const std::vector<StartOverlap> overlaps = start_overlaps(all);
    if (overlaps.empty()) return;
    std::optional<PartedSheets> parted = part(scene, inputs, all, overlaps);
    if (!parted && !scene.exempts_overlaps) throw not_apart(scene, all, overlaps);
    if (!parted) {
        warnings.push_back(exemption(scene, all, overlaps));
        all.exempt(overlaps);
        return;
    }
    inputs = std::move(parted->inputs);
    all = std::move(parted->all);
    for (std::size_t s = 0; s < inputs.size(); ++s)
        if (const Vector3d& way = parted->moved[s]; way.norm() > 0)
            warnings.push_back(
                fmt::format("{}: starts nearer to another sheet than half the sum of their thicknesses; "
                            "sheet.{} is moved "
                            "by [{:.3g}, {:.3g}, {:.3g}] m, {:.2g} of its thickness",
                            scene.sheets[s].where, scene.sheets[s].name, way.x(), way.y(), way.z(),
                            way.norm() / inputs[s].thinnest()));
}

std::vector<StartFault> sheet_faults(const Scene& scene, const std::vector<SheetInput>& inputs,
                                     const BreakableShell& all) {
    std::vector<StartFault> faults;
    if (!scene.simulation.stepper.contact.sheets) return faults;
    const std::vector<StartOverlap> overlaps = start_overlaps(all);
    if (overlaps.empty() || part(scene, inputs, all, overlaps)) return faults;
    for (const StartOverlap& overlap : overlaps)
        for (const Index face : overlap.faces) faults.push_back(fault_of(face, overlap, all));
    return faults;
}

}  // namespace sherd
