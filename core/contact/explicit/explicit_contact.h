// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/contact/colliders/touch.h"
#include "core/contact/contact_options.h"
#include "core/contact/explicit/explicit_bodies.h"
#include "core/contact/lips/lip.h"
#include "core/contact/penalty/vertex_contact.h"
#include "core/contact/sheets/sheet_contact.h"
#include "core/state_visitor.h"

namespace sherd {

/// All contact of a run in explicit steps: the same springs at vertices, columns of sheet and lips as in
/// implicit ones (Contact), but pairs of elements are springs, too, and friction is a force at the present
/// velocity that never turns the sliding round.
class ExplicitContact {
  public:
    /// The shell must outlive this object. gravity: m/s^2, acts on the bodies.
    ExplicitContact(const Shell& shell, ContactOptions options, const Vector3d& gravity,
                    const Threads& threads = Threads());
    ExplicitContact(const ExplicitContact&) = delete;  // its parts refer to its obstacles

    /// Begins a step at `time` (s); first: of this object.
    void begin(double time, bool first);
    /// Puts the obstacles where they are at `time` (s); `before`: where they were until then.
    void place(double before, double time);
    void shell_changed(const ShellChange& change);
    /// Finds the forces at the end of a substep, where the obstacles are.
    void find_forces(const Substep& substep, ContactForces& forces);
    /// Stored in all contacts with the shell at x, J.
    double stored_energy(const Positions& x) const;
    /// An upper bound of the square of the frequencies, 1/s^2, that contact may add to those of the shell in
    /// a step in which it moves by `motion` [3, V] m.
    double largest_rate(const StepContext& step, const Positions& motion);
    /// Ends a step with the shell at `end` [3, V] m. Returns false if a sheet passes through another one, or
    /// through the surface of an obstacle or a body, in the straight motion from its origin: springs have
    /// become firmer, and the step must be made again. Throws std::runtime_error if they cannot be firmer, or
    /// the sheet is too deep for ContactOptions::barriers_follow.
    bool end(const StepContext& step, const Positions& end);
    /// Throws std::runtime_error that says that springs are overwhelmed.
    [[noreturn]] static void refuse_passage();
    /// Work, J, of the obstacles that move as they are told, in the substep that placed them last; forces and
    /// those on the vertices of what deforms (ContactForces): the mean over the substep.
    double obstacle_work(std::span<const Reaction> forces, const Positions& on_deforming) const;

    ExplicitBodies& of_bodies() { return bodies; }
    const ExplicitBodies& of_bodies() const { return bodies; }
    Touch touch(const Positions& x) const;
    Positions lip_forces(const Positions& x) const;                                   ///< N, [3, V]
    double lip_overlap(const Positions& x) const { return lips.largest_overlap(x); }  ///< m
    void visit_state(StateVisitor& visit) {
        auto& [options, shell, threads, bodies, at_vertices, substep, before, now, sheets, lips, firmness] =
            *this;
        visit(bodies, at_vertices, substep, before, now, sheets, lips, firmness);
    }

  private:
    bool passes(const StepContext& step, const Positions& end);
    bool leaves_room_for_barriers(const Positions& end) const;
    void set_firmness(Firmness of_pairs);
    /// Makes springs firmer where no pair is yet that deep at the beginning of the step; false if that cannot
    /// be.
    bool become_firmer(const StepContext& step);
    /// Takes firm springs away that nothing presses.
    void relax(const Positions& end);
    void add_obstacles(const Substep& substep, ContactForces& sum) const;
    void add_sheets(const Substep& substep, ContactForces& sum) const;
    // all: positions of colliders and sheets at the end of the substep.
    void add_sheet_friction(const Substep& substep, const Positions& all, ContactForces& sum) const;
    /// On the vertices of a pair, N.
    PairPositions friction_of(const ContactPair& pair, const Substep& substep, const Positions& all) const;

    ContactOptions options;
    const Shell& shell;
    Threads threads;
    ExplicitBodies bodies;
    std::vector<VertexContact> at_vertices;      ///< of each obstacle
    StepContext substep;                         ///< in which the obstacles were placed last
    std::vector<Eigen::Isometry3d> before, now;  ///< of each obstacle, at its beginning and at its end
    std::unique_ptr<SheetContact> sheets;        ///< null where no surfaces meet
    LipContact lips;
    Firmness firmness;  ///< all pairs have this one
};

}  // namespace sherd
