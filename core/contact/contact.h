// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/contact/bodies/body_contact.h"
#include "core/contact/contact_options.h"
#include "core/contact/crack_faces/crack_face.h"
#include "core/contact/penalty/obstacle_contact.h"
#include "core/contact/sheets/sheet_contact.h"
#include "core/contact/sheets/sheet_friction.h"
#include "core/energy_balance.h"
#include "core/state_visitor.h"

namespace sherd {

/// All contact of a run in implicit steps: of sheets and their fragments, obstacles and free bodies.
class Contact {
  public:
    /// The shell must outlive this object. gravity: m/s^2, acts on the bodies. threads: share the work for
    /// contact of sheets.
    Contact(const Shell& shell, ContactOptions options, const ContactStart& start, const Vector3d& gravity,
            const Threads& threads);
    Contact(const Contact&) = delete;  // energies hold references to its obstacles

    /// The contact energies, in the order in which they begin a step and are summed.
    std::vector<Energy*> energies();
    std::vector<double> body_masses() const;  ///< kg, of each body
    /// The friction energies between sheets, which begin a step after all others.
    std::vector<Energy*> frictions();

    /// Whether there are neither bodies nor barriers: only vertices may collide with obstacles, by springs.
    bool empty() const { return !body_contact && !sheet_contact; }
    /// A message if elements of sheets, or of a sheet and an obstacle, are closer at the beginning of the
    /// step than their minimum distance; else nothing.
    std::optional<std::string> overlap() const;
    /// Fraction, 0 to 1, up to which the shell's motion, [3, V] m, from the beginning of the step is free of
    /// collisions. Obstacles move to their poses at the end of the step meanwhile; bodies rest where they are
    /// placed. Zero if BodyContact::blocked().
    double free_fraction(const Positions& motion) const;
    /// Displacements, m, [3, V], in the step by which moving obstacles push the vertices near them; zero for
    /// vertices that are not near a moving obstacle.
    Positions push_displacement() const;
    /// The unknowns of the open step (see Potential), for the shell at x, [3, V] m, and the bodies where they
    /// are placed.
    Positions with_bodies(const Positions& x) const {
        return body_contact ? body_contact->with_bodies(x) : x;
    }
    /// Places the bodies: takes their columns from the last columns of the unknowns.
    void place_bodies(const Positions& unknowns);
    /// Moves the bodies towards their inertial predictions, as far as this motion is free of collisions of
    /// bodies with each other, with obstacles and with the shell, which rests at x, [3, V] m.
    void predict_bodies(const Positions& x);
    /// Adds dE/dx, N, of the energies of all contact and friction to the gradient, [3, V], with the shell at
    /// x and the bodies where they are placed.
    void add_gradient(const Positions& x, Positions& gradient);
    /// Computes the bodies at the end of the step from their columns; the step stays open.
    void end_step();
    /// Whether sheets, obstacles or bodies pass through each other in the step that ends with the shell at x.
    /// The shell moves straight, obstacles by their prescribed motion, bodies along their screws. The check
    /// is needed because the minimiser may have moved vertices or bodies around the rim of a sheet.
    bool passes(const StepContext& step, const Positions& x) const;
    /// Ends the step with the shell at x.
    void finish(const Positions& x);

    /// The bodies at the end of the last step that was finished.
    const std::vector<RigidBody>& bodies() const;
    std::vector<char> crossed() const;               ///< see surface_pairs()
    double stored_energy(const Positions& x) const;  ///< elastic energy of all contacts, J
    double stored_at_start() const;                  ///< J, stored_energy() at the beginning of the step
    /// Energy dissipated by friction in the step that ends at x, J.
    double friction_loss(const Positions& x) const;
    /// Work, J, of the obstacles, which move and deform as prescribed, in the step that ends at x.
    double obstacle_work(const StepContext& step, const Positions& x) const;
    /// The contact of bodies; null if there are no bodies.
    const BodyContact* of_bodies() const { return body_contact.get(); }
    Touch touch(const Positions& x) const;  ///< contacts of sheets and bodies, at the end of the step
    /// The reactions of the obstacles: their forces on sheets and bodies.
    std::vector<Reaction> reactions(const Positions& x) const;
    Positions crack_face_forces(const Positions& x) const;  ///< N, [3, V], between crack faces
    double crack_face_overlap(const Positions& x) const { return crack_faces.largest_overlap(x); }  ///< m
    void visit_state(StateVisitor& visit) {
        auto& [shell, options, body_contact, obstacle_contact, sheet_contact, sheet_friction, crack_faces] =
            *this;
        visit(body_contact, obstacle_contact, sheet_contact, sheet_friction, crack_faces);
    }

  private:
    const Shell& shell;
    const ContactOptions options;
    std::unique_ptr<BodyContact> body_contact;                       ///< null if there are no bodies
    std::vector<std::unique_ptr<ObstacleContact>> obstacle_contact;  ///< contact with each obstacle
    /// Null if sheets do not collide with each other and no obstacle has a surface.
    std::unique_ptr<SheetContact> sheet_contact;
    std::unique_ptr<SheetFriction> sheet_friction;  ///< null without sheet_contact
    CrackFaceContact crack_faces;
};

}  // namespace sherd
