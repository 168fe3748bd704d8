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
    /// Numbers in the shell, ascending, of the vertices that are pinned inside the collider: their elements
    /// do not collide with it.
    std::vector<Index> around = {};
    std::size_t number = 0;  ///< number of the collider's entry in Shell::start_depths
    /// Whether the sheets' vertices have no springs (ObstacleContact) against the collider, so that pairs act
    /// from the distance at which such springs would begin.
    bool bare = false;
};

/// Half the sum of the thicknesses, m, of two elements of sheets that are given by their vertices in the
/// shell, in the order of PairPositions.
double half_thicknesses(const Shell& shell, PairKind kind, const std::array<Index, 4>& vertices);
/// The activation distance (see ContactSurface), m, of two such elements.
double activation_distance_of_sheets(const Shell& shell, PairKind kind, const std::array<Index, 4>& vertices);

/// The triangles and edges of sheets and of colliders between which contact acts, with their stiffness and
/// thickness. Vertices are numbered consecutively, the colliders' vertices first, then the sheets' vertices.
///
/// A pair is active when the distance of the middle surfaces of its elements is below its activation
/// distance, half the sum of their thicknesses, where an edge or a triangle has the mean thickness of its
/// vertices. The activation distance of two elements of one sheet is at most three quarters of their distance
/// at rest, so that the rest shape is free of contact forces (edges may be shorter than the thickness). A
/// collider has no thickness: a sheet touches its surface at half the sheet's thickness, where the springs of
/// ObstacleContact begin. The activation distance of pairs with a collider is half of this distance: the
/// barrier stops what the springs of vertices do not. With a deforming ("bare") collider it is the whole
/// distance.
///
/// The stiffness of two sheets' elements is that of a column of both materials in series, which is half of
/// each thickness high: k = area / (t_a / (2 Y_a) + t_b / (2 Y_b)), times one half. The area of a
/// vertex-triangle pair is the footprint of the vertex. The area of two edges is pi/2 times the product of
/// their widths. The width of an edge is its share of the sheet's area over its length, plus, on the rim, the
/// thickness: summed over the crossings of two meshes that lie on each other at random angles, this gives the
/// area covered. The factor of one half is there since three kinds of contact act between two sheets
/// (vertices of the first sheet, vertices of the second, edges), each with half a column. Against a collider
/// the stiffness is half of column_stiffness(), and an element of the collider acts no wider than the sheet's
/// element: the force of a box's corner does not depend on the size of the box. Springs are softer where the
/// lightest vertex of a pair has less than a third of the mean mass of its vertices, in proportion to this
/// mass: narrow faces, which cracks leave, would otherwise vibrate far faster than others.
class ContactSurface {
  public:
    /// The shell and the colliders' surfaces must outlive this object, which must be made again when the
    /// shell's vertices or triangles have changed. sheets_meet: whether elements of sheets collide with each
    /// other. springs: whether pairs are springs (see Barrier), which may be compressed until the middle
    /// surfaces touch.
    explicit ContactSurface(const Shell& shell, const std::vector<ContactCollider>& colliders = {},
                            bool sheets_meet = true, bool springs = false);

    Index collider_vertices() const { return static_cast<Index>(collider.size()); }
    Index vertices() const { return collider_vertices() + static_cast<Index>(in_exempt_pair.size()); }
    bool of_collider(Index vertex) const { return vertex < collider_vertices(); }
    /// Number of the collider to which `vertex`, a vertex of colliders, belongs.
    Index collider_number(Index vertex) const { return collider[vertex]; }
    bool sheets_meet() const { return sheets; }
    bool has_springs() const { return springs; }

    // Elements of the sheets:
    const std::vector<std::array<Index, 3>>& triangles() const { return triangle; }
    const std::vector<std::array<Index, 2>>& edges() const { return edge; }  ///< ascending
    /// Exempt pairs of vertices: the two vertices coincide at a crack, or faces at them have crossed each
    /// other since the start of the simulation. Each pair is listed in both orders of its vertices;
    /// ascending.
    const std::vector<std::array<Index, 2>>& exempt_pairs() const { return exempt_pair; }
    /// Whether the elements with `vertex`, a vertex of sheets, have been exempt from contact with the surface
    /// of collider number `of_collider` since the start of the simulation.
    bool is_surface_exempt(std::size_t of_collider, Index vertex) const {
        return !surface_exempt.empty() && surface_exempt[of_collider][of_sheet(vertex)] != 0;
    }
    std::size_t collider_count() const { return colliders.size(); }
    /// Pairs of vertices of sheets whose elements have had a reduced activation distance since the start of
    /// the simulation (see Shell::near). Each pair is listed in both orders of its vertices; ascending.
    const std::vector<NearVertices>& near_vertices() const { return near; }
    // Elements of the colliders, one collider after the other:
    const std::vector<std::array<Index, 3>>& collider_triangles() const { return collider_triangle; }
    const std::vector<std::array<Index, 2>>& collider_edges() const { return collider_edge; }  ///< ascending
    /// Numbers of the first vertex, edge and triangle of a collider.
    struct Start {
        Index vertex, edge, triangle;
    };
    /// Start of each collider, followed by the end of the last collider.
    const std::vector<Start>& collider_starts() const { return start_of; }

    double half_thickness(Index vertex) const {
        return of_collider(vertex) ? 0 : 0.5 * shell->thickness[of_sheet(vertex)];
    }
    /// Upper bound, m, on half the thickness of the elements that contain `vertex`, a vertex of sheets.
    double largest_half_thickness(Index vertex) const {
        return largest_half.empty() ? half_thickness(vertex) : largest_half[of_sheet(vertex)];
    }

    // The following functions take two elements, given by their vertices in the order of PairPositions, with
    // the ends of edges in the order of edges() and collider_edges():

    /// Whether the elements are exempt from contact: if they share a vertex, if a vertex of the first and a
    /// vertex of the second are an exempt pair, or if one element is of a collider and a vertex of the other
    /// is in ContactCollider::around or is_surface_exempt().
    bool apart(PairKind kind, const std::array<Index, 4>& vertices) const;
    /// Half the sum of the elements' thicknesses, m.
    double thickness(PairKind kind, const std::array<Index, 4>& vertices) const;
    /// The activation distance, m. It is at most NearVertices::reach of each pair of the elements' vertices
    /// that is in near_vertices().
    double activation_distance(PairKind kind, const std::array<Index, 4>& vertices) const;
    /// The minimum distance, m, that the pair has as a barrier, or would have if it is a spring.
    double minimum_of_barrier(const ContactPair& pair) const {
        return closest_of_barrier(pair.kind, pair.vertices) * pair.activation_distance;
    }
    /// Returns the pair of the elements without stiffness and mollifier, which stiffen() adds.
    ContactPair bare_pair(PairKind kind, const std::array<Index, 4>& vertices,
                          double activation_distance) const;
    /// Sets the stiffness and the mollifier of a pair.
    void stiffen(ContactPair& pair) const;
    /// The collider to which an element belongs; null if both elements are of sheets.
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
    /// The minimum distance of a barrier over its activation distance.
    double closest_of_barrier(PairKind kind, const std::array<Index, 4>& vertices) const;
    bool joined(Index a, Index b) const;   ///< whether two vertices of sheets are equal or an exempt pair
    double reach(Index a, Index b) const;  ///< m, NearVertices::reach; infinite if there is none
    /// Half the thickness of each of the two elements, m.
    std::array<double, 2> half_thicknesses(PairKind kind, const std::array<Index, 4>& vertices) const;
    /// Width of the edge from a to b, m.
    double edge_width(Index a, Index b) const;
    double rest_length(Index a, Index b) const;
    double footprint(Index vertex) const;
    /// The contact area of a pair of sheets' elements, m^2.
    double area(PairKind kind, const std::array<Index, 4>& vertices) const;
    /// The contact area of a pair with a collider, m^2.
    double area_on_collider(PairKind kind, const std::array<Index, 4>& vertices) const;
    /// Compliance times area of the materials between the middle surfaces, m/Pa.
    double column(PairKind kind, const std::array<Index, 4>& vertices) const;
    /// Factor, at most 1, of the stiffness of a spring: less than 1 where a vertex is much lighter than the
    /// pair's other vertices.
    double softness(const std::array<Index, 4>& vertices) const;
    void add_colliders();
    void add_sheet_edges();
    void find_largest_thicknesses();

    const Shell* shell;
    std::vector<ContactCollider> colliders;
    bool sheets, springs;
    std::vector<Index> collider;  ///< number of the collider of each vertex of colliders
    std::vector<Start> start_of;  ///< see collider_starts()
    std::vector<std::array<Index, 3>> triangle, collider_triangle;
    std::vector<std::array<Index, 2>> edge, collider_edge, exempt_pair;
    std::vector<double> width, collider_width;  ///< m, width of each edge
    std::vector<double> largest_half;           ///< m, of each vertex of sheets; empty: even thickness
    /// For each collider, is_surface_exempt() of each vertex of sheets; empty: there are no exemptions.
    std::vector<std::vector<char>> surface_exempt;
    std::vector<NearVertices> near;
    std::vector<char> in_exempt_pair, is_near;  ///< flags of each vertex of sheets
};

}  // namespace sherd
