// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/contact/barrier/contact_pair.h"
#include "core/contact/geometry/solid_surface.h"
#include "core/shell/sheet.h"

namespace sherd {

/// A thing that sheets do not pass through, as contact of surfaces sees it.
struct ContactSolid {
    const SolidSurface* surface = nullptr;
    double young = 3e10;  ///< Pa
    double friction = 0;  ///< Coulomb coefficient
    std::vector<Index> around =
        {};  ///< ascending, vertices of sheets that are held inside: they do not meet it
};

/// What touches: triangles and edges of sheets and of solids, and how stiff and how thick they are. Vertices
/// are numbered in one row, those of the solids first, then those of the sheets.
///
/// Two elements push when their middle surfaces are closer than half the sum of the thicknesses. Elements of
/// one sheet that are closer than that at rest (its own edges may be shorter than it is thick) push from
/// three quarters of their distance at rest on, so that the rest shape is free of contact forces. A solid is
/// nothing but its surface, which a sheet touches at half its thickness, where the springs of ObstacleContact
/// begin; pairs with it push from half of that on, to keep apart what vertices and springs do not.
///
/// Stiffness is that of a column of sheet, half of each thickness high, of the two materials in series:
/// k = area / (t_a / (2 Y_a) + t_b / (2 Y_b)). The area of a vertex is its footprint; that of two edges pi/2
/// times their widths, where an edge is as wide as its share of the sheet's area over its length, and by a
/// thickness wider on the rim: summed over the crossings of two meshes that lie on each other at random
/// angles, that is the area covered. Each of the three ways in which two sheets touch (vertices of one,
/// vertices of the other, edges) gets half a column. Against a solid the column is the one of
/// column_stiffness(), and no element of the solid acts on more than the element of the sheet is wide: what
/// a corner of a large box presses on is not the size of the box.
class ContactSurface {
  public:
    /// Sheet and solids' surfaces must outlive it; to be made anew when the sheet's vertices or triangles
    /// have changed. sheets_meet: whether elements of sheets meet each other.
    explicit ContactSurface(const Sheet& sheet, const std::vector<ContactSolid>& solids = {},
                            bool sheets_meet = true);

    Index solid_vertices() const { return static_cast<Index>(solid.size()); }
    Index vertices() const { return solid_vertices() + static_cast<Index>(has_twin.size()); }
    bool of_solid(Index vertex) const { return vertex < solid_vertices(); }
    bool sheets_meet() const { return sheets; }

    // Of sheets:
    const std::vector<std::array<Index, 3>>& triangles() const { return triangle; }
    const std::vector<std::array<Index, 2>>& edges() const { return edge; }  ///< ascending
    /// Both ways round, ascending.
    const std::vector<std::array<Index, 2>>& twins() const { return twin; }
    // Of solids, those of each in one row:
    const std::vector<std::array<Index, 3>>& solid_triangles() const { return solid_triangle; }
    const std::vector<std::array<Index, 2>>& solid_edges() const { return solid_edge; }  ///< ascending
    /// Where the rows of each begin.
    struct Start {
        Index vertex, edge, triangle;
    };
    /// One more than there are solids: the last says where all end.
    const std::vector<Start>& solid_starts() const { return start_of; }

    double half_thickness(Index vertex) const {
        return of_solid(vertex) ? 0 : 0.5 * sheet->thickness[of_sheet(vertex)];
    }

    // Of two elements, given by their vertices in the order of PairPositions, edges in that of edges():

    /// Whether they never touch: they share a vertex, or have twins, or one is held inside the other.
    bool apart(PairKind kind, const std::array<Index, 4>& vertices) const;
    /// Half the sum of their thicknesses, m.
    double thickness(PairKind kind, const std::array<Index, 4>& vertices) const;
    /// The distance from which on they push, m.
    double touching(PairKind kind, const std::array<Index, 4>& vertices) const;
    ContactPair pair(PairKind kind, const std::array<Index, 4>& vertices, double touching) const;
    /// The solid that one of them is of; none: null.
    const ContactSolid* solid_of(PairKind kind, const std::array<Index, 4>& vertices) const;

  private:
    Index of_sheet(Index vertex) const { return vertex - solid_vertices(); }
    bool joined(Index a, Index b) const;  ///< the same vertex, or twins
    double edge_width(Index a, Index b) const;
    double rest_length(Index a, Index b) const;
    double footprint(Index vertex) const;
    /// m^2.
    double area(PairKind kind, const std::array<Index, 4>& vertices) const;
    double area_on_solid(PairKind kind, const std::array<Index, 4>& vertices) const;
    /// m/Pa, of the materials between the middle surfaces.
    double column(PairKind kind, const std::array<Index, 4>& vertices) const;
    void add_solids();
    void add_sheet_edges();

    const Sheet* sheet;
    std::vector<ContactSolid> solids;
    bool sheets;
    std::vector<Index> solid;     ///< of each vertex of solids
    std::vector<Start> start_of;  ///< each solid
    std::vector<std::array<Index, 3>> triangle, solid_triangle;
    std::vector<std::array<Index, 2>> edge, solid_edge, twin;
    std::vector<double> width, solid_width;  ///< of each edge, m
    std::vector<char> has_twin;              ///< of each vertex of sheets
};

}  // namespace sherd
