// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/bodies/body_potential.h"
#include "core/contact/colliders/rigid_body.h"
#include "core/contact/detection/near_pairs.h"
#include "core/contact/penalty/vertex_contact.h"
#include "core/contact/sheets/sheet_friction.h"
#include "core/shell/shell.h"

namespace sherd {

/// Elastic slip of a body's contacts with the shell at the end of the last finished step.
struct BodySticks {
    StickMemory<Index> vertices;
    StickMemory<PairKey> pairs;

    void visit_state(StateVisitor& visit) { visit(vertices, pairs); }
};

/// Largest rotation between two poses that are tried in succession, rad.
constexpr double largest_turn = 1;

/// Distance from the shell below which contact is expected, as a share of a body's size.
constexpr double ahead_of_contact = 0.1;

/// The contact surface of the shell and of a body that has a surface, for NearPairs. springs: see
/// ContactSurface. number: of the body in Shell::start_depths.
ContactSurface surface_with(const Shell& shell, const RigidBody& body, std::size_t number,
                            bool springs = false);

/// The incremental potential P(x, q) of one free rigid body in one step, as a function of the positions x of
/// the shell and the motion q of the body at its end. It consists of the body's inertia and weight (as for
/// the shell, by the origins and the lag of StepContext; the rotation uses the inertia tensor of the step's
/// beginning), of VertexContact with the shell's vertices, and of the barriers of SheetContact against its
/// triangles and edges. The forces on the two sides of a contact are equal and opposite.
class BodyStep {
  public:
    /// shell, body: as they are at the beginning of the step; origin: the body's origins in the step;
    /// gravity: m/s^2. near: pairs of the shell and the body's surface, which rests in the body's frame; null
    /// if the body has no surface. Shell, body and near must outlive this object. number: of the body in
    /// Shell::start_depths. elastic_slip: elastic slip from the last step.
    BodyStep(const Shell& shell, const RigidBody& body, const Vector3d& gravity, const StepContext& step,
             const BodyOrigin& origin, const NearPairs* near = nullptr, std::size_t number = 0,
             const BodySticks& elastic_slip = {});

    BodyPotential potential(const Positions& x, const Vector6d& q) const;
    BodyPose pose(const Vector6d& q) const;
    /// q without contact: the inertial prediction.
    const Vector6d& prediction() const { return predicted; }
    const RigidBody& start() const { return body; }
    RigidBody moved(const Vector6d& q) const;
    /// Rates of the linear and of the angular momentum, N and N m, when the body ends the step as `end`.
    Vector6d momentum_rate(const RigidBody& end) const;
    /// Elastic slip of the contacts with the shell after the step.
    BodySticks elastic_slip_after(const Positions& x, const Vector6d& q) const;
    /// Energy dissipated by friction with the shell in the step, J.
    double friction_loss(const Positions& x, const Vector6d& q) const;

    /// Fraction, 0 to 1, of the way from one q to another on which the body does not reach the shell at x.
    double free_fraction(const Positions& x, const Vector6d& from, const Vector6d& to) const;
    /// Fraction, 0 to 1, of the shell's motion from x on which it does not reach the body at q.
    double free_motion(const Positions& x, const Positions& motion, const Vector6d& q) const;
    /// Whether the body, if it moved straight and without rotation, would get no farther than `widths` of its
    /// smallest extents beyond its first contact with the shell, which moves to x meanwhile.
    bool has_straight_path(const Positions& x, const Vector6d& q, double widths) const;
    /// Whether the body, which moves to q along its screw, passes through the shell, which moves straight to
    /// x. The search for the optimal pose may have moved it around the rim of a sheet.
    bool passes(const Positions& x, const Vector6d& q) const;
    /// Adds the vertices that are in contact with the body at q, or near it.
    void add_near_vertices(const Positions& x, const Vector6d& q, std::set<Index>& found) const;
    /// The vertices of the shell that touch the body at q, with their depth.
    Touch touch(const Positions& x, const Vector6d& q) const;

  private:
    void find_sliding(double length, const BodySticks& elastic_slip);
    /// Positions of the body's points and the shell's vertices, m, in the body's frame, as `near` takes them.
    Positions in_frame_of(const BodyPose& pose, const Positions& x) const;
    void add_inertia(const Vector6d& q, BodyPotential& sum) const;
    void add_vertices(const Positions& x, const BodyPose& here, BodyPotential& sum) const;
    void add_pairs(const Positions& x, const BodyPose& here, BodyPotential& sum) const;
    void add_sliding_pairs(const Positions& x, const BodyPose& here, BodyPotential& sum) const;
    /// Displacements of a sliding pair's vertices in the step, m.
    PairPositions moved(const SlidingPair& pair, const Positions& x, const BodyPose& here) const;

    const Shell& shell;
    const RigidBody& body;
    const NearPairs* near;
    double lag;  ///< s
    BodyOrigin origin;
    Matrix3d inertia;                        ///< kg m^2, in space
    Vector6d predicted;                      ///< q without contact: the inertial prediction
    VertexContact vertices;                  ///< anchors are in the body's frame
    std::vector<SlidingPair> sliding_pairs;  ///< the body's points are their first vertices
};

}  // namespace sherd
