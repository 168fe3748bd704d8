// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fracture/hinge_measures.h"
#include "fracture/surface_stress.h"

namespace sherd {

/// A tip of a crack in a sheet that has a toughness. All of it is of the rest shape.
struct GrowingTip {
    Index vertex = 0;
    Vector3d on_path = Vector3d::Zero();     ///< m, the point of the true path that the vertex stands for
    Vector3d direction = Vector3d::UnitX();  ///< in which the crack came, a unit vector in the tangent plane
    double ready = 0;                        ///< s, before which the speed limit does not let it go on
};

/// What a tip bears.
struct TipLoad {
    double intensity = 0;  ///< K, Pa m^0.5: it goes on where this exceeds the toughness
    double angle = 0;      ///< rad, by which it then turns, counterclockwise against the normal
};

/// The cracks of sheets that have a toughness: where they are born, and where they go on.
///
/// Growth: the surface stress averaged over the faces ahead of a tip, with its mean s_m and half its
/// difference s_b across the crack, gives K = sqrt(max(s_m, 0)^2 + c s_b^2) sqrt(2 pi alpha h), with c = (1 +
/// nu) / (3 (3 + nu)) (energy release in bending, Hui and Zehnder 1993), h the length of the edges ahead and
/// alpha from measured tips. The tip turns to the largest hoop stress (Erdogan and Sih 1963) of the surface
/// that is pulled more, and goes along the edge nearest to its path, whose departure from the path it keeps
/// in mind; at most so fast as the speed limit says.
///
/// Birth: a hinge fails by its strength once it has been over it for as long as a crack needs through the
/// thickness, and none is born near a tip.
class CrackGrowth {
  public:
    /// The shell must outlive this object. timeless: in statics, where nothing takes time.
    CrackGrowth(const BreakableShell& shell, bool timeless);

    /// Whether a sheet has a toughness.
    bool needed() const { return is_needed; }

    /// The edges that fail now, at most one for each tip and one birth, ascending. strains: of the faces, in
    /// a step that lasts from `begin` to `end`; waited: s, by which births have come nearer since the last
    /// call.
    std::vector<Edge> failing_edges(const FaceStrains& strains, const HingeMeasures& measures, double begin,
                                    double end, double waited);
    /// Must be called when these edges have failed and the mesh has opened.
    void failed();

    const std::vector<GrowingTip>& tips() const { return all; }
    TipLoad load(const GrowingTip& tip, const FaceStrains& strains) const;

  private:
    struct Advance {
        std::size_t tip;
        Edge edge;
        GrowingTip next;
    };
    double edge_length_ahead(const GrowingTip& tip) const;
    bool can_fail(Edge edge) const;
    /// Along which edge a tip goes on that turns by an angle; no edge where there is none.
    std::optional<Advance> advance(std::size_t tip, double angle, double begin) const;
    void choose_advances(const FaceStrains& strains, double begin, double end);
    void choose_birth(const FaceStrains& strains, const HingeMeasures& measures, double end, double waited);
    /// What a hinge bears over its strength where a crack may be born: within a sheet the principal tension,
    /// since the crack may begin across it along another edge, and at lips and rims, or where strength has
    /// directions, the tension across the edge.
    double birth_ratio(const FaceStrains& strains, double across, Edge edge) const;
    bool near_a_tip(Edge edge) const;
    void add_tip(Vertex vertex, const Vector3d& direction, double time);
    /// The tips of the cracks that there are, each away from its crack.
    void find_tips();

    const BreakableShell& shell;
    bool timeless, is_needed = false;
    std::vector<GrowingTip> all;
    std::vector<double> exposure;  ///< [E] s, see choose_birth()
    std::vector<Advance> advances;
    std::optional<Edge> birth;
    double birth_time = 0;
};

}  // namespace sherd
