// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/contact/colliders/touch.h"
#include "core/contact/contact_options.h"
#include "core/contact/crack_faces/crack_face.h"
#include "core/contact/explicit/explicit_bodies.h"
#include "core/contact/penalty/vertex_contact.h"
#include "core/contact/sheets/sheet_contact.h"
#include "core/state_visitor.h"

namespace sherd {

/// All contact of a run in explicit steps. Springs at vertices and at crack faces, and the
/// stiffness of columns of a sheet, are those of implicit steps (Contact), but pairs of elements are springs,
/// too, and friction is a force at the present velocity that never reverses the sliding.
class ExplicitContact {
  public:
    /// The shell must outlive this object. gravity: m/s^2, acts on the bodies.
    ExplicitContact(const Shell& shell, ContactOptions options, const ContactStart& start,
                    const Vector3d& gravity, const Threads& threads);
    ExplicitContact(const ExplicitContact&) = delete;  // parts refer to its obstacles

    /// Begins a step at `time` (s); first: whether it is the first of this object.
    void begin(double time, bool first);
    /// Moves the obstacles to their poses at `time` (s); `before`: s, of their last poses.
    void place(double before, double time);
    void shell_changed(const ShellChange& change);
    /// Computes the forces at the end of a substep, with the obstacles at their last poses.
    void find_forces(const Substep& substep, ContactForces& forces);
    /// Elastic energy, J, of all contacts with the shell at x.
    double stored_energy(const Positions& x) const;
    /// An upper bound of the square of the frequencies, 1/s^2, that contact may add to those of the shell in
    /// a step in which it moves by `motion` [3, V] m.
    double largest_rate(const StepContext& step, const Positions& motion);
    /// Ends a step with the shell at `end` [3, V] m. Returns false if a sheet passes through another one, or
    /// through the surface of an obstacle or a body, in the straight motion from its origin: springs have
    /// become firmer, and the step must be repeated. Throws std::runtime_error if springs cannot become
    /// firmer, as always with ContactOptions::barriers_follow, or if with it a pair is too near for a
    /// barrier.
    bool end(const StepContext& step, const Positions& end);
    /// Throws std::runtime_error: something has passed through the springs of contact.
    [[noreturn]] static void refuse_passage();
    /// Work, J, of the obstacles, which move and deform as prescribed, in the substep of the last place().
    /// forces, on_deforming: means over the substep of the obstacles' forces, and of those on the vertices of
    /// deforming ones (ContactForces).
    double obstacle_work(std::span<const Reaction> forces, const Positions& on_deforming) const;

    ExplicitBodies& of_bodies() { return bodies; }
    const ExplicitBodies& of_bodies() const { return bodies; }
    Touch touch(const Positions& x) const;
    Positions crack_face_forces(const Positions& x) const;  ///< N, [3, V]
    double crack_face_overlap(const Positions& x) const { return crack_faces.largest_overlap(x); }  ///< m
    void visit_state(StateVisitor& visit) {
        auto& [options, shell, threads, bodies, at_vertices, substep, before, now, sheets, crack_faces,
               second_spring] = *this;
        visit(bodies, at_vertices, substep, before, now, sheets, crack_faces, second_spring);
    }

  private:
    bool passes(const StepContext& step, const Positions& end);
    bool allows_barriers(const Positions& end) const;
    void set_second_spring(SecondSpring of_pairs);
    /// Makes the second springs (SecondSpring) stiffer, in a range that no pair has entered at the beginning
    /// of the step. Returns false if there is none, or if they are as stiff as they may be.
    bool stiffen_springs(const StepContext& step);
    /// Removes the second springs if no pair at the end of the step is in their range.
    void relax(const Positions& end);
    void add_obstacles(const Substep& substep, ContactForces& sum) const;
    void add_sheets(const Substep& substep, ContactForces& sum) const;
    // all: positions of colliders and sheets at the end of the substep.
    void add_sheet_friction(const Substep& substep, const Positions& all, ContactForces& sum) const;
    /// Friction, N, on the vertices of a pair.
    PairPositions friction_of(const ContactPair& pair, const Substep& substep, const Positions& all) const;

    const ContactOptions options;
    const Shell& shell;
    Threads threads;
    ExplicitBodies bodies;
    std::vector<VertexContact> at_vertices;      ///< contact of vertices with each obstacle
    StepContext substep;                         ///< from the obstacles' last poses to their present ones
    std::vector<Eigen::Isometry3d> before, now;  ///< poses of the obstacles at its beginning and its end
    std::unique_ptr<SheetContact> sheets;        ///< null if no surfaces collide
    CrackFaceContact crack_faces;
    SecondSpring second_spring;  ///< second spring of all pairs
};

}  // namespace sherd
