// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/build/sheet_parting.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "fracture/start_overlaps.h"
#include "meshops/error.h"
#include "meshops/mesh_measures.h"

namespace sherd {
namespace {

constexpr std::size_t most_shown = 5;
constexpr double farthest = 0.05;  // that a sheet is moved, of its thickness
constexpr double steepest = 0.5;   // cosine between two normals of contact that one motion serves

/// The fault of one face of an overlap; faces of all sheets are numbered in the sheets' order.
StartFault fault_of(Index face, const StartOverlap& overlap, const BreakableSheet& all) {
    const auto of_face = all.face_sheet();
    const auto first = std::find(of_face.begin(), of_face.end(), of_face[face]) - of_face.begin();
    return {overlap.crossing ? FaultKind::crossing : FaultKind::too_near,
            static_cast<std::size_t>(of_face[face]), face - static_cast<Index>(first),
            centroid(all.mesh(), Face(face))};
}

std::string sentence(const StartOverlap& overlap, const Scene& scene, const BreakableSheet& all) {
    const std::string a = fault_words(fault_of(overlap.faces[0], overlap, all), scene),
                      b = fault_words(fault_of(overlap.faces[1], overlap, all), scene);
    if (overlap.crossing) return fmt::format("{} and {} cross or touch", a, b);
    return fmt::format("{} and {} are {:.3g} m apart, less than {:.3g} m", a, b, overlap.distance,
                       overlap.needed);
}

Error not_apart(const Scene& scene, const BreakableSheet& all, const std::vector<StartOverlap>& overlaps) {
    std::string text;
    for (std::size_t i = 0; i < std::min(most_shown, overlaps.size()); ++i)
        text += "\n  " + sentence(overlaps[i], scene, all);
    if (overlaps.size() > most_shown)
        text += fmt::format("\n  and {} pairs more", overlaps.size() - most_shown);
    return Error(fmt::format(
        "{}: sheets do not start apart, with half their thickness on either side:{}\nmove the sheets, make "
        "them thinner, or set contact.sheets = false",
        scene.file.string(), text));
}

bool held(const Scene& scene, const std::vector<SheetInput>& inputs, Index sheet) {
    return !inputs[sheet].pinned.empty() || !scene.sheets[sheet].symmetries.empty();
}

/// A sheet, and how it has to move, m.
struct Parting {
    Index sheet;
    Vector3d way;
};

/// How to part two sheets, a before b, whose faces overlap so; none where one motion does not do.
std::optional<Parting> parting(const Scene& scene, const std::vector<SheetInput>& inputs, Index a, Index b,
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
    const bool a_is_held = held(scene, inputs, a), b_is_held = held(scene, inputs, b);
    if (a_is_held && b_is_held) return {};
    const bool a_is_above = normal.dot(scene.gravity) > 0;
    if (b_is_held || (a_is_above && !a_is_held)) return Parting{a, -way * normal};
    return Parting{b, way * normal};
}

/// The overlaps by the two sheets that they are of; none if there is one that no motion of sheets mends.
using OverlapsOfSheets = std::map<std::array<Index, 2>, std::vector<StartOverlap>>;

std::optional<OverlapsOfSheets> by_sheets(const BreakableSheet& all,
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
}

/// Moves sheets until none overlap; returns how far, m, each, or none where that would be too far.
std::optional<std::vector<Vector3d>> part(const Scene& scene, std::vector<SheetInput>& inputs) {
    std::vector<Vector3d> moved(inputs.size(), Vector3d::Zero());
    for (std::size_t sweep = 0; sweep <= inputs.size(); ++sweep) {
        const BreakableSheet all(inputs);
        const auto overlaps = by_sheets(all, start_overlaps(all));
        if (!overlaps) return {};
        if (overlaps->empty()) return moved;
        for (const auto& [sheets, found] : *overlaps) {
            const auto next = parting(scene, inputs, sheets[0], sheets[1], found);
            if (!next) return {};
            const auto& [sheet, way] = *next;
            moved[sheet] += way;
            if (moved[sheet].norm() > farthest * inputs[sheet].material.thickness) return {};
            move(inputs[sheet], way);
        }
    }
    return {};
}

}  // namespace

void part_sheets(const Scene& scene, std::vector<SheetInput>& inputs, std::vector<std::string>& warnings) {
    if (!scene.contact.sheets) return;
    const BreakableSheet all(inputs);
    const std::vector<StartOverlap> overlaps = start_overlaps(all);
    if (overlaps.empty()) return;
    std::vector<SheetInput> apart = inputs;
    const auto moved = part(scene, apart);
    if (!moved) throw not_apart(scene, all, overlaps);
    inputs = std::move(apart);
    for (std::size_t s = 0; s < inputs.size(); ++s)
        if (const Vector3d& way = (*moved)[s]; way.norm() > 0)
            warnings.push_back(
                fmt::format("{}: starts nearer to another sheet than half the sum of their thicknesses; "
                            "sheet.{} is moved "
                            "by [{:.3g}, {:.3g}, {:.3g}] m, {:.2g} of its thickness",
                            scene.sheets[s].where, scene.sheets[s].name, way.x(), way.y(), way.z(),
                            way.norm() / inputs[s].material.thickness));
}

std::vector<StartFault> sheet_faults(const Scene& scene, const std::vector<SheetInput>& inputs) {
    std::vector<StartFault> faults;
    if (!scene.contact.sheets) return faults;
    const BreakableSheet all(inputs);
    const std::vector<StartOverlap> overlaps = start_overlaps(all);
    std::vector<SheetInput> apart = inputs;
    if (overlaps.empty() || part(scene, apart)) return faults;
    for (const StartOverlap& overlap : overlaps)
        for (const Index face : overlap.faces) faults.push_back(fault_of(face, overlap, all));
    return faults;
}

}  // namespace sherd
