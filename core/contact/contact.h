// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/contact/bodies/body_contact.h"
#include "core/contact/lips/lip.h"
#include "core/contact/penalty/obstacle_contact.h"
#include "core/contact/sheets/sheet_contact.h"
#include "core/contact/sheets/sheet_friction.h"

namespace sherd {

struct ContactOptions {
    std::vector<Obstacle> obstacles = {};
    std::vector<RigidBody> bodies = {};  ///< at the start
    bool sheets = false;                 ///< whether sheets meet each other, and themselves
    double friction = 0;                 ///< Coulomb coefficient of sheets on sheets
};

/// All that touches: sheets and their fragments, obstacles and free bodies.
class Contact {
  public:
    /// The sheet must outlive it. gravity: m/s^2, on the bodies.
    Contact(const Sheet& sheet, ContactOptions options, const Vector3d& gravity);
    Contact(const Contact&) = delete;  // its energies refer to its obstacles

    /// In the order in which they begin and are summed.
    std::vector<Energy*> energies();
    /// The same of friction between sheets, which begins after all others.
    std::vector<Energy*> frictions();

    /// Whether nothing has to be kept apart: there is no contact but that of vertices with obstacles, if any.
    bool empty() const { return !body_contact && !sheet_contact; }
    /// Throws std::runtime_error if sheets overlap at the beginning of the step.
    void require_apart() const;
    /// Fraction of a motion from the beginning of the step on, while obstacles move to where they are at its
    /// end, that leads through nothing.
    double free_way(const Positions& motion);
    /// Where obstacles that move push what is near them in the step, m, [3, V]; zero for other vertices.
    Positions pushed_along() const;
    /// Ends the step with the sheet at x.
    void finish(const Positions& x);

    /// At the end of the last step that was finished.
    const std::vector<RigidBody>& bodies() const;
    double stored_energy(const Positions& x) const;  ///< J, elastic, in all contacts
    Touch touch(const Positions& x) const;           ///< of obstacles and bodies
    double lip_overlap(const Positions& x) const { return lips.largest_overlap(x); }  ///< m

  private:
    const Sheet& sheet;
    ContactOptions options;
    std::unique_ptr<BodyContact> body_contact;  ///< null: no bodies
    std::vector<std::unique_ptr<ObstacleContact>> obstacle_contact;
    /// Null if sheets are not to meet each other, and no obstacle has a surface.
    std::unique_ptr<SheetContact> sheet_contact;
    std::unique_ptr<SheetFriction> sheet_friction;  ///< null: no sheet contact
    LipContact lips;
};

}  // namespace sherd
