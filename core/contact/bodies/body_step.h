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

/// Largest rotation between two poses that are tried in succession, rad.
constexpr double largest_turn = 1;

/// Distance from the shell below which contact is expected, as a share of a body's size.
constexpr double ahead_of_contact = 0.1;

/// The contact surface of the shell and of a body that has a surface, for NearPairs. springs: see
/// ContactSurface. number: of the body in Shell::start_depths.
ContactSurface surface_with(const Shell& shell, const RigidBody& body, std::size_t number,
                            bool springs = false);

/// A free rigid body in one step: its motion, and its contact with the shell, by the springs of
/// VertexContact with the shell's vertices, and by the barriers of SheetContact with its triangles and edges.
/// The forces on the two sides of a contact are equal and opposite. In all functions x are the positions of
/// the shell, [3, V] m, and q the columns of the body.
class BodyStep {
  public:
    /// shell, body: as they are at the beginning of the step; origin: the body's origins in the step (see
    /// StepContext); gravity: m/s^2. near: pairs of the shell and the body's surface, which rests in the
    /// body's frame; null if the body has no surface. Shell, body and near must outlive this object. number:
    /// of the body. elastic_slip: elastic slip from the last step.
    BodyStep(const Shell& shell, const RigidBody& body, const Vector3d& gravity, const StepContext& step,
             const BodyOrigin& origin, const NearPairs* near, std::size_t number, std::size_t obstacles,
             const BodySticks& elastic_slip);

    BodyPose pose(const BodyColumns& q) const;
    /// Displacement (m) and rotation vector (rad), in space, and the columns with such a motion.
    Vector6d motion(const BodyColumns& q) const;
    BodyColumns columns(const Vector6d& motion) const;
    /// The columns without contact: the inertial prediction.
    const BodyColumns& prediction() const { return predicted; }
    /// The body at the end of the step.
    RigidBody moved(const BodyColumns& q) const;
    /// Rates of the linear and of the angular momentum, N and N m, when the body ends the step as `end`.
    Vector6d momentum_rate(const RigidBody& end) const;
    /// Elastic slip of the contacts with the shell after the step.
    BodySticks elastic_slip_after(const Positions& x, const BodyColumns& q) const;

    /// Calls add(force, hessian) for each force between the shell at x and the body at `here`; hessian():
    /// second derivative of BodyForce::value, N/m, a positive semidefinite approximation.
    template <class Add>
    void each_force(const Positions& x, const BodyPose& here, Add add) const;

    /// Fraction, 0 to 1, up to which the body and the shell do not reach each other while they move straight,
    /// in the body's frame, from one place to the other.
    double free_fraction(const Positions& x, const BodyPose& here, const Positions& x_after,
                         const BodyPose& after) const;
    /// Whether the body, if it moved straight and without rotation, would get no farther than `widths` of its
    /// smallest extents beyond its first contact with the shell, which moves to x meanwhile.
    bool has_straight_path(const Positions& x, const BodyColumns& q, double widths) const;
    /// Whether the body, which moves to q along its screw, passes through the shell, which moves straight to
    /// x. The minimiser may have moved it around the rim of a sheet.
    bool passes(const Positions& x, const BodyColumns& q) const;
    /// Adds the vertices that are near contact with the body, and the pairs of vertices that are near contact
    /// with one of its elements together.
    void add_near(const Positions& x, const BodyPose& here, std::set<Index>& vertices,
                  std::vector<std::pair<Index, Index>>& pairs) const;
    /// The vertices of the shell that touch the body, with their depth.
    Touch touch(const Positions& x, const BodyPose& here) const;

  private:
    void find_sliding(double length, const BodySticks& elastic_slip);
    /// Positions of the body's points and the shell's vertices, m, in the body's frame, as `near` takes them.
    Positions in_frame_of(const BodyPose& pose, const Positions& x) const;
    /// The points of a pair.
    std::array<BodyForce::Point, 4> points_of(const std::array<Index, 4>& vertices) const;
    /// Displacements of a pair's vertices in the step, m.
    PairPositions moved(const std::array<Index, 4>& of_pair, const Positions& x, const BodyPose& here) const;

    const Shell& shell;
    const RigidBody& body;
    const NearPairs* near;
    std::size_t number;
    double lag;  ///< s
    BodyOrigin origin;
    Vector3d gyration;                       ///< m, radii of gyration about the principal axes
    BodyColumns predicted;                   ///< columns without contact: the inertial prediction
    VertexContact vertices;                  ///< anchors are in the body's frame
    std::vector<SlidingPair> sliding_pairs;  ///< the body's points are their first vertices
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
