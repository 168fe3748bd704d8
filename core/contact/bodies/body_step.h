// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/bodies/body_potential.h"
#include "core/contact/colliders/rigid_body.h"
#include "core/contact/detection/near_pairs.h"
#include "core/contact/penalty/vertex_contact.h"
#include "core/contact/sheets/sheet_friction.h"
#include "core/shell/sheet.h"

namespace sherd {

/// What NearPairs need of a sheet and a body that has a surface.
ContactSurface surface_with(const Sheet& sheet, const RigidBody& body);

/// One free rigid body in one step: the incremental potential P(x, q) of where the sheet (x) and the body (q)
/// are at its end. It has the body's inertia and weight (as for the sheet, by the origins and the lag of
/// StepContext, with the inertia of the step's beginning for the rotation), VertexContact with the sheet's
/// vertices, and the barriers of SheetContact against its triangles and edges. Both ends of every contact
/// feel the same force.
class BodyStep {
  public:
    /// sheet and body as they are at the beginning of the step; origin: the body's in it; gravity: m/s^2.
    /// near: pairs of the sheet and the body's surface, which rests in its frame; null: it has none. Sheet,
    /// body and near must outlive it.
    BodyStep(const Sheet& sheet, const RigidBody& body, const Vector3d& gravity, const StepContext& step,
             const BodyOrigin& origin, const NearPairs* near = nullptr);

    BodyPotential potential(const Positions& x, const Vector6d& q) const;
    BodyPose pose(const Vector6d& q) const;
    const RigidBody& start() const { return body; }
    RigidBody moved(const Vector6d& q) const;

    /// Fraction of the way from one q to another that is free of the sheet at x.
    double free_way(const Positions& x, const Vector6d& from, const Vector6d& to) const;
    /// Fraction of the sheet's motion from x that is free of the body at q.
    double free_motion(const Positions& x, const Positions& motion, const Vector6d& q) const;
    /// Adds the vertices that may touch the body at q soon.
    void add_near_vertices(const Positions& x, const Vector6d& q, std::set<Index>& found) const;
    /// What touches it of the sheet.
    Touch touch(const Positions& x, const Vector6d& q) const;

  private:
    void find_sliding();
    /// The body's points and the sheet's vertices, m, in the body's frame; what `near` is asked for.
    Positions seen_from(const BodyPose& pose, const Positions& x) const;
    void add_inertia(const Vector6d& q, BodyPotential& sum) const;
    void add_vertices(const Positions& x, const BodyPose& here, BodyPotential& sum) const;
    void add_pairs(const Positions& x, const BodyPose& here, BodyPotential& sum) const;
    void add_sliding_pairs(const Positions& x, const BodyPose& here, BodyPotential& sum) const;

    const Sheet& sheet;
    const RigidBody& body;
    const NearPairs* near;
    double lag;  ///< s
    BodyOrigin origin;
    Matrix3d inertia;                        ///< kg m^2, in space
    Vector6d predicted;                      ///< q without contact
    VertexContact vertices;                  ///< with anchors in the body's frame
    std::vector<SlidingPair> sliding_pairs;  ///< with the body's points as the first vertices
};

}  // namespace sherd
