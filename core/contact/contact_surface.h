// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/contact/contact_pair.h"
#include "core/sheet.h"

namespace sherd {

/// What of a sheet touches: its triangles, its edges, and how stiff and how thick they are.
///
/// Two elements push when their middle surfaces are closer than half the sum of the thicknesses. Elements of
/// one sheet that are closer than that at rest (its own edges may be shorter than it is thick) push from
/// three quarters of their distance at rest on, so that the rest shape is free of contact forces.
///
/// Stiffness is that of a column of sheet, half of each thickness high, of the two materials in series:
/// k = area / (t_a / (2 Y_a) + t_b / (2 Y_b)). The area of a vertex is its footprint; that of two edges pi/2
/// times their widths, where an edge is as wide as its share of the sheet's area over its length, and by a
/// thickness wider on the rim: summed over the crossings of two meshes that lie on each other at random
/// angles, that is the area covered. Each of the three ways in which two sheets touch (vertices of one,
/// vertices of the other, edges) gets half a column.
class ContactSurface {
  public:
    /// The sheet must outlive it; to be made anew when its vertices or triangles have changed.
    explicit ContactSurface(const Sheet& sheet);

    const std::vector<std::array<Index, 3>>& triangles() const { return triangle; }
    const std::vector<std::array<Index, 2>>& edges() const { return edge; }  ///< ascending
    /// Both ways round, ascending.
    const std::vector<std::array<Index, 2>>& twins() const { return twin; }
    Index vertices() const { return static_cast<Index>(has_twin.size()); }
    double half_thickness(Index vertex) const { return 0.5 * sheet->thickness[vertex]; }

    // Of two elements, given by their vertices in the order of PairPositions, edges in that of edges():

    /// Whether they never touch: they share a vertex, or have twins.
    bool apart(PairKind kind, const std::array<Index, 4>& vertices) const;
    /// Half the sum of their thicknesses, m.
    double thickness(PairKind kind, const std::array<Index, 4>& vertices) const;
    /// The distance from which on they push, m.
    double touching(PairKind kind, const std::array<Index, 4>& vertices) const;
    ContactPair pair(PairKind kind, const std::array<Index, 4>& vertices, double touching) const;

  private:
    bool joined(Index a, Index b) const;  ///< the same vertex, or twins
    double edge_width(Index a, Index b) const;
    double rest_length(Index a, Index b) const { return (sheet->rest.col(a) - sheet->rest.col(b)).norm(); }

    const Sheet* sheet;
    std::vector<std::array<Index, 3>> triangle;
    std::vector<std::array<Index, 2>> edge, twin;
    std::vector<double> width;   ///< of each edge, m
    std::vector<char> has_twin;  ///< of each vertex
};

}  // namespace sherd
