// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/bodies/body_potential.h"
#include "core/contact/colliders/rigid_body.h"
#include "core/contact/detection/near_pairs.h"
#include "core/contact/penalty/vertex_contact.h"
#include "core/contact/sheets/sheet_friction.h"
#include "core/shell/shell.h"

namespace sherd {

/// What contacts of a body with the shell hold since the last step that was finished.
struct BodySticks {
    StickMemory<Index> vertices;
    StickMemory<PairKey> pairs;

    void visit_state(StateVisitor& visit) { visit(vertices, pairs); }
};

/// rad, rotation between two poses that are tried in succession.
constexpr double largest_turn = 1;

/// Contact is expected soon within this share of a body's size.
constexpr double ahead_of_contact = 0.1;

/// The contact surface of the shell and of a body that has a surface, for NearPairs. springs: see
/// ContactSurface. number: of the body in Shell::start_depths.
ContactSurface surface_with(const Shell& shell, const RigidBody& body, std::size_t number,
                            bool springs = false);

/// The incremental potential P(x, q) of one free rigid body in one step, as a function of the positions x of
/// the shell and the motion q of the body at its end. It consists of the body's inertia and weight (as for
/// the shell, by the origins and the lag of StepContext; the rotation uses the inertia tensor of the step's
/// beginning), of VertexContact with the shell's vertices, and of the barriers of SheetContact against its
/// triangles and edges. Both sides of every contact feel the same force.
class BodyStep {
  public:
    /// shell, body: as they are at the beginning of the step; origin: the body's origins in the step;
    /// gravity: m/s^2. near: pairs of the shell and the body's surface, which rests in the body's frame; null
    /// if it has none. Shell, body and near must outlive this object. number: of the body in
    /// Shell::start_depths.
    BodyStep(const Shell& shell, const RigidBody& body, const Vector3d& gravity, const StepContext& step,
             const BodyOrigin& origin, const NearPairs* near = nullptr, std::size_t number = 0,
             const BodySticks& held = {});

    BodyPotential potential(const Positions& x, const Vector6d& q) const;
    BodyPose pose(const Vector6d& q) const;
    /// q without contact: the inertial prediction.
    const Vector6d& prediction() const { return predicted; }
    const RigidBody& start() const { return body; }
    RigidBody moved(const Vector6d& q) const;
    /// Rates of the linear and of the angular momentum, N and N m, when the body ends the step as `end`.
    Vector6d momentum_rate(const RigidBody& end) const;
    /// What its contacts with the shell hold after the step.
    BodySticks held_after(const Positions& x, const Vector6d& q) const;
    /// What friction with the shell takes in the step, J.
    double friction_loss(const Positions& x, const Vector6d& q) const;

    /// Fraction, 0 to 1, of the way from one q to another on which the body does not reach the shell at x.
    double free_way(const Positions& x, const Vector6d& from, const Vector6d& to) const;
    /// Fraction, 0 to 1, of the shell's motion from x on which it does not reach the body at q.
    double free_motion(const Positions& x, const Positions& motion, const Vector6d& q) const;
    /// Whether a body that goes straight, without turning, gets no farther than some of its own widths beyond
    /// where it meets the shell, which gets to x meanwhile.
    bool has_straight_way(const Positions& x, const Vector6d& q, double widths) const;
    /// Whether the body passes through the shell in the step, in which it gets to q by its screw and the
    /// shell straight to x. A search for the best pose may have taken it around the rim of a sheet.
    bool passes(const Positions& x, const Vector6d& q) const;
    /// Adds the vertices that may touch the body at q soon.
    void add_near_vertices(const Positions& x, const Vector6d& q, std::set<Index>& found) const;
    /// The vertices of the shell that touch the body at q, with their depth.
    Touch touch(const Positions& x, const Vector6d& q) const;

  private:
    void find_sliding(double length, const BodySticks& held);
    /// Positions of the body's points and the shell's vertices, m, in the body's frame, as `near` takes them.
    Positions seen_from(const BodyPose& pose, const Positions& x) const;
    void add_inertia(const Vector6d& q, BodyPotential& sum) const;
    void add_vertices(const Positions& x, const BodyPose& here, BodyPotential& sum) const;
    void add_pairs(const Positions& x, const BodyPose& here, BodyPotential& sum) const;
    void add_sliding_pairs(const Positions& x, const BodyPose& here, BodyPotential& sum) const;
    /// Displacements of a sliding pair's vertices in the step, m.
    PairPositions moved(const SlidingPair& pair, const Positions& x, const BodyPose& here) const;

    const Shell& shell;
    const RigidBody& body;
    const NearPairs* near;
    double lag;    ///< s
    BodyOrigin origin;
    Matrix3d inertia;                        ///< kg m^2, in space
    Vector6d predicted;                      ///< q without contact: the inertial prediction
    VertexContact vertices;                  ///< its anchors are in the body's frame
    std::vector<SlidingPair> sliding_pairs;  ///< the body's points are their first vertices
};

}  // namespace sherd
