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

/// All contact of a run: of sheets and their fragments, obstacles and free bodies.
class Contact {
  public:
    /// The shell must outlive this object. gravity: m/s^2, acts on the bodies. threads: share the contact of
    /// sheets.
    Contact(const Shell& shell, ContactOptions options, const ContactStart& start, const Vector3d& gravity,
            const Threads& threads);
    Contact(const Contact&) = delete;  // energies refer to its obstacles

    /// The contact energies, in the order in which they begin a step and are summed.
    std::vector<Energy*> energies();
    std::vector<double> body_masses() const;  ///< kg
    /// The friction energies between sheets, which begin a step after all others.
    std::vector<Energy*> frictions();

    /// Whether there is no barrier: at most vertices collide with obstacles, by springs.
    bool empty() const { return !body_contact && !sheet_contact; }
    /// A message if sheets overlap at the beginning of the step; else nothing.
    std::optional<std::string> overlap() const;
    /// Fraction, 0 to 1, of a motion [3, V] m from the beginning of the step that is free of collisions,
    /// while obstacles move to their poses at its end, and bodies rest where these have moved them.
    double free_fraction(const Positions& motion) const;
    /// Displacement in the step, m, [3, V], by which moving obstacles push the vertices near them; zero for
    /// other vertices.
    Positions push_displacement() const;
    /// The unknowns of the open step (see Potential), with the shell at x [3, V] and the bodies where they
    /// have been placed.
    Positions with_bodies(const Positions& x) const {
        return body_contact ? body_contact->with_bodies(x) : x;
    }
    /// Places the bodies as the last columns of the unknowns say.
    void place_bodies(const Positions& unknowns);
    /// Moves the bodies to their inertial predictions, or as far as the way there is free of the shell, which
    /// is at x [3, V].
    void predict_bodies(const Positions& x);
    /// Adds dE/dx, N, of all contact and friction to the gradient, [3, V], with the bodies where they have
    /// been placed.
    void add_gradient(const Positions& x, Positions& gradient);
    /// Moves the bodies to the end of the step, which stays open.
    void end_step();
    /// Whether sheets, obstacles or bodies pass through each other in the step that ends with the shell at x.
    /// The shell moves straight, obstacles by their motion, bodies along their screws. The iterates of a
    /// minimiser may have gone around a rim.
    bool passes(const StepContext& step, const Positions& x) const;
    /// Ends the step with the shell at x.
    void finish(const Positions& x);

    /// The bodies at the end of the last step that was finished.
    const std::vector<RigidBody>& bodies() const;
    std::vector<char> crossed() const;               ///< see surface_pairs()
    double stored_energy(const Positions& x) const;  ///< elastic energy of all contacts, J
    double stored_at_start() const;                  ///< J, at the beginning of the step
    /// Energy dissipated by friction in the step that ends at x, J.
    double friction_loss(const Positions& x) const;
    /// Work, J, of the obstacles, which move and deform as prescribed, in the step that ends at x.
    double obstacle_work(const StepContext& step, const Positions& x) const;
    /// Null if there are no bodies.
    const BodyContact* of_bodies() const { return body_contact.get(); }
    Touch touch(const Positions& x) const;  ///< with obstacles and bodies
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
    std::unique_ptr<BodyContact> body_contact;  ///< null if there are no bodies
    std::vector<std::unique_ptr<ObstacleContact>> obstacle_contact;
    /// Null if sheets do not collide with each other and no obstacle has a surface.
    std::unique_ptr<SheetContact> sheet_contact;
    std::unique_ptr<SheetFriction> sheet_friction;  ///< null without sheet_contact
    CrackFaceContact crack_faces;
};

}  // namespace sherd
