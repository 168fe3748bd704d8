// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/detection/contact_candidates.h"

#include <algorithm>

#include "core/contact/geometry/continuous_collision.h"

namespace sherd {
namespace {

// Error of a distance over the largest coordinate: an upper bound, and the larger value from which
// Neighbourhood::round_off is computed, so that it stays valid when positions grow up to a hundredfold.
constexpr double rounding_at_least = 1e-14, rounding = 1e-12;

Positions less_mean(const Positions& motion) {
    const Vector3d mean = motion.rowwise().mean();  // evaluated once, not for every column
    return motion.colwise() - mean;
}

template <std::size_t N>
BoxTree tree(const std::vector<std::array<Index, N>>& elements, Index from, Index to, Index first_vertex,
             const std::vector<Box>& of_vertices, BoxTree::Division& known) {
    std::vector<Box> boxes(to - from);
    for (Index i = from; i < to; ++i)
        for (const Index vertex : elements[i]) boxes[i - from].include(of_vertices[vertex - first_vertex]);
    return BoxTree(boxes, known);
}

Box box_around(const Positions& from, const Positions& to) {
    return {from.rowwise().minCoeff().cwiseMin(to.rowwise().minCoeff()),
            from.rowwise().maxCoeff().cwiseMax(to.rowwise().maxCoeff())};
}

/// Number of pairs with overlapping boxes that are collected before the threads compute the distances of
/// these pairs.
constexpr std::size_t at_once = 1 << 15;

/// For each vertex of sheets, the box around its path in the motion of `within`, enlarged by
/// ContactCandidates::nearness times half the largest thickness of its elements and by `margins` times the
/// margin; empty boxes for the vertices of colliders.
std::vector<Box> vertex_boxes(const ContactSurface& surface, const Neighbourhood& within, int margins) {
    std::vector<Box> boxes(surface.vertices());
    for (Index v = surface.collider_vertices(); v < surface.vertices(); ++v) {
        const Eigen::Array3d from = within.start.col(v), to = from + within.motion.col(v).array();
        const double inflation = ContactCandidates::nearness * surface.largest_half_thickness(v) +
                                 margins * (within.margin + within.round_off);
        boxes[v] = {from.min(to) - inflation, from.max(to) + inflation};
    }
    return boxes;
}

template <std::size_t N>
struct Elements {
    std::vector<std::array<Index, N>> vertices;
    BoxTree tree;
};

/// Returns the elements for which wanted(vertices, box) is true, and the tree of their boxes. boxes: of the
/// vertices. If all elements are wanted and `known` is not null, the tree reuses this division.
template <std::size_t N, class Wanted>
Elements<N> those(const std::vector<std::array<Index, N>>& elements, const std::vector<Box>& boxes,
                  const Wanted& wanted, BoxTree::Division* known = nullptr) {
    const std::vector<Box> all = element_boxes(boxes, elements);
    std::vector<std::array<Index, N>> found;
    std::vector<Box> around;
    for (std::size_t i = 0; i < elements.size(); ++i)
        if (wanted(elements[i], all[i])) {
            found.push_back(elements[i]);
            around.push_back(all[i]);
        }
    const bool as_known = known && found.size() == elements.size();
    return {std::move(found), as_known ? BoxTree(around, *known) : BoxTree(around)};
}

std::vector<std::array<Index, 1>> points(Index from, Index to) {
    std::vector<std::array<Index, 1>> points;
    for (Index v = from; v < to; ++v) points.push_back({v});
    return points;
}

/// The vertices of two elements in the order of PairPositions; the lexicographically smaller one of two edges
/// comes first.
std::array<Index, 4> both(const std::array<Index, 1>& vertex, const std::array<Index, 3>& triangle) {
    return {vertex[0], triangle[0], triangle[1], triangle[2]};
}

std::array<Index, 4> both(const std::array<Index, 2>& one, const std::array<Index, 2>& other) {
    const auto& [first, second] = std::minmax(one, other);
    return {first[0], first[1], second[0], second[1]};
}

/// Unit vector from the middle of the second element to that of the first.
Vector3d between_middles(PairKind kind, const PairPositions& x) {
    const Vector3d middle = kind == PairKind::edge_edge
                                ? Vector3d(0.5 * (x.col(0) + x.col(1)) - 0.5 * (x.col(2) + x.col(3)))
                                : Vector3d(x.col(0) - (x.col(1) + x.col(2) + x.col(3)) / 3);
    return middle.normalized();
}

/// Flags, 1 for vertices of the surface that became or ceased to be corners of triangles, that have another
/// place on the sheet, or whose exemptions have changed.
std::vector<char> changed_vertices(const ShellChange& change, const ContactSurface& before,
                                   const ContactSurface& after) {
    std::vector<char> changed(after.vertices(), 0);
    for (std::size_t f = 0; f < before.triangles().size(); ++f)
        for (int i = 0; i < 3; ++i) {
            const Index old = before.triangles()[f][i], now = after.triangles()[f][i];
            if (old != now) changed[old] = changed[now] = 1;
        }
    for (const auto& [face, vertices] : change.changed)
        for (const Index v : before.triangles()[face]) changed[v] = 1;
    for (const auto& [face, parents] : change.reshaped)
        for (const Index v : after.triangles()[face]) changed[v] = 1;
    std::vector<std::array<Index, 2>> exempt_pairs;
    std::ranges::set_symmetric_difference(before.exempt_pairs(), after.exempt_pairs(),
                                          std::back_inserter(exempt_pairs));
    for (const auto& [a, b] : exempt_pairs) changed[a] = changed[b] = 1;
    std::vector<NearVertices> near;
    std::ranges::set_symmetric_difference(before.near_vertices(), after.near_vertices(),
                                          std::back_inserter(near));
    for (const auto& [vertices, reach] : near) changed[vertices[0]] = changed[vertices[1]] = 1;
    for (std::size_t c = 0; c < after.collider_count(); ++c)
        for (Index v = before.collider_vertices(); v < before.vertices(); ++v)
            if (before.is_surface_exempt(c, v) != after.is_surface_exempt(c, v)) changed[v] = 1;
    return changed;
}

/// Adapts `all`, an array [3, vertices] of all vertices of a surface, to a change of the sheets.
void follow_on_sheets(const ShellChange& change, Index collider_vertices, Positions& all) {
    Positions of_sheets = all.rightCols(all.cols() - collider_vertices);
    follow(of_sheets, change);
    all.conservativeResize(3, collider_vertices + of_sheets.cols());
    all.rightCols(of_sheets.cols()) = of_sheets;
}

}  // namespace

Neighbourhood::Neighbourhood(const Positions& x, const Positions& motion, double margin, Index colliders)
    : start(x),
      motion(colliders > 0 ? motion : less_mean(motion)),
      margin(margin),
      colliders(colliders),
      colliders_rest(motion.leftCols(colliders).isZero(0)) {
    round_off = rounding * ((start.cwiseAbs() + this->motion.cwiseAbs()).maxCoeff() + margin);
}

bool Neighbourhood::contains(const Positions& x, double spare) const {
    if (x.cols() != start.cols() || rounding_at_least * x.cwiseAbs().maxCoeff() > round_off) return false;
    const bool skip = colliders_rest && x.leftCols(colliders) == start.leftCols(colliders);
    const Eigen::Index first = skip ? colliders : 0;
    const Vector3d mean = colliders > 0 ? Vector3d::Zero() : Vector3d((x - start).rowwise().mean());
    const auto moved = [&](Eigen::Index v) -> Vector3d { return x.col(v) - start.col(v) - mean; };
    double way = 0, along = 0;
    for (Eigen::Index v = first; v < x.cols(); ++v) {
        way += motion.col(v).squaredNorm();
        along += moved(v).dot(motion.col(v));
    }
    const double time = way > 0 ? std::clamp(along / way, 0.0, 1.0) : 0;
    const double limit = std::max(0.0, margin - spare);
    for (Eigen::Index v = first; v < x.cols(); ++v)
        if (!((moved(v) - time * motion.col(v)).squaredNorm() <= limit * limit)) return false;
    return true;
}

bool Neighbourhood::contains(const Neighbourhood& other) const {
    return contains(other.start, other.margin) && contains(other.start + other.motion, other.margin);
}

const ColliderTrees::Trees* ColliderTrees::within_reach(const Box& reach, std::size_t collider,
                                                        const ContactSurface& surface,
                                                        const Neighbourhood& within) {
    const ContactSurface::Start first = surface.collider_starts()[collider],
                                end = surface.collider_starts()[collider + 1];
    const Positions from = within.start.middleCols(first.vertex, end.vertex - first.vertex);
    const Positions to = from + within.motion.middleCols(first.vertex, end.vertex - first.vertex);
    if (from.cols() == 0 || !box_around(from, to).meets(reach)) return nullptr;
    while (cached.size() <= collider)
        cached.push_back({Positions(3, 0), Positions(3, 0), {BoxTree({}), BoxTree({}), BoxTree({})}, {}});
    Cached& known = cached[collider];
    if (known.from.cols() == from.cols() && known.from == from && known.to == to) return &known.trees;
    std::vector<Box> boxes;
    for (Eigen::Index v = 0; v < from.cols(); ++v)
        boxes.push_back(
            {from.col(v).array().min(to.col(v).array()), from.col(v).array().max(to.col(v).array())});
    auto& [points, edges, triangles] = known.divisions;
    known.trees = {
        BoxTree(boxes, points),
        tree(surface.collider_edges(), first.edge, end.edge, first.vertex, boxes, edges),
        tree(surface.collider_triangles(), first.triangle, end.triangle, first.vertex, boxes, triangles)};
    known.from = from;
    known.to = to;
    return &known.trees;
}

ContactCandidates::ContactCandidates(const ContactSurface& surface, Neighbourhood neighbourhood,
                                     CachedTrees& cached, Threads team)
    : within(std::move(neighbourhood)), threads(std::move(team)) {
    find(surface, std::vector<char>(surface.vertices(), 1), cached);
}

void ContactCandidates::find(const ContactSurface& surface, const std::vector<char>& changed,
                             CachedTrees& cached) {
    using Entry = std::optional<PairBlocks::Entry>;
    std::vector<ElementPair> touching;
    std::vector<PairBlocks::Entry> found;
    const auto pair_up = [&] {
        threads.share_lots<Entry>(
            touching.size(), [&](std::size_t i, Entry& entry) { entry = pair_of(surface, touching[i]); },
            [&](std::size_t, std::span<const Entry> lot) {
                for (const Entry& entry : lot)
                    if (entry) found.push_back(*entry);
            });
        touching.clear();
    };
    const auto take = [&](const ElementPair& one) {
        touching.push_back(one);
        if (touching.size() == at_once) pair_up();
    };
    if (surface.sheets_meet()) meet_on_sheets(surface, changed, cached, take);
    if (surface.collider_vertices() > 0) meet_on_colliders(surface, changed, cached.colliders, take);
    pair_up();
    pairs.add(found, within.start);
}

template <class Take>
void ContactCandidates::meet_on_sheets(const ContactSurface& surface, const std::vector<char>& changed,
                                       CachedTrees& cached, const Take& take) const {
    const std::vector<Box> boxes = vertex_boxes(surface, within, 1);
    const auto has_changed = [&](const auto& element, const Box&) {
        return std::any_of(element.begin(), element.end(), [&](Index v) { return changed[v]; });
    };
    const auto others_at = [&](const BoxTree& tree) {
        return [&, around = tree.bounds()](const auto& element, const Box& box) {
            return box.meets(around) && !has_changed(element, box);
        };
    };
    const auto meet = [&](PairKind kind, const auto& some, const auto& others) {
        some.tree.meet(others.tree, [&](Index i, Index j) {
            take({kind, both(some.vertices[i], others.vertices[j])});
        });
    };
    const auto all_points = points(surface.collider_vertices(), surface.vertices());
    const auto vertices = those(all_points, boxes, has_changed, &cached.vertices);
    const auto triangles = those(surface.triangles(), boxes, has_changed, &cached.triangles);
    const auto edges = those(surface.edges(), boxes, has_changed, &cached.edges);
    meet(PairKind::vertex_triangle, vertices, triangles);
    const bool all_have_changed = std::ranges::find(changed, 0) == changed.end();
    if (!all_have_changed) {
        meet(PairKind::vertex_triangle, vertices,
             those(surface.triangles(), boxes, others_at(vertices.tree)));
        meet(PairKind::vertex_triangle, those(all_points, boxes, others_at(triangles.tree)), triangles);
        meet(PairKind::edge_edge, edges, those(surface.edges(), boxes, others_at(edges.tree)));
    }
    edges.tree.meet_itself([&](Index i, Index j) {
        take({PairKind::edge_edge, both(edges.vertices[i], edges.vertices[j])});
    });
}

template <class Take>
void ContactCandidates::meet_on_colliders(const ContactSurface& surface, const std::vector<char>& changed,
                                          ColliderTrees& colliders, const Take& take) const {
    // The boxes of colliders are enlarged by no margin, so the boxes of sheets are enlarged by two.
    const std::vector<Box> boxes = vertex_boxes(surface, within, 2);
    Box reach;
    for (const Box& box : boxes) reach.include(box);
    const auto all_points = points(surface.collider_vertices(), surface.vertices());
    for (std::size_t collider = 0; collider + 1 < surface.collider_starts().size(); ++collider) {
        const ContactSurface::Start first = surface.collider_starts()[collider];
        const ColliderTrees::Trees* trees = colliders.within_reach(reach, collider, surface, within);
        if (trees == nullptr) continue;
        const Box around = trees->points.bounds();
        const auto wanted = [&](const auto& element, const Box& box) {
            return box.meets(around) &&
                   std::any_of(element.begin(), element.end(), [&](Index v) { return changed[v]; });
        };
        const auto vertices = those(all_points, boxes, wanted);
        const auto edges = those(surface.edges(), boxes, wanted);
        const auto triangles = those(surface.triangles(), boxes, wanted);
        vertices.tree.meet(trees->triangles, [&](Index i, Index j) {
            take({PairKind::vertex_triangle,
                  both(vertices.vertices[i], surface.collider_triangles()[first.triangle + j])});
        });
        triangles.tree.meet(trees->points, [&](Index i, Index j) {
            take({PairKind::vertex_triangle, both(std::array{first.vertex + j}, triangles.vertices[i])});
        });
        edges.tree.meet(trees->edges, [&](Index i, Index j) {
            take({PairKind::edge_edge, both(edges.vertices[i], surface.collider_edges()[first.edge + j])});
        });
    }
}

std::optional<PairBlocks::Entry> ContactCandidates::pair_of(const ContactSurface& surface,
                                                            const ElementPair& touching) const {
    const auto& [kind, vertices] = touching;
    if (surface.apart(kind, vertices)) return {};
    const PairPositions x = columns(within.start, vertices);
    const double way =
        approach(kind, columns(within.motion, vertices)) + 2 * within.margin + within.round_off;
    const double farthest = nearness * surface.thickness(kind, vertices) + way;
    if (separation(kind, x, between_middles(kind, x)) > farthest) return {};
    const double distance = std::sqrt(squared_distance(closest_points(kind, x), x));
    if (distance > farthest) return {};
    const double activation_distance = surface.activation_distance(kind, vertices);
    if (distance > nearness * activation_distance + way) return {};
    return PairBlocks::Entry{surface.bare_pair(kind, vertices, activation_distance),
                             distance - activation_distance};
}

std::vector<ContactPair> ContactCandidates::pick(const ContactSurface& surface,
                                                 const Neighbourhood& smaller) const {
    const double around = 2 * smaller.margin + smaller.round_off;
    const auto comes_near = [&](const ContactPair& pair, double) {
        const PairPositions from = columns(smaller.start, pair.vertices);
        const PairPositions to = from + columns(smaller.motion, pair.vertices);
        const double far = nearness * pair.activation_distance + around;
        const Vector3d direction = (from * closest_points(pair.kind, from).weights).normalized();
        return separation(pair.kind, from, direction) <= far || separation(pair.kind, to, direction) <= far;
    };
    std::vector<ContactPair> picked = near(smaller.start, smaller.motion, nearness, around, comes_near);
    for (ContactPair& pair : picked) surface.stiffen(pair);
    return picked;
}

void ContactCandidates::follow(const ShellChange& change, const ContactSurface& before,
                               const ContactSurface& after, CachedTrees& cached) {
    if (within.start.cols() != before.vertices()) {
        *this = ContactCandidates(threads);
        return;
    }
    for (Positions* x : {&within.start, &within.motion})
        follow_on_sheets(change, before.collider_vertices(), *x);
    const std::vector<char> changed = changed_vertices(change, before, after);
    pairs.remove(changed);
    find(after, changed, cached);
}

}  // namespace sherd
