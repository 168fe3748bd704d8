// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "core/state_visitor.h"
#include "fracture/cracks/crack_nucleation.h"
#include "fracture/cracks/tip_energy.h"
#include "fracture/record/events.h"

namespace sherd {

/// State in which cracks are evaluated: a solution of the sheets in a time step.
struct CrackEvaluation {
    const FaceStrains& strains;
    const HingeMeasures& measures;
    double begin, end;  ///< s, beginning and end of the time step
    double waited;      ///< s, time for which this state counts in nucleation and in means; 0 if the step was
                        ///< evaluated before
    /// State from which the loads on tips are computed by energy; if empty, they are computed by stress: see
    /// load_by_stress().
    std::optional<Equilibrium> equilibrium;
    /// Returns whether a cohesive force still acts on a failed edge.
    std::function<bool(Index edge)> is_opening;
};

/// An edge by which a crack nucleates or propagates.
struct CrackStep {
    std::optional<std::size_t> tip;   ///< index into tips(); none: nucleation
    Edge edge = {};                   ///< edge that fails; invalid: it must be inserted along the ray first
    Vector3d ray = Vector3d::Zero();  ///< unit vector of the ray, which begins at the tip's vertex
    GrowingTip next = {};             ///< the tip after this step
    bool is_branch = false;           ///< whether this step makes the second branch of the tip, a new tip
};

/// The cracks of sheets that have a toughness: where they nucleate (CrackNucleation) and propagate.
///
/// A tip propagates where its stress intensity exceeds the toughness. The intensity follows from the energy
/// that the tip releases (TipEnergy) or from the stress ahead of it (load_by_stress()). A tip does not
/// propagate faster than the speed limit, nor before the edge behind it has opened; where it branches
/// (branches()), it propagates in two directions. It advances along an edge that is inserted on its path, or
/// along the existing edge nearest to the path (CrackPath), and stores where the exact path is beside its
/// vertex (GrowingTip::on_path).
class CrackGrowth {
  public:
    /// The shell must outlive this object. timeless: whether cracks propagate in no time, as in statics.
    CrackGrowth(const BreakableShell& shell, MembraneModel membrane, bool timeless);

    /// Whether a sheet has a toughness.
    bool needed() const { return is_needed; }

    /// Returns the next edges of all cracks: at most one nucleation, one edge for each tip that propagates,
    /// and two for a tip that branches. Tips that meet may get the same edge.
    std::vector<CrackStep> next(const CrackEvaluation& now);
    /// Completes `step` with the edge `made`, which has been inserted along its ray in a time step that began
    /// at `begin` (s). Returns false if the tip cannot propagate along this edge.
    bool take(const BreakableShell::Advanced& made, double begin, CrackStep& step) const;
    /// Must be called when the edges of these steps have failed and the mesh has opened. end: s, end of the
    /// time step.
    void done(std::span<const CrackStep> steps, double end);
    /// Must be called when the mesh has changed for another reason than the steps passed to done().
    void mesh_changed() {
        if (is_needed) energy.mesh_changed(all);
    }

    const std::vector<GrowingTip>& tips() const { return all; }
    /// Estimate of the time, s, that is left until a crack nucleates or propagates, by the state of the last
    /// next() and at `time` (s): 0 while a tip propagates, or bears at least half of what it resists; else
    /// CrackNucleation::time_left().
    double time_left(double time) const;
    /// Returns records of the tips whose load was not negligible when they were last evaluated.
    /// TipRecord::step and TipRecord::time are not set. x: [3, V] m, positions; time: s, for the speeds of
    /// tips.
    std::vector<TipRecord> records(const Positions& x, double time) const;
    /// Member `energy` is not stored: it follows from the mesh.
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
        bool is_ready;  ///< whether the tip may propagate now
    };
    struct Overloaded {
        std::size_t tip;
        double ratio;  ///< intensity over toughness
        Vector3d direction;
    };
    TipLoad load(const GrowingTip& tip, const CrackEvaluation& now);
    void evaluate_tips(const CrackEvaluation& now);
    /// Intensity over toughness of a tip; if a branch is near (near_branch()), the root mean square of both
    /// tips' ratios. Returns 0 if one of these tips may not propagate. tip: index into tips().
    double joint_ratio(std::size_t tip) const;
    /// The tips that propagate, the most overloaded first. A tip near a more overloaded one is left out,
    /// unless the two are branches of one tip.
    std::vector<Overloaded> overloaded() const;
    /// Returns the directions in which a tip propagates in a step that ends at `end` (s): two if it branches.
    /// Then a new path begins at the tip's vertex, and its mean release is reset.
    std::vector<Vector3d> directions_of(const Overloaded& one, double end);
    /// The step of a tip that propagates: along_edges() or along_ray(), by its sheet's CrackPath.
    std::optional<CrackStep> step_of(const Overloaded& one, double begin) const;
    /// The step along the edge nearest to the path of a tip; nothing if no edge leads ahead.
    std::optional<CrackStep> along_edges(const Overloaded& one, double begin) const;
    CrackStep along_ray(const Overloaded& one) const;
    /// The tip after it has propagated in `direction` along `edge`, whose other end is `to`, in a time step
    /// that began at `begin` (s).
    GrowingTip moved(const GrowingTip& tip, const Vector3d& direction, Edge edge, Index to,
                     double begin) const;
    void add_tip(Vertex vertex, const Vector3d& direction, Edge behind, double ready);
    /// Adds the second branch of a tip. tip: its state, with the number of the first branch.
    void add_branch(GrowingTip tip);
    /// Adds the tips of existing cracks, each directed away from its crack.
    void find_tips();

    const BreakableShell& shell;
    bool timeless, is_needed = false;
    CrackNucleation nucleation;
    TipEnergy energy;
    std::vector<GrowingTip> all;
    std::vector<EvaluatedTip> evaluated;
    Index numbers = 0;  ///< number of tips that have existed so far
};

}  // namespace sherd
