// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/assemble/start/obstacle_start.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/messages/place_text.h"
#include "core/contact/colliders/contact_colliders.h"
#include "core/contact/colliders/start_depth.h"
#include "core/contact/sheets/sheet_contact.h"
#include "fracture/shell/start_overlaps.h"
#include "meshops/error.h"
#include "meshops/intersect/surface_crossings.h"
#include "meshops/mesh_measures.h"

namespace sherd {
namespace {

constexpr double deepest_start = 0.25, noticed = 1e-3;  // shares of the thickness: larger overlaps are
                                                        // refused, and reported

/// Vertices of one sheet that overlap one obstacle at the start.
struct InsideObstacle {
    std::size_t count = 0;
    Vertex deepest;
    double depth = 0;                                   ///< m, overlap of the vertex `deepest`
    std::vector<Vertex> deep;                           ///< vertices whose overlap exceeds deepest_start
    std::vector<std::pair<Index, double>> depths = {};  ///< the `count` vertices, and their overlaps, m
};

bool is_refused(const InsideObstacle& found) {
    return !found.deep.empty();
}

InsideObstacle inside(const SheetInput& input, const Obstacle& obstacle) {
    InsideObstacle found;
    const Eigen::Isometry3d pose = obstacle.motion.at(0);
    for (const Vertex v : input.mesh.vertices()) {
        if (std::binary_search(input.pinned.begin(), input.pinned.end(), static_cast<Index>(v.idx())))
            continue;
        const double thickness = input.thickness_at(v);
        const double depth = overlap(*obstacle.shape, pose, input.starts_at(v), 0.5 * thickness).depth;
        if (depth > noticed * thickness) {
            ++found.count;
            found.depths.emplace_back(static_cast<Index>(v), depth);
        }
        if (depth > deepest_start * thickness) found.deep.push_back(v);
        if (depth <= found.depth) continue;
        found.depth = depth;
        found.deepest = v;
    }
    return found;
}

std::string message(const SheetSpec& sheet, const SheetInput& input, const ObstacleSpec& obstacle,
                    const InsideObstacle& found) {
    return fmt::format(
        "{}: {} of {} vertices of sheet.{} start inside; the deepest, vertex {} at {}, is {:.3g} m beyond "
        "touching: move the sheet or the obstacle by that much, or make it smaller",
        obstacle.where, found.count, input.mesh.number_of_vertices(), sheet.name, found.deepest.idx(),
        place_text(input.starts_at(found.deepest)), found.depth);
}

/// Faces of one sheet that start across the surface of one obstacle, or too near to it.
struct SurfaceMeeting {
    std::vector<StartFault> crossing, near;
    double distance = std::numeric_limits<double>::infinity();  ///< m, between the nearest pair of elements;
                                                                ///< infinite: none is too near
    double touching = 0;  ///< m, distance at which this pair touches: half the thickness
    Vector3d at = Vector3d::Zero();
};

bool is_refused(const SurfaceMeeting& found) {
    return !found.crossing.empty() || std::isfinite(found.distance);
}

/// Returns a face that contains the sheet's element of a contact pair between a sheet and a collider. In
/// pairs, vertices of colliders are numbered before vertices of sheets.
Face face_of(const Mesh& mesh, const ContactPair& pair, Index collider_vertices) {
    std::vector<Index> own;
    for (const Index v : pair.vertices)
        if (v >= collider_vertices) own.push_back(v - collider_vertices);
    return face_with(mesh, own);
}

std::vector<Face> faces_through(const Mesh& mesh, const Obstacle& obstacle,
                                const std::vector<Index>& around) {
    const Positions placed = obstacle.points_at(0);
    const std::vector<Vector3d> points(placed.colwise().begin(), placed.colwise().end());
    std::vector<Face> crossing = surface_crossings(mesh, points, obstacle.surface->triangles);
    std::erase_if(crossing, [&](Face face) {
        const auto corners = mesh.vertices_around_face(mesh.halfedge(face));
        return std::any_of(corners.begin(), corners.end(), [&](Vertex v) {
            return std::binary_search(around.begin(), around.end(), static_cast<Index>(v));
        });
    });
    return crossing;
}

/// Returns, for each sheet, its faces that start across an obstacle's surface or too near to it. sheets:
/// number of sheets.
std::vector<SurfaceMeeting> surface_meetings(const BreakableShell& all, std::size_t sheets,
                                             const Obstacle& obstacle) {
    std::vector<SurfaceMeeting> found(sheets);
    if (!obstacle.surface) return found;
    const Shell& mechanics = all.mechanics();
    const Positions& x = mechanics.position;
    for (const Face face :
         faces_through(placed_mesh(all), obstacle, contact_colliders(mechanics, {obstacle})[0].around)) {
        const StartFault fault = start_fault(FaultKind::across_obstacle, face, all);
        found[fault.sheet].crossing.push_back(fault);
    }
    const SheetContact contact(mechanics, {obstacle}, false);
    for (const ContactPair& pair : contact.active_pairs(x)) {
        const PairPositions local = columns(contact.at_end(x), pair.vertices);
        const double touching = contact.surface().thickness(pair.kind, pair.vertices);
        const double apart = distance(pair, local);
        if (apart >= (1 - 2 * deepest_start) * touching) continue;  // contact separates such a pair gently
        const Face face = face_of(all.mesh(), pair, contact.surface().collider_vertices());
        const StartFault fault = start_fault(FaultKind::near_obstacle, face, all);
        SurfaceMeeting& met = found[fault.sheet];
        met.near.push_back(fault);
        if (apart < met.distance) {
            met.distance = apart;
            met.touching = touching;
            met.at = local.rowwise().mean();
        }
    }
    return found;
}

/// Returns surface_meetings() with each obstacle.
std::vector<std::vector<SurfaceMeeting>> surface_meetings(const BreakableShell& all, std::size_t sheets,
                                                          const std::vector<Obstacle>& obstacles) {
    std::vector<std::vector<SurfaceMeeting>> found;
    for (const Obstacle& obstacle : obstacles) found.push_back(surface_meetings(all, sheets, obstacle));
    return found;
}

std::string message(const SheetSpec& sheet, const SheetInput& input, const ObstacleSpec& obstacle,
                    const SurfaceMeeting& found) {
    if (!found.crossing.empty())
        return fmt::format(
            "{}: {} of {} faces of sheet.{} start across its surface; the first is {}: move the sheet or the "
            "obstacle, or pin the vertices that it holds",
            obstacle.where, found.crossing.size(), input.mesh.number_of_faces(), sheet.name,
            fault_place(found.crossing.front()));
    return fmt::format(
        "{}: sheet.{} starts {:.3g} m from its surface, at {}, where half its thickness is {:.3g} m: move "
        "the sheet or the obstacle by {:.3g} m, or make it smaller",
        obstacle.where, sheet.name, found.distance, place_text(found.at), found.touching,
        found.touching - found.distance);
}

}  // namespace

void require_free_start(const Scene& scene, const std::vector<SheetInput>& inputs, const BreakableShell& all,
                        const std::vector<ObstacleSpec>& specs, const std::vector<Obstacle>& obstacles,
                        std::vector<std::string>& warnings) {
    std::vector<std::string> mistakes;
    std::vector<std::string>& refused = scene.exempts_overlaps ? warnings : mistakes;
    const std::string then = scene.exempts_overlaps
                                 ? "; until it has separated, contact acts only where it gets deeper, and "
                                   "its faces there do not collide with the surface (contact.start)"
                                 : "";
    const auto meetings = surface_meetings(all, inputs.size(), obstacles);
    for (std::size_t s = 0; s < inputs.size(); ++s)
        for (std::size_t o = 0; o < obstacles.size(); ++o) {
            const InsideObstacle inside_it = inside(inputs[s], obstacles[o]);
            const bool deep = is_refused(inside_it);
            if (inside_it.count > 0)
                (deep ? refused : warnings)
                    .push_back(message(scene.sheets[s], inputs[s], specs[o], inside_it) + then);
            if (deep) continue;
            const SurfaceMeeting& met = meetings[o][s];
            if (is_refused(met)) refused.push_back(message(scene.sheets[s], inputs[s], specs[o], met) + then);
        }
    if (!mistakes.empty()) throw Error(fmt::format("{}", fmt::join(mistakes, "\n")));
}

void exempt_sheet_overlaps(const std::vector<SheetInput>& inputs, const std::vector<Obstacle>& obstacles,
                           std::size_t first, std::size_t all_colliders, BreakableShell& all) {
    const auto meetings = surface_meetings(all, inputs.size(), obstacles);
    Index first_vertex = 0, first_face = 0;
    for (std::size_t s = 0; s < inputs.size(); ++s) {
        for (std::size_t o = 0; o < obstacles.size(); ++o) {
            const auto let = [&](Index vertex, double depth, bool surface_exempt) {
                exempt_overlap(all.mechanics(), all_colliders, first + o, vertex, depth, surface_exempt);
            };
            for (const auto& [vertex, depth] : inside(inputs[s], obstacles[o]).depths)
                let(first_vertex + vertex, depth, obstacles[o].surface != nullptr);
            for (const auto* faults : {&meetings[o][s].crossing, &meetings[o][s].near})
                for (const StartFault& fault : *faults)
                    for (const Index v : all.mechanics().triangles[first_face + fault.face].vertices)
                        let(v, 0, true);
        }
        first_vertex += static_cast<Index>(inputs[s].mesh.number_of_vertices());
        first_face += static_cast<Index>(inputs[s].mesh.number_of_faces());
    }
}

std::vector<StartFault> obstacle_faults(const std::vector<SheetInput>& inputs, const BreakableShell& all,
                                        const std::vector<Obstacle>& obstacles) {
    std::vector<StartFault> faults;
    const auto meetings = surface_meetings(all, inputs.size(), obstacles);
    for (std::size_t s = 0; s < inputs.size(); ++s) {
        const Mesh& mesh = inputs[s].mesh;
        for (std::size_t o = 0; o < obstacles.size(); ++o) {
            const InsideObstacle inside_it = inside(inputs[s], obstacles[o]);
            for (const Vertex v : inside_it.deep)
                for (const Face face : mesh.faces_around_target(mesh.halfedge(v)))
                    if (face != Mesh::null_face())
                        faults.push_back(
                            {FaultKind::inside_obstacle, s, static_cast<Index>(face), centroid(mesh, face)});
            if (is_refused(inside_it)) continue;
            const SurfaceMeeting& met = meetings[o][s];
            faults.insert(faults.end(), met.near.begin(), met.near.end());
            faults.insert(faults.end(), met.crossing.begin(), met.crossing.end());
        }
    }
    return faults;
}

}  // namespace sherd
