// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/detection/contact_surface.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include "core/contact/geometry/surface_edges.h"
#include "core/shell/thickness.h"

namespace sherd {
namespace {

constexpr double share = 0.5;           // number of columns for each kind of contact
constexpr double share_of_rest = 0.75;  // largest activation distance in a sheet, over distance at rest
// Activation distance of pairs with a collider over half the thickness of the sheet's element. At larger
// distances only the springs of vertices act, with the stiffness of the materials; a soft collider is
// compressed there, perhaps by much.
constexpr double share_of_collider = 0.5;
/// Mean mass of a pair's vertices over the least, from which a spring is softer.
constexpr double uneven_masses = 3;
/// Minimum distance of barriers over their activation distance.
constexpr double closest_to_sheet = 0.75, closest_to_collider = 0.2;

/// The thickness of each of the two elements, m.
std::array<double, 2> thicknesses(const Shell& shell, PairKind kind, const std::array<Index, 4>& vertices) {
    const auto [a, b, c, d] = vertices;
    if (kind == PairKind::edge_edge)
        return {mean_thickness(shell, std::array{a, b}), mean_thickness(shell, std::array{c, d})};
    return {shell.thickness[a], mean_thickness(shell, std::array{b, c, d})};
}

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

double half_thicknesses(const Shell& shell, PairKind kind, const std::array<Index, 4>& vertices) {
    const auto [first, second] = thicknesses(shell, kind, vertices);
    return 0.5 * (first + second);
}

double activation_distance_of_sheets(const Shell& shell, PairKind kind,
                                     const std::array<Index, 4>& vertices) {
    const double together = half_thicknesses(shell, kind, vertices);
    if (shell.vertex_sheet[vertices[0]] != shell.vertex_sheet[vertices[vertices_of_first(kind)]])
        return together;
    const PairPositions rest = columns(shell.rest, vertices);
    const double at_rest = std::sqrt(squared_distance(closest_points(kind, rest), rest));
    // Opposite elements of a crack have distance zero at rest. Their activation distance is asked for only
    // when they are no longer exempt.
    return at_rest > 0 ? std::min(together, share_of_rest * at_rest) : together;
}

ContactSurface::ContactSurface(const Shell& shell, const std::vector<ContactCollider>& colliders,
                               bool sheets_meet, bool springs)
    : shell(&shell),
      colliders(colliders),
      sheets(sheets_meet),
      springs(springs),
      in_exempt_pair(shell.rest.cols(), 0),
      is_near(shell.rest.cols(), 0) {
    add_colliders();
    const Index start = collider_vertices();
    for (const TriangleStencil& stencil : shell.triangles)
        triangle.push_back(shifted(stencil.vertices, start));
    add_sheet_edges();
    if (shell.uneven) find_largest_thicknesses();
    for (const auto& [a, b] : shell.exempt_pairs) {
        exempt_pair.push_back(shifted(std::array{a, b}, start));
        exempt_pair.push_back(shifted(std::array{b, a}, start));
        in_exempt_pair[a] = in_exempt_pair[b] = 1;
    }
    std::sort(exempt_pair.begin(), exempt_pair.end());
    for (const auto& [vertices, reach] : shell.near) {
        const auto [a, b] = vertices;
        near.push_back({shifted(std::array{a, b}, start), reach});
        near.push_back({shifted(std::array{b, a}, start), reach});
        is_near[a] = is_near[b] = 1;
    }
    std::sort(near.begin(), near.end());
    for (const ContactCollider& met : colliders)
        if (!shell.start_depths.empty())
            surface_exempt.push_back(shell.start_depths[met.number].surface_exempt);
}

void ContactSurface::add_colliders() {
    start_of.push_back({0, 0, 0});
    for (std::size_t i = 0; i < colliders.size(); ++i) {
        const ColliderSurface& surface = *colliders[i].surface;
        const Index start = collider_vertices();
        collider.resize(start + surface.size(), static_cast<Index>(i));
        for (const auto& vertices : surface.triangles) collider_triangle.push_back(shifted(vertices, start));
        for (const auto& ends : surface.edges) collider_edge.push_back(shifted(ends, start));
        collider_width.insert(collider_width.end(), surface.width.begin(), surface.width.end());
        start_of.push_back({collider_vertices(), static_cast<Index>(collider_edge.size()),
                            static_cast<Index>(collider_triangle.size())});
    }
}

void ContactSurface::add_sheet_edges() {
    std::vector<std::array<Index, 3>> triangles;
    std::vector<double> areas;
    for (const TriangleStencil& stencil : shell->triangles) {
        triangles.push_back(stencil.vertices);
        areas.push_back(stencil.membrane.area);
    }
    for (const SurfaceEdge& side : surface_edges(triangles, areas)) {
        const auto [a, b] = side.ends;
        edge.push_back(shifted(side.ends, collider_vertices()));
        width.push_back(side.area / (shell->rest.col(a) - shell->rest.col(b)).norm() +
                        (side.triangles == 1 ? mean_thickness(*shell, side.ends) : 0));
    }
}

void ContactSurface::find_largest_thicknesses() {
    largest_half.assign(in_exempt_pair.size(), 0);
    for (const TriangleStencil& stencil : shell->triangles) {
        const auto [a, b, c] = stencil.vertices;
        const double largest =
            0.5 * std::max({shell->thickness[a], shell->thickness[b], shell->thickness[c]});
        for (const Index v : stencil.vertices) largest_half[v] = std::max(largest_half[v], largest);
    }
}

bool ContactSurface::joined(Index a, Index b) const {
    return a == b || (in_exempt_pair[of_sheet(a)] && in_exempt_pair[of_sheet(b)] &&
                      std::binary_search(exempt_pair.begin(), exempt_pair.end(), std::array{a, b}));
}

double ContactSurface::reach(Index a, Index b) const {
    constexpr double unlimited = std::numeric_limits<double>::infinity();
    if (!is_near[of_sheet(a)] || !is_near[of_sheet(b)]) return unlimited;
    const auto found = std::ranges::lower_bound(near, std::array{a, b}, {}, &NearVertices::vertices);
    return found != near.end() && found->vertices == std::array{a, b} ? found->reach : unlimited;
}

bool ContactSurface::apart(PairKind kind, const std::array<Index, 4>& vertices) const {
    if (const ContactCollider* met = collider_of(kind, vertices))
        return std::any_of(vertices.begin(), vertices.end(), [&](Index vertex) {
            return !of_collider(vertex) &&
                   (is_surface_exempt(met - colliders.data(), vertex) ||
                    std::binary_search(met->around.begin(), met->around.end(), of_sheet(vertex)));
        });
    const int first = vertices_of_first(kind);
    for (int i = 0; i < first; ++i)
        for (int j = first; j < 4; ++j)
            if (joined(vertices[i], vertices[j])) return true;
    return false;
}

const ContactCollider* ContactSurface::collider_of(PairKind kind,
                                                   const std::array<Index, 4>& vertices) const {
    for (const Index vertex : {vertices[0], vertices[vertices_of_first(kind)]})
        if (of_collider(vertex)) return &colliders[collider[vertex]];
    return nullptr;
}

std::array<double, 2> ContactSurface::half_thicknesses(PairKind kind,
                                                       const std::array<Index, 4>& vertices) const {
    const auto half = [&](const auto& element) {
        return of_collider(element[0]) ? 0
                                       : 0.5 * mean_thickness(*shell, shifted(element, -collider_vertices()));
    };
    const auto [a, b, c, d] = vertices;
    if (kind == PairKind::edge_edge) return {half(std::array{a, b}), half(std::array{c, d})};
    return {half(std::array{a}), half(std::array{b, c, d})};
}

double ContactSurface::thickness(PairKind kind, const std::array<Index, 4>& vertices) const {
    const auto [first, second] = half_thicknesses(kind, vertices);
    return first + second;
}

double ContactSurface::activation_distance(PairKind kind, const std::array<Index, 4>& vertices) const {
    if (const ContactCollider* met = collider_of(kind, vertices))
        return (met->bare ? 1 : share_of_collider) * thickness(kind, vertices);
    double least = activation_distance_of_sheets(*shell, kind, shifted(vertices, -collider_vertices()));
    const int first = vertices_of_first(kind);
    for (int i = 0; i < first && !near.empty(); ++i)
        for (int j = first; j < 4; ++j) least = std::min(least, reach(vertices[i], vertices[j]));
    return least;
}

double ContactSurface::footprint(Index vertex) const {
    if (!of_collider(vertex)) return shell->footprint[of_sheet(vertex)];
    return colliders[collider[vertex]].surface->footprint[vertex - start_of[collider[vertex]].vertex];
}

double ContactSurface::edge_width(Index a, Index b) const {
    return of_collider(a) ? width_of(collider_edge, collider_width, a, b) : width_of(edge, width, a, b);
}

double ContactSurface::rest_length(Index a, Index b) const {
    if (!of_collider(a)) return (shell->rest.col(of_sheet(a)) - shell->rest.col(of_sheet(b))).norm();
    const Positions& points = colliders[collider[a]].surface->points;
    const Index first = start_of[collider[a]].vertex;
    return (points.col(a - first) - points.col(b - first)).norm();
}

double ContactSurface::area_on_collider(PairKind kind, const std::array<Index, 4>& vertices) const {
    const auto [a, b, c, d] = vertices;
    if (kind == PairKind::vertex_triangle)
        return of_collider(a) ? std::min(footprint(a), (footprint(b) + footprint(c) + footprint(d)) / 3)
                              : footprint(a);
    // In a pair of edges with a collider, the collider's edge comes first.
    return std::numbers::pi / 2 * std::min(edge_width(a, b), rest_length(c, d)) * edge_width(c, d);
}

double ContactSurface::area(PairKind kind, const std::array<Index, 4>& vertices) const {
    const auto [a, b, c, d] = vertices;
    if (kind == PairKind::vertex_triangle) return footprint(a);
    return std::numbers::pi / 2 * edge_width(a, b) * edge_width(c, d);
}

double ContactSurface::column(PairKind kind, const std::array<Index, 4>& vertices) const {
    const Index a = vertices[0], b = vertices[vertices_of_first(kind)];
    const auto young = [&](Index v) { return shell->young[of_sheet(v)]; };
    const auto [first, second] = half_thicknesses(kind, vertices);
    if (const ContactCollider* met = collider_of(kind, vertices)) {
        const Index v = of_collider(a) ? b : a;
        return 2 * (first + second) * (1 / young(v) + 1 / met->young);
    }
    return first / young(a) + second / young(b);
}

ContactPair ContactSurface::bare_pair(PairKind kind, const std::array<Index, 4>& vertices,
                                      double activation_distance) const {
    const double closest = springs ? 0 : closest_of_barrier(kind, vertices);
    return {kind, vertices, 0, activation_distance, {}, closest, springs};
}

double ContactSurface::closest_of_barrier(PairKind kind, const std::array<Index, 4>& vertices) const {
    return collider_of(kind, vertices) ? closest_to_collider : closest_to_sheet;
}

double ContactSurface::softness(const std::array<Index, 4>& vertices) const {
    double sum = 0, count = 0, least = std::numeric_limits<double>::infinity();
    for (const Index v : vertices)
        if (!of_collider(v)) {
            const double mass = shell->mass[of_sheet(v)];
            sum += mass;
            ++count;
            least = std::min(least, mass);
        }
    return std::min(1.0, uneven_masses * count * least / sum);
}

void ContactSurface::stiffen(ContactPair& pair) const {
    const auto& [a, b, c, d] = pair.vertices;
    const double on = collider_of(pair.kind, pair.vertices) ? area_on_collider(pair.kind, pair.vertices)
                                                            : area(pair.kind, pair.vertices);
    pair.stiffness = share * on / column(pair.kind, pair.vertices);
    if (springs) pair.stiffness *= softness(pair.vertices);
    if (pair.kind == PairKind::edge_edge)
        pair.mollifier = edge_mollifier(rest_length(a, b), rest_length(c, d));
}

}  // namespace sherd
