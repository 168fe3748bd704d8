// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/contact/barrier/contact_pair.h"
#include "core/contact/geometry/collider_surface.h"
#include "core/shell/shell.h"
#include "core/state_visitor.h"

namespace sherd {

/// A collider whose surface takes part in contact.
struct ContactCollider {
    const ColliderSurface* surface = nullptr;
    double young = 3e10;  ///< Pa
    double friction = 0;  ///< Coulomb coefficient
    std::vector<Index> around =
        {};  ///< ascending, vertices of sheets that are pinned inside the collider and do not collide with it
    std::size_t number = 0;  ///< in Shell::start_depths
    bool bare = false;  ///< whether vertices have no springs, so that pairs act from where these would begin
};

/// Half the sum of the thicknesses, and the activation distance (see ContactSurface), m, of two elements of
/// sheets that are given by their vertices in the order of PairPositions.
double half_thicknesses(const Shell& shell, PairKind kind, const std::array<Index, 4>& vertices);
double activation_distance_of_sheets(const Shell& shell, PairKind kind, const std::array<Index, 4>& vertices);

/// The triangles and edges of sheets and of colliders between which contact acts, with their stiffness and
/// thickness. Vertices are numbered consecutively, those of the colliders first, then those of the sheets.
///
/// A pair is active when the distance of the middle surfaces is below its activation distance, half the sum
/// of the thicknesses, where an edge or a triangle has the mean thickness of its vertices. Between elements
/// of one sheet it is at most three quarters of their distance at rest, so that the rest shape is free of
/// contact forces (edges may be shorter than the thickness). A collider has no thickness: a sheet touches its
/// surface at half the sheet's thickness, where the springs of ObstacleContact begin. The activation distance
/// of pairs with a collider is half of that: the barrier stops what vertices and springs do not. With a
/// deforming ("bare") collider it is the whole.
///
/// The stiffness is that of a column of sheet, half of each thickness high, of the two materials in series: k
/// = area / (t_a / (2 Y_a) + t_b / (2 Y_b)). The area of a vertex is its footprint. The area of two edges is
/// pi/2 times their widths, where the width of an edge is its share of the sheet's area over its length, plus
/// the thickness on the rim: summed over the crossings of two meshes that lie on each other at random angles,
/// this is the area covered. Each of the three kinds of contact of two sheets (vertices of one, vertices of
/// the other, edges) gets half a column. Against a collider the column is that of column_stiffness(), and an
/// element of the collider acts on no more than the width of the sheet's element: the force of a corner does
/// not depend on the size of its box.
class ContactSurface {
  public:
    /// Shell and colliders' surfaces must outlive this object, which must be made again when the shell's
    /// vertices or triangles have changed. sheets_meet: whether elements of sheets collide with each other.
    /// springs: whether pairs are springs (Barrier), which may be compressed until the middle surfaces touch.
    explicit ContactSurface(const Shell& shell, const std::vector<ContactCollider>& colliders = {},
                            bool sheets_meet = true, bool springs = false);

    Index collider_vertices() const { return static_cast<Index>(collider.size()); }
    Index vertices() const { return collider_vertices() + static_cast<Index>(in_exempt_pair.size()); }
    bool of_collider(Index vertex) const { return vertex < collider_vertices(); }
    /// The number of the collider that a vertex of colliders belongs to.
    Index collider_number(Index vertex) const { return collider[vertex]; }
    bool sheets_meet() const { return sheets; }
    bool has_springs() const { return springs; }

    // Elements of the sheets:
    const std::vector<std::array<Index, 3>>& triangles() const { return triangle; }
    const std::vector<std::array<Index, 2>>& edges() const { return edge; }  ///< ascending
    /// Exempt pairs of vertices, which coincide at a crack or whose faces cross at the start, in both
    /// orders, ascending.
    const std::vector<std::array<Index, 2>>& exempt_pairs() const { return exempt_pair; }
    /// Whether elements with this vertex of sheets are exempt from contact with a collider's surface since
    /// the start.
    bool is_surface_exempt(std::size_t of_collider, Index vertex) const {
        return !surface_exempt.empty() && surface_exempt[of_collider][of_sheet(vertex)] != 0;
    }
    std::size_t collider_count() const { return colliders.size(); }
    /// Pairs of vertices whose elements have a smaller activation distance since the start, in both orders,
    /// ascending.
    const std::vector<NearVertices>& near_vertices() const { return near; }
    // Elements of the colliders, one collider after the other:
    const std::vector<std::array<Index, 3>>& collider_triangles() const { return collider_triangle; }
    const std::vector<std::array<Index, 2>>& collider_edges() const { return collider_edge; }  ///< ascending
    /// The number of the first vertex, edge and triangle of a collider.
    struct Start {
        Index vertex, edge, triangle;
    };
    /// Starts of all colliders, followed by the end of the last one.
    const std::vector<Start>& collider_starts() const { return start_of; }

    double half_thickness(Index vertex) const {
        return of_collider(vertex) ? 0 : 0.5 * shell->thickness[of_sheet(vertex)];
    }
    /// Upper bound, m, on half the thickness of elements with this vertex of sheets.
    double largest_half_thickness(Index vertex) const {
        return largest_half.empty() ? half_thickness(vertex) : largest_half[of_sheet(vertex)];
    }

    // Functions of two elements, given by their vertices in the order of PairPositions, edges as in edges():

    /// Whether the elements are exempt from contact: they share a vertex, have an exempt pair of vertices, or
    /// a vertex of one is pinned inside the collider of the other, or exempt from it since the start.
    bool apart(PairKind kind, const std::array<Index, 4>& vertices) const;
    /// Half the sum of their thicknesses, m.
    double thickness(PairKind kind, const std::array<Index, 4>& vertices) const;
    /// The activation distance, m; at most the reach of vertices in near_vertices().
    double activation_distance(PairKind kind, const std::array<Index, 4>& vertices) const;
    /// The minimum distance, m, of the pair as a barrier, also if it is a spring.
    double minimum_of_barrier(const ContactPair& pair) const {
        return closest_of_barrier(pair.kind, pair.vertices) * pair.activation_distance;
    }
    /// The pair without its stiffness and mollifier.
    ContactPair bare_pair(PairKind kind, const std::array<Index, 4>& vertices,
                          double activation_distance) const;
    /// Gives a pair its stiffness and its mollifier.
    void stiffen(ContactPair& pair) const;
    /// The collider that one of the elements belongs to; null if none does.
    const ContactCollider* collider_of(PairKind kind, const std::array<Index, 4>& vertices) const;

    void visit_state(StateVisitor& visit) {
        auto& [shell, colliders, sheets, springs, collider, start_of, triangle, collider_triangle, edge,
               collider_edge, exempt_pair, width, collider_width, largest_half, surface_exempt, near,
               in_exempt_pair, is_near] = *this;
        visit(collider, start_of, triangle, collider_triangle, edge, collider_edge, exempt_pair, width,
              collider_width, largest_half, surface_exempt, near, in_exempt_pair, is_near);
    }

  private:
    Index of_sheet(Index vertex) const { return vertex - collider_vertices(); }
    /// The minimum distance of a pair as a barrier, as a share of its activation distance.
    double closest_of_barrier(PairKind kind, const std::array<Index, 4>& vertices) const;
    bool joined(Index a, Index b) const;   ///< whether the vertices are equal or an exempt pair
    double reach(Index a, Index b) const;  ///< m, of NearVertices; infinite for other vertices
    /// Half the thickness of either element, m.
    std::array<double, 2> half_thicknesses(PairKind kind, const std::array<Index, 4>& vertices) const;
    double edge_width(Index a, Index b) const;
    double rest_length(Index a, Index b) const;
    double footprint(Index vertex) const;
    /// The contact area of the pair, m^2.
    double area(PairKind kind, const std::array<Index, 4>& vertices) const;
    double area_on_collider(PairKind kind, const std::array<Index, 4>& vertices) const;
    /// Compliance times area of the materials between the middle surfaces, m/Pa.
    double column(PairKind kind, const std::array<Index, 4>& vertices) const;
    void add_colliders();
    void add_sheet_edges();
    void find_largest_thicknesses();

    const Shell* shell;
    std::vector<ContactCollider> colliders;
    bool sheets, springs;
    std::vector<Index> collider;  ///< the collider of each vertex of colliders
    std::vector<Start> start_of;  ///< see collider_starts()
    std::vector<std::array<Index, 3>> triangle, collider_triangle;
    std::vector<std::array<Index, 2>> edge, collider_edge, exempt_pair;
    std::vector<double> width, collider_width;  ///< m, of each edge
    std::vector<double> largest_half;           ///< m, of each vertex; empty: the thickness is even
    /// Exemptions by collider and vertex of sheets; empty: none.
    std::vector<std::vector<char>> surface_exempt;
    std::vector<NearVertices> near;
    std::vector<char> in_exempt_pair, is_near;  ///< flags of each vertex of sheets
};

}  // namespace sherd
