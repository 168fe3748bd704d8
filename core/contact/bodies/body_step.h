// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/bodies/body_force.h"
#include "core/contact/bodies/body_pose.h"
#include "core/contact/colliders/rigid_body.h"
#include "core/contact/detection/near_pairs.h"

namespace sherd {

/// Elastic slip of a body's contacts with the shell at the end of the last finished step.
struct BodySticks {
    StickMemory<Index> vertices;
    StickMemory<PairKey> pairs;

    void visit_state(StateVisitor& visit) { visit(vertices, pairs); }
};

/// Largest rotation of a body, rad, from one pose that the minimiser tries to the next.
constexpr double largest_turn = 1;

/// Distance between a body and the shell, or between two bodies, below which contact is expected soon, as a
/// share of the diagonal of a body's bounding box.
constexpr double ahead_of_contact = 0.1;

/// Returns the contact surface, for NearPairs, of the shell and of a body that has a surface. number: the
/// body's number in Shell::start_depths. springs: see ContactSurface.
ContactSurface surface_with(const Shell& shell, const RigidBody& body, std::size_t number,
                            bool springs = false);

/// A free rigid body in one step: its motion, and its contact with the shell. The body's shape acts on the
/// shell's vertices by the springs of VertexContact. The body's surface acts on the shell's triangles and
/// edges by barriers, as in SheetContact. The forces on the two sides of a contact are equal and opposite. In
/// all functions x are the positions of the shell, [3, V] m, and q the columns of the body (BodyColumns).
class BodyStep {
  public:
    /// shell, body: their state at the beginning of the step; gravity: m/s^2; origin: the body's origins in
    /// the step (see StepContext). near: contact pairs of the shell and the body's surface, in the body's
    /// frame; null if the body has no surface. Shell, body and near must outlive this object. number: the
    /// body's number; obstacles: number of obstacles, which precede the bodies in Shell::start_depths.
    /// elastic_slip: elastic slip at the end of the last step.
    BodyStep(const Shell& shell, const RigidBody& body, const Vector3d& gravity, const StepContext& step,
             const BodyOrigin& origin, const NearPairs* near, std::size_t number, std::size_t obstacles,
             const BodySticks& elastic_slip);

    BodyPose pose(const BodyColumns& q) const;
    /// Displacement (m) and rotation vector (rad) of the body in space, for the columns q. columns() is the
    /// inverse function.
    Vector6d motion(const BodyColumns& q) const;
    BodyColumns columns(const Vector6d& motion) const;
    /// The columns of a body that meets no contact in the step: the inertial prediction.
    const BodyColumns& prediction() const { return predicted; }
    /// The body at the end of the step, if its columns are q.
    RigidBody moved(const BodyColumns& q) const;
    /// Rates of change of the linear momentum, N, and of the angular momentum, N m, if `end` is the body at
    /// the end of the step.
    Vector6d momentum_rate(const RigidBody& end) const;
    /// Elastic slip of the body's contacts with the shell at the end of the step.
    BodySticks elastic_slip_after(const Positions& x, const BodyColumns& q) const;

    /// Calls add(force, hessian) for each force between the shell at x and the body at `here`. force: a
    /// BodyForce; hessian(): returns a positive semidefinite approximation, N/m, of the second derivative of
    /// its value.
    template <class Add>
    void each_force(const Positions& x, const BodyPose& here, Add add) const;

    /// Fraction, 0 to 1, of a motion up to which the body and the shell do not reach each other. The shell
    /// moves from x to x_after and the body from `here` to `after`; in the body's frame the shell's vertices
    /// move straight.
    double free_fraction(const Positions& x, const BodyPose& here, const Positions& x_after,
                         const BodyPose& after) const;
    /// Whether the body, if it moved straight and without rotation by the displacement in q, would end at
    /// most `widths` times its smallest extent beyond the first contact with the shell. The shell moves to x
    /// meanwhile.
    bool has_straight_path(const Positions& x, const BodyColumns& q, double widths) const;
    /// Whether the body passes through the shell in the step. The body moves to q along its screw (at
    /// constant velocity and spin), the shell straight to x. The check is needed because the minimiser may
    /// have moved the body around the rim of a sheet.
    bool passes(const Positions& x, const BodyColumns& q) const;
    /// Adds to `vertices` the vertices of the shell that are near contact with the body. Adds to `pairs` the
    /// pairs of vertices that belong to one element of the shell near contact with the body's surface.
    void add_near(const Positions& x, const BodyPose& here, std::set<Index>& vertices,
                  std::vector<std::pair<Index, Index>>& pairs) const;
    /// The vertices of the shell that touch the body, and the largest depth of a vertex in the body's shape.
    Touch touch(const Positions& x, const BodyPose& here) const;

  private:
    void find_sliding(double length, const BodySticks& elastic_slip);
    /// Positions, m, of the points of the body's surface, then of the shell's vertices, in the body's frame:
    /// the argument of functions of `near`.
    Positions in_frame_of(const BodyPose& pose, const Positions& x) const;
    /// The points on which the force of a pair acts, from the pair's vertices.
    std::array<BodyForce::Point, 4> points_of(const std::array<Index, 4>& vertices) const;
    /// Displacements of a pair's vertices in the step, m.
    PairPositions moved(const std::array<Index, 4>& of_pair, const Positions& x, const BodyPose& here) const;

    const Shell& shell;
    const RigidBody& body;
    const NearPairs* near;
    std::size_t number;
    double lag;  ///< s, see StepContext
    BodyOrigin origin;
    Vector3d gyration;       ///< m, radii of gyration about the body's principal axes
    BodyColumns predicted;   ///< see prediction()
    VertexContact vertices;  ///< anchors (SlidingPoint) are in the body's frame
    /// The lowest vertex numbers are points of the body, as in `near`.
    std::vector<SlidingPair> sliding_pairs;
};

template <class Add>
void BodyStep::each_force(const Positions& x, const BodyPose& here, Add add) const {
    const auto add_point = [&](Index vertex, const PointForce& force, const Vector3d& anchor, bool elastic) {
        add(BodyForce::between({vertex, 0}, x.col(vertex), number, anchor, force, elastic),
            [&] { return between_points(force.hessian); });
    };
    vertices.add_springs(x, here.place, Curvature::convex, [&](Index vertex, const PointForce& force) {
        add_point(vertex, force, x.col(vertex), true);
    });
    vertices.add_friction(x, here.place, [&](Index vertex, const PointForce& force, const Vector3d& anchor) {
        add_point(vertex, force, anchor, false);
    });
    if (!near) return;
    const Positions local = in_frame_of(here, x);
    for (const ContactPair& pair : near->active_pairs(local)) {
        const PairPositions at = here.place * sherd::columns(local, pair.vertices);
        add(BodyForce::of(pair, points_of(pair.vertices), at, PairPositions::Zero()),
            [&] { return hessian(pair, at, true); });
    }
    for (const SlidingPair& pair : sliding_pairs) {
        const PairPositions at = here.place * sherd::columns(local, pair.vertices),
                            way = moved(pair.vertices, x, here);
        add(BodyForce::of(pair, points_of(pair.vertices), at, way), [&] { return pair.hessian(way); });
    }
}

}  // namespace sherd
