// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "core/state_visitor.h"
#include "fracture/cracks/crack_nucleation.h"
#include "fracture/cracks/tip_energy.h"
#include "fracture/record/events.h"

namespace sherd {

/// The state that cracks are evaluated in: a solution of the sheets in a step from `begin` to `end` (s).
struct CrackEvaluation {
    const FaceStrains& strains;
    const HingeMeasures& measures;
    double begin, end;
    double waited;  ///< s, time since the last evaluation that counts towards nucleation
    /// Empty where tips are evaluated by stress: see load_by_stress().
    std::optional<Equilibrium> equilibrium;
    /// Whether a cohesive force still holds a failed edge.
    std::function<bool(Index edge)> is_opening;
};

/// An edge by which a crack nucleates or propagates.
struct CrackStep {
    std::optional<std::size_t> tip;   ///< index into tips(); none: nucleation
    Edge edge = {};                   ///< invalid: to be inserted along the ray
    Vector3d ray = Vector3d::Zero();  ///< unit vector from the tip's vertex
    GrowingTip next = {};             ///< the tip after this step
    bool is_branch = false;           ///< whether this is the second branch of the tip, with a new tip
};

/// The cracks of sheets that have a toughness: where they nucleate (CrackNucleation) and propagate.
///
/// A tip propagates where its stress intensity exceeds the toughness, by the energy that it releases
/// (TipEnergy) or by the stress ahead of it (load_by_stress()); not faster than the speed limit, not before
/// the edge behind it has opened, and in two directions where it branches (branches()). It follows an edge
/// that is inserted along its path, or the edge nearest to the path (CrackPath), and remembers by how much an
/// edge misses the path.
class CrackGrowth {
  public:
    /// The shell must outlive this object. timeless: whether cracks take no time, as in statics.
    CrackGrowth(const BreakableShell& shell, MembraneModel membrane, bool timeless);

    /// Whether a sheet has a toughness.
    bool needed() const { return is_needed; }

    /// The next edges of all cracks: at most one nucleation, and one edge for each tip, or two where it
    /// branches. Tips that meet may have the same edge.
    std::vector<CrackStep> next(const CrackEvaluation& now);
    /// Enters the edge that has been inserted for `step`, in a time step that began at `begin` (s). Returns
    /// false if its tip cannot propagate along it.
    bool take(const BreakableShell::Advanced& made, double begin, CrackStep& step) const;
    /// Must be called when the edges of these steps have failed, and the mesh has opened, at the end of a
    /// step (s).
    void done(std::span<const CrackStep> steps, double end);
    /// Must be called when the mesh has changed otherwise.
    void mesh_changed() {
        if (is_needed) energy.mesh_changed(all);
    }

    const std::vector<GrowingTip>& tips() const { return all; }
    /// Records of the tips whose load is not negligible, as of their last evaluation, without step and time.
    /// x: [3, V] m.
    std::vector<TipRecord> records(const Positions& x, double time) const;
    /// The energy of tips is not stored: it follows from the mesh.
    void visit_state(StateVisitor& visit) {
        auto& [shell, timeless, is_needed, nucleation, energy, all, evaluated, numbers] = *this;
        visit(nucleation, all, evaluated, numbers);
        if (visit.reads()) mesh_changed();
    }

  private:
    /// A tip at its last evaluation.
    struct EvaluatedTip {
        Index number;  ///< GrowingTip::number
        TipLoad load;
        double ratio;   ///< intensity over toughness
        bool is_ready;  ///< whether it may propagate
    };
    struct Overloaded {
        std::size_t tip;
        double ratio;  ///< intensity over toughness
        Vector3d direction;
    };
    TipLoad load(const GrowingTip& tip, const CrackEvaluation& now);
    void evaluate_tips(const CrackEvaluation& now);
    /// Intensity over toughness of a tip that may propagate, the root mean square with that of a near branch;
    /// else 0.
    double joint_ratio(std::size_t tip) const;
    /// The tips that propagate, the most overloaded first, without those near to a more overloaded one.
    std::vector<Overloaded> overloaded() const;
    /// The directions in which a tip propagates at `end` (s): two where it branches. Branching starts a path
    /// for each branch and resets the mean release.
    std::vector<Vector3d> directions_of(const Overloaded& one, double end);
    /// The step of a tip that propagates, as its sheet's CrackPath says.
    std::optional<CrackStep> step_of(const Overloaded& one, double begin) const;
    /// The step along the edge nearest to the path of a tip; nothing where there is none.
    std::optional<CrackStep> along_edges(const Overloaded& one, double begin) const;
    CrackStep along_ray(const Overloaded& one) const;
    /// The tip after it has propagated in `direction` along `edge`, whose other end is `to`.
    GrowingTip moved(const GrowingTip& tip, const Vector3d& direction, Edge edge, Index to,
                     double begin) const;
    void add_tip(Vertex vertex, const Vector3d& direction, Edge behind, double ready);
    /// Adds the second branch of a tip.
    void add_branch(GrowingTip tip);
    /// Adds the tips of existing cracks, each directed away from its crack.
    void find_tips();

    const BreakableShell& shell;
    bool timeless, is_needed = false;
    CrackNucleation nucleation;
    TipEnergy energy;
    std::vector<GrowingTip> all;
    std::vector<EvaluatedTip> evaluated;
    Index numbers = 0;  ///< count of all tips so far
};

}  // namespace sherd
