// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "core/state_visitor.h"
#include "fracture/crack_birth.h"
#include "fracture/events.h"
#include "fracture/tip_energy.h"

namespace sherd {

/// What cracks are judged by: a solution of the sheets in a step that lasts from `begin` to `end` s.
struct Judged {
    const FaceStrains& strains;
    const HingeMeasures& measures;
    double begin, end;
    double waited;  ///< s, by which births have come nearer since the last time
    /// Nothing where tips are judged by stress: see load_by_stress().
    std::optional<Equilibrium> equilibrium;
    /// Whether an edge that has failed is still held by what has not faded yet.
    std::function<bool(Index edge)> is_opening;
};

/// One edge by which a crack is born, or goes on.
struct CrackStep {
    std::optional<std::size_t> tip;   ///< which of tips() goes on; none: a birth
    Edge edge = {};                   ///< none yet: it is to be made, along the ray
    Vector3d ray = Vector3d::Zero();  ///< unit vector from the tip's vertex
    GrowingTip next = {};             ///< what becomes of the tip
    bool is_branch = false;           ///< it leaves the tip beside another edge, as a new tip
};

/// The cracks of sheets that have a toughness: where they are born (CrackBirth), and where they go on.
///
/// A tip goes on where its intensity is over the toughness, by the energy that it releases (TipEnergy) or by
/// the stress ahead of it (load_by_stress()); at most so fast as the speed limit says, and not before the
/// edge behind it has opened; in two ways where it branches (branches()). It takes an edge that is made along
/// its path, or the one that is nearest to it (CrackPath), and keeps in mind by how much an edge misses the
/// path.
class CrackGrowth {
  public:
    /// The shell must outlive this object. timeless: in statics, where nothing takes time.
    CrackGrowth(const BreakableShell& shell, MembraneModel membrane, bool timeless);

    /// Whether a sheet has a toughness.
    bool needed() const { return is_needed; }

    /// What cracks do next: at most one birth, and one edge for each tip, or two. Tips that meet may have the
    /// same.
    std::vector<CrackStep> next(const Judged& now);
    /// Lets a step take the edge that has been made for it, in a time step that began at `begin` (s). Returns
    /// false if its tip cannot go there.
    bool take(const BreakableShell::Advanced& made, double begin, CrackStep& step) const;
    /// Must be called when the edges of these steps have failed, and the mesh has opened, at the end of a
    /// step (s).
    void done(std::span<const CrackStep> steps, double end);
    /// Must be called when the mesh has changed otherwise.
    void mesh_changed() {
        if (is_needed) energy.mesh_changed(all);
    }

    const std::vector<GrowingTip>& tips() const { return all; }
    /// The tips that bear something worth a record, as they were judged last, without step and time; x: [3,
    /// V] m.
    std::vector<TipRecord> records(const Positions& x, double time) const;
    /// What is known of the energy of tips follows from the mesh.
    void visit_state(StateVisitor& visit) {
        auto& [shell, timeless, is_needed, birth, energy, all, judged, numbers] = *this;
        visit(birth, all, judged, numbers);
        if (visit.reads()) mesh_changed();
    }

  private:
    /// A tip as it was judged last.
    struct JudgedTip {
        Index number;  ///< GrowingTip::number
        TipLoad load;
        double ratio;   ///< intensity over toughness
        bool is_ready;  ///< whether it may go on
    };
    struct Overloaded {
        std::size_t tip;
        double ratio;  ///< intensity over toughness
        Vector3d direction;
    };
    TipLoad load(const GrowingTip& tip, const Judged& now);
    void judge_tips(const Judged& now);
    /// Intensity over toughness of a tip that may go on, with that of a near twin; else 0.
    double joint_ratio(std::size_t tip) const;
    /// The tips that go on, the most overloaded first, without those that another one of them is near to.
    std::vector<Overloaded> overloaded() const;
    /// The directions in which a tip goes on at `end` (s): two, where it branches, which begins a path of its
    /// own for each and forgets what has fed it.
    std::vector<Vector3d> ways_of(const Overloaded& one, double end);
    /// The edge by which a tip goes on, as its sheet's CrackPath says.
    std::optional<CrackStep> step_of(const Overloaded& one, double begin) const;
    /// The edge nearest to the path of a tip that goes on in a direction; nothing where there is none.
    std::optional<CrackStep> along_edges(const Overloaded& one, double begin) const;
    CrackStep along_ray(const Overloaded& one) const;
    /// What becomes of a tip that goes on in a direction, by an edge with this other end.
    GrowingTip moved(const GrowingTip& tip, const Vector3d& direction, Edge edge, Index to,
                     double begin) const;
    void add_tip(Vertex vertex, const Vector3d& direction, Edge behind, double ready);
    /// Adds what became of a tip beside its other branch.
    void add_branch(GrowingTip tip);
    /// The tips of the cracks that there are, each away from its crack.
    void find_tips();

    const BreakableShell& shell;
    bool timeless, is_needed = false;
    CrackBirth birth;
    TipEnergy energy;
    std::vector<GrowingTip> all;
    std::vector<JudgedTip> judged;
    Index numbers = 0;  ///< of tips that there have been
};

}  // namespace sherd
