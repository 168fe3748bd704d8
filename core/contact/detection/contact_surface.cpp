// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/detection/contact_surface.h"

#include <algorithm>
#include <numbers>

#include "core/contact/geometry/surface_edges.h"

namespace sherd {
namespace {

constexpr double share = 0.5;           // of a column, for each of the ways in which two sheets touch
constexpr double share_of_rest = 0.75;  // activation distance of neighbours, over their distance at rest
// A collider's surface is active from this share of half the thickness on. Above that only the springs of
// vertices act, whose stiffness is that of the materials; a soft collider yields there, perhaps by much.
constexpr double share_of_solid = 0.5;
constexpr double closest_to_sheet = 0.75, closest_to_solid = 0.2;  // minimum over activation distance

template <std::size_t N>
std::array<Index, N> shifted(std::array<Index, N> vertices, Index by) {
    for (Index& vertex : vertices) vertex += by;
    return vertices;
}

double width_of(const std::vector<std::array<Index, 2>>& edges, const std::vector<double>& widths, Index a,
                Index b) {
    return widths[std::lower_bound(edges.begin(), edges.end(), std::array{a, b}) - edges.begin()];
}

}  // namespace

ContactSurface::ContactSurface(const Sheet& sheet, const std::vector<ContactSolid>& solids, bool sheets_meet)
    : sheet(&sheet), solids(solids), sheets(sheets_meet), has_twin(sheet.rest.cols(), 0) {
    add_solids();
    const Index start = solid_vertices();
    for (const TriangleStencil& stencil : sheet.triangles)
        triangle.push_back(shifted(stencil.vertices, start));
    add_sheet_edges();
    for (const auto& [a, b] : sheet.twins) {
        twin.push_back(shifted(std::array{a, b}, start));
        twin.push_back(shifted(std::array{b, a}, start));
        has_twin[a] = has_twin[b] = 1;
    }
    std::sort(twin.begin(), twin.end());
}

void ContactSurface::add_solids() {
    start_of.push_back({0, 0, 0});
    for (std::size_t i = 0; i < solids.size(); ++i) {
        const SolidSurface& surface = *solids[i].surface;
        const Index start = solid_vertices();
        solid.resize(start + surface.size(), static_cast<Index>(i));
        for (const auto& vertices : surface.triangles) solid_triangle.push_back(shifted(vertices, start));
        for (const auto& ends : surface.edges) solid_edge.push_back(shifted(ends, start));
        solid_width.insert(solid_width.end(), surface.width.begin(), surface.width.end());
        start_of.push_back({solid_vertices(), static_cast<Index>(solid_edge.size()),
                            static_cast<Index>(solid_triangle.size())});
    }
}

void ContactSurface::add_sheet_edges() {
    std::vector<std::array<Index, 3>> triangles;
    std::vector<double> areas;
    for (const TriangleStencil& stencil : sheet->triangles) {
        triangles.push_back(stencil.vertices);
        areas.push_back(stencil.membrane.area);
    }
    for (const SurfaceEdge& side : surface_edges(triangles, areas)) {
        const auto [a, b] = side.ends;
        edge.push_back(shifted(side.ends, solid_vertices()));
        width.push_back(side.area / (sheet->rest.col(a) - sheet->rest.col(b)).norm() +
                        (side.triangles == 1 ? sheet->thickness[a] : 0));
    }
}

bool ContactSurface::joined(Index a, Index b) const {
    return a == b || (has_twin[of_sheet(a)] && has_twin[of_sheet(b)] &&
                      std::binary_search(twin.begin(), twin.end(), std::array{a, b}));
}

bool ContactSurface::apart(PairKind kind, const std::array<Index, 4>& vertices) const {
    if (const ContactSolid* met = solid_of(kind, vertices))
        return std::any_of(vertices.begin(), vertices.end(), [&](Index vertex) {
            return !of_solid(vertex) &&
                   std::binary_search(met->around.begin(), met->around.end(), of_sheet(vertex));
        });
    const int first = vertices_of_first(kind);
    for (int i = 0; i < first; ++i)
        for (int j = first; j < 4; ++j)
            if (joined(vertices[i], vertices[j])) return true;
    return false;
}

const ContactSolid* ContactSurface::solid_of(PairKind kind, const std::array<Index, 4>& vertices) const {
    for (const Index vertex : {vertices[0], vertices[vertices_of_first(kind)]})
        if (of_solid(vertex)) return &solids[solid[vertex]];
    return nullptr;
}

double ContactSurface::thickness(PairKind kind, const std::array<Index, 4>& vertices) const {
    return half_thickness(vertices[0]) + half_thickness(vertices[vertices_of_first(kind)]);
}

double ContactSurface::touching(PairKind kind, const std::array<Index, 4>& vertices) const {
    const double together = thickness(kind, vertices);
    if (solid_of(kind, vertices)) return share_of_solid * together;
    const std::array<Index, 4> mine = shifted(vertices, -solid_vertices());
    if (sheet->body[mine[0]] != sheet->body[mine[vertices_of_first(kind)]]) return together;
    const PairPositions rest = columns(sheet->rest, mine);
    const double at_rest = std::sqrt(squared_distance(closest_points(kind, rest), rest));
    // Lips of a crack have distance zero at rest; whoever opened the crack has passed them on to the barrier.
    return at_rest > 0 ? std::min(together, share_of_rest * at_rest) : together;
}

double ContactSurface::footprint(Index vertex) const {
    if (!of_solid(vertex)) return sheet->footprint[of_sheet(vertex)];
    return solids[solid[vertex]].surface->footprint[vertex - start_of[solid[vertex]].vertex];
}

double ContactSurface::edge_width(Index a, Index b) const {
    return of_solid(a) ? width_of(solid_edge, solid_width, a, b) : width_of(edge, width, a, b);
}

double ContactSurface::rest_length(Index a, Index b) const {
    if (!of_solid(a)) return (sheet->rest.col(of_sheet(a)) - sheet->rest.col(of_sheet(b))).norm();
    const Positions& points = solids[solid[a]].surface->points;
    const Index first = start_of[solid[a]].vertex;
    return (points.col(a - first) - points.col(b - first)).norm();
}

double ContactSurface::area_on_solid(PairKind kind, const std::array<Index, 4>& vertices) const {
    const auto [a, b, c, d] = vertices;
    if (kind == PairKind::vertex_triangle)
        return of_solid(a) ? std::min(footprint(a), (footprint(b) + footprint(c) + footprint(d)) / 3)
                           : footprint(a);
    // In a pair of edges the collider's edge comes first.
    return std::numbers::pi / 2 * std::min(edge_width(a, b), rest_length(c, d)) * edge_width(c, d);
}

double ContactSurface::area(PairKind kind, const std::array<Index, 4>& vertices) const {
    const auto [a, b, c, d] = vertices;
    if (kind == PairKind::vertex_triangle) return footprint(a);
    return std::numbers::pi / 2 * edge_width(a, b) * edge_width(c, d);
}

double ContactSurface::column(PairKind kind, const std::array<Index, 4>& vertices) const {
    const Index a = vertices[0], b = vertices[vertices_of_first(kind)];
    const auto young = [&](Index v) { return sheet->young[of_sheet(v)]; };
    if (const ContactSolid* met = solid_of(kind, vertices)) {
        const Index v = of_solid(a) ? b : a;
        return 2 * half_thickness(v) * (1 / young(v) + 1 / met->young);
    }
    return half_thickness(a) / young(a) + half_thickness(b) / young(b);
}

ContactPair ContactSurface::pair(PairKind kind, const std::array<Index, 4>& vertices, double touching) const {
    const auto [a, b, c, d] = vertices;
    const bool on_solid = solid_of(kind, vertices);
    const double on = on_solid ? area_on_solid(kind, vertices) : area(kind, vertices);
    return {
        kind,
        vertices,
        share * on / column(kind, vertices),
        touching,
        kind == PairKind::edge_edge ? edge_mollifier(rest_length(a, b), rest_length(c, d)) : EdgeMollifier{},
        on_solid ? closest_to_solid : closest_to_sheet};
}

}  // namespace sherd
