// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/measures/cracks/cracks_about.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/measures/cracks/crack_directions.h"
#include "app/measures/cracks/disjoint_paths.h"
#include "core/elements/membrane.h"
#include "meshops/intersect/nearest_triangle.h"

namespace sherd {
namespace {

constexpr int ray_count = 16;
constexpr double ray_spacing = 2 * std::numbers::pi / ray_count;

/// A vertex at rest, as seen from the point about which cracks are counted, and from the sheet's normal
/// there.
struct Seen {
    double distance = 0;           ///< m, straight distance from the point
    double angle = 0, across = 0;  ///< angle about the normal, rad; distance from the normal, m
};

/// The sheet that is nearest to the point, and its cracked edges.
struct SheetAbout {
    std::vector<Seen> seen;                   ///< [R] each vertex at rest; zeros for vertices of other sheets
    std::vector<char> is_of_sheet;            ///< [R] whether each vertex is in the sheet
    std::vector<std::array<Index, 2>> edges;  ///< cracked edges of the sheet, by their vertices at rest
    double mean_edge = 0, farthest = 0;       ///< m: mean length of `edges`, distance of the farthest vertex
    const std::vector<char>& on_rim;          ///< CrackGraph::on_rim
};

SheetAbout sheet_about(const CrackGraph& cracks, const Snapshot& frame, const Vector3d& point) {
    const RestMesh& rest = frame.rest;
    const std::size_t nearest = NearestTriangle(rest.position, rest.faces)(point).triangle;
    const Index sheet_number = frame.face_sheet[nearest];
    const Eigen::Matrix<double, 3, 2> plane = frame_axes(columns(rest.position, rest.faces[nearest]));
    const Vector3d normal = plane.col(0).cross(plane.col(1));
    const Vector3d first = in_plane_axis(normal), second = normal.cross(first);
    const auto vertices = static_cast<std::size_t>(rest.position.cols());
    SheetAbout sheet{std::vector<Seen>(vertices), std::vector<char>(vertices, 0), {}, 0, 0, cracks.on_rim};
    for (std::size_t f = 0; f < rest.faces.size(); ++f)
        for (const Index v : rest.faces[f]) {
            if (frame.face_sheet[f] != sheet_number) continue;
            const Vector3d way = rest.position.col(v) - point;
            const double x = way.dot(first), y = way.dot(second);
            sheet.seen[v] = {way.norm(), std::atan2(y, x), std::hypot(x, y)};
            sheet.is_of_sheet[v] = 1;
            sheet.farthest = std::max(sheet.farthest, way.norm());
        }
    for (const CrackedEdge& edge : cracks.edges) {
        if (frame.face_sheet[edge.faces[0]] != sheet_number) continue;
        sheet.edges.push_back(edge.vertices);
        sheet.mean_edge += edge.length;
    }
    if (!sheet.edges.empty()) sheet.mean_edge /= static_cast<double>(sheet.edges.size());
    return sheet;
}

/// Returns the number of disjoint_paths() along cracked edges. role_of(v): returns the role of vertex v of
/// the sheet.
template <class RoleOf>
std::size_t count(const SheetAbout& sheet, RoleOf role_of) {
    std::vector<PathRole> roles(sheet.seen.size(), PathRole::none);
    for (std::size_t v = 0; v < roles.size(); ++v)
        if (sheet.is_of_sheet[v]) roles[v] = role_of(v);
    return disjoint_paths(sheet.edges, roles);
}

std::size_t radial_cracks(const SheetAbout& sheet, double radius) {
    const double half = std::min(sheet.mean_edge, radius / 2);
    return count(sheet, [&](std::size_t v) {
        const double beyond = sheet.seen[v].distance - radius;
        // Paths may end at a rim inside the band.
        if (std::abs(beyond) <= (sheet.on_rim[v] ? 0 : half)) return PathRole::between;
        return beyond < 0 ? PathRole::begin : PathRole::end;
    });
}

/// Returns the angle, rad, from the ray at `angle` to a vertex, -pi to pi.
double turn(const Seen& seen, double angle) {
    return std::remainder(seen.angle - angle, 2 * std::numbers::pi);
}

std::size_t ring_cracks(const SheetAbout& sheet, double angle, double from) {
    return count(sheet, [&](std::size_t v) {
        const Seen& seen = sheet.seen[v];
        const double way = turn(seen, angle);
        if (seen.distance < from || std::abs(way) > std::numbers::pi / 2) return PathRole::none;
        if (std::abs(way) <= ray_spacing / 4 || seen.across * std::abs(std::sin(way)) <= sheet.mean_edge)
            return PathRole::between;
        return way < 0 ? PathRole::begin : PathRole::end;
    });
}

bool meets(const SheetAbout& sheet, double angle, double from) {
    for (std::size_t v = 0; v < sheet.seen.size(); ++v)
        if (sheet.is_of_sheet[v] && sheet.seen[v].distance >= from &&
            std::abs(turn(sheet.seen[v], angle)) <= ray_spacing / 2)
            return true;
    return false;
}

template <class Counts>
double median(const Counts& counts) {
    std::vector<std::size_t> cracks;
    for (const auto& one : counts) cracks.push_back(one.cracks);
    if (cracks.empty()) return 0;
    std::ranges::sort(cracks);
    const std::size_t size = cracks.size();
    return static_cast<double>(cracks[(size - 1) / 2] + cracks[size / 2]) / 2;
}

}  // namespace

double CracksAbout::radial() const {
    return median(circles);
}

double CracksAbout::ring() const {
    return median(rays);
}

CracksAbout cracks_about(const CrackGraph& cracks, const Snapshot& frame, const Vector3d& point,
                         std::vector<double> radii) {
    const SheetAbout sheet = sheet_about(cracks, frame, point);
    if (radii.empty())
        for (int eighth = 1; eighth < 8; ++eighth) radii.push_back(eighth * sheet.farthest / 8);
    std::ranges::sort(radii);
    CracksAbout about{.point = point, .circles = {}, .rays = {}};
    for (const double radius : radii) about.circles.push_back({radius, radial_cracks(sheet, radius)});
    for (int i = 0; i < ray_count; ++i)
        if (const double angle = i * ray_spacing; meets(sheet, angle, radii.front()))
            about.rays.push_back({i * 360.0 / ray_count, ring_cracks(sheet, angle, radii.front())});
    return about;
}

}  // namespace sherd
