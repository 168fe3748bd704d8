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

/// All contact of a run in explicit steps. Springs at vertices and at crack faces, and the stiffness of pairs
/// of elements, are as in implicit steps (Contact). But pairs of elements are springs instead of barriers,
/// and friction is a force that follows from the present velocity and never reverses the sliding.
class ExplicitContact {
  public:
    /// The shell must outlive this object. gravity: m/s^2, acts on the bodies.
    ExplicitContact(const Shell& shell, ContactOptions options, const ContactStart& start,
                    const Vector3d& gravity, const Threads& threads);
    ExplicitContact(const ExplicitContact&) = delete;  // members hold references to its obstacles

    /// Begins a step at `time` (s); first: whether the step is the first of this object.
    void begin(double time, bool first);
    /// Begins a substep: moves the obstacles from their poses at the time `before` (s) to their poses at
    /// `time` (s).
    void place(double before, double time);
    void shell_changed(const ShellChange& change);
    /// Computes the forces at the end of a substep, with the obstacles where place() has moved them.
    void find_forces(const Substep& substep, ContactForces& forces);
    /// Elastic energy, J, of all contacts, with the shell at x, [3, V] m.
    double stored_energy(const Positions& x) const;
    /// Finds the vertices, pairs of elements and crack faces that may touch something in the step, and bounds
    /// on the frequencies of their contact. Until the next call of this function or of shell_changed(),
    /// find_forces() looks at these alone.
    ContactRates look_ahead(const StepContext& step);
    /// The vertices on which find_forces() lets forces act, ascending.
    std::span<const Index> vertices() const { return followed; }
    /// Ends a step with the shell at `end`, [3, V] m. If a sheet passes through another one, or through the
    /// surface of an obstacle or a body, in the straight motion from the step's origin, makes springs stiffer
    /// and returns false: the step must be repeated. Throws std::runtime_error if springs cannot become
    /// stiffer, as always with ContactOptions::barriers_follow. With barriers_follow, also throws if a pair
    /// is too near for a barrier.
    bool end(const StepContext& step, const Positions& end);
    /// Throws std::runtime_error with the message that a sheet, an obstacle or a body has passed through a
    /// sheet against the springs of contact.
    [[noreturn]] static void refuse_passage();
    /// Work, J, of the obstacles, which move and deform as prescribed, in the substep of the last place().
    /// forces, on_deforming: means over the substep of ContactForces::obstacles and ContactForces::deforming.
    double obstacle_work(std::span<const Reaction> forces, const Positions& on_deforming) const;

    ExplicitBodies& of_bodies() { return bodies; }
    const ExplicitBodies& of_bodies() const { return bodies; }
    Touch touch(const Positions& x) const;
    Positions crack_face_forces(const Positions& x) const;  ///< N, [3, V], between crack faces
    double crack_face_overlap(const Positions& x) const { return crack_faces.largest_overlap(x); }  ///< m
    void visit_state(StateVisitor& visit) {
        auto& [options, shell, threads, bodies, at_vertices, substep, before, now, sheets, crack_faces,
               second_spring, gravity, everywhere, followed, pairs, near_faces, active] = *this;
        visit(bodies, at_vertices, substep, before, now, sheets, crack_faces, second_spring, everywhere,
              followed, pairs, near_faces);
    }

  private:
    bool passes(const StepContext& step, const Positions& end);
    bool allows_barriers(const Positions& end) const;
    void set_second_spring(SecondSpring of_pairs);
    /// Makes the second springs (SecondSpring) stiffer, and chooses a range for them that contains no pair at
    /// the beginning of the step. Returns false if there is no such range, or if the second springs already
    /// have their largest stiffness.
    bool stiffen_springs(const StepContext& step);
    /// Removes the second springs if no pair at the end of the step is in their range.
    void relax(const Positions& end);
    void look_everywhere();
    void add_obstacles(const Substep& substep, ContactForces& sum) const;
    void add_sheets(const Substep& substep, ContactForces& sum);
    void add_crack_faces(const Positions& x, ContactForces& sum) const;
    /// The shell's displacements in the step, m, [3, V], with a margin for accelerations.
    Positions motion_ahead(const StepContext& step) const;
    void add_rates_of_obstacles(const StepContext& step, double way, ContactRates& sum) const;
    /// Finds `pairs` and adds their rates.
    void look_at_pairs(const StepContext& step, const Positions& motion, ContactRates& sum);
    /// Finds `near_faces` and adds their rates.
    void look_at_crack_faces(const StepContext& step, const Positions& motion, ContactRates& sum);
    // In the next two functions, all: [3, S + V] m, positions of colliders and sheets at the end of the
    // substep.
    void add_sheet_friction(const Substep& substep, const Positions& all, ContactForces& sum) const;
    /// Friction, N, on the vertices of a pair.
    PairPositions friction_of(const ContactPair& pair, const Substep& substep, const Positions& all) const;

    const ContactOptions options;
    const Shell& shell;
    Threads threads;
    ExplicitBodies bodies;
    std::vector<VertexContact> at_vertices;  ///< for each obstacle, contact of the shell's vertices with it
    StepContext substep;                     ///< begin and length are set by the last place()
    /// Poses of the obstacles at the beginning and at the end of `substep`.
    std::vector<Eigen::Isometry3d> before, now;
    /// Null if sheets do not collide with each other and no obstacle has a surface.
    std::unique_ptr<SheetContact> sheets;
    CrackFaceContact crack_faces;
    SecondSpring second_spring;  ///< second spring of all pairs
    const Vector3d gravity;      ///< m/s^2
    bool everywhere = true;      ///< whether find_forces() looks at everything
    // Results of the last look_ahead(): vertices(), and pairs and crack faces that may touch.
    std::vector<Index> followed;
    std::vector<ContactPair> pairs;
    std::vector<CrackFaceStencil> near_faces;
    std::vector<ContactPair> active;  ///< pairs that are active in the substep: a buffer
};

}  // namespace sherd
