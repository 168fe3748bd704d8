// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>

#include "core/contact/bodies/point_contacts.h"
#include "core/contact/bodies/surface_pairs.h"
#include "core/contact/colliders/obstacle.h"
#include "core/contact/colliders/touch.h"
#include "core/contact/detection/near_pairs.h"
#include "core/contact/explicit/contact_forces.h"
#include "core/contact/penalty/vertex_contact.h"
#include "core/state_visitor.h"
#include "core/step_context.h"

namespace sherd {

/// Free rigid bodies in explicit steps: they meet vertices of the shell, their surface its elements, and
/// their contact points and surfaces obstacles and each other.
class ExplicitBodies {
  public:
    /// bodies: at the start of the run. Shell and obstacles must outlive this object. gravity: m/s^2.
    /// crossed: see surface_pairs().
    ExplicitBodies(const Shell& shell, std::vector<RigidBody> bodies, const std::vector<Obstacle>& obstacles,
                   const Vector3d& gravity, std::span<const char> crossed);
    ExplicitBodies(const ExplicitBodies&) = delete;  // its contacts refer to its bodies

    /// Begins a step, from which work is counted and to whose beginning restart() goes back; obstacles are at
    /// these places.
    void begin(std::span<const Eigen::Isometry3d> places);
    void restart();
    /// The substep goes on to `time` (s), as what deforms sees it.
    void move_to(double time);
    /// Lets surfaces meet that have crossed, once they are apart; obstacles are at these places.
    void look(std::span<const Eigen::Isometry3d> places);
    void shell_changed(const ShellChange& change);
    /// Half a substep of `length` s, with the forces that were added last.
    void kick(double length);
    /// Moves the bodies through the substep.
    void drift(double length);
    /// Adds all forces on the bodies, and those on the shell and of the obstacles, which are at these places
    /// and were at those `before`. Throws std::runtime_error if a surface has passed through another one
    /// since then, and no contact points hold the two.
    void add_forces(const Substep& substep, std::span<const Eigen::Isometry3d> before,
                    std::span<const Eigen::Isometry3d> places, ContactForces& sum);

    /// Whether a body passes through the shell in the step, which has been made: the shell straight to `end`
    /// [3, V] m, bodies by their screws.
    bool pass_shell(const StepContext& step, const Positions& end) const;
    /// See SheetContact; x: [3, V] m.
    bool leave_room_for_barriers(const Positions& x) const;
    /// See NearPairs: with the shell at x [3, V] m, and the bodies as they were when the step began, or are.
    double least_share_at_start(const Positions& x) const { return least_share(started, x); }
    double least_share_at_end(const Positions& x) const { return least_share(all, x); }
    void set_firmness(Firmness firmness);

    const std::vector<RigidBody>& bodies() const { return all; }
    /// Stored in the contacts with the shell at x and with obstacles at these places, J.
    double stored_energy(const Positions& x, std::span<const Eigen::Isometry3d> places) const;
    /// See ExplicitContact; margin: m, how far shell and bodies may come nearer.
    double largest_rate(const StepContext& step, double margin) const;
    void add_touch(const Positions& x, std::span<const Eigen::Isometry3d> places, Touch& touch) const;

    /// Work, J, of the forces of contact on the bodies and of all forces on them, since begin().
    double contact_work() const { return of_contact; }
    double friction_work() const { return of_friction; }  ///< J, what of contact_work() is friction's
    double work_of_all() const { return of_contact + of_weight; }
    double kinetic_change() const;                                            ///< J, since begin()
    std::vector<char> crossed() const { return crossed_surfaces(surfaces); }  ///< see surface_pairs()
    void visit_state(StateVisitor& visit) {
        auto& [shell, obstacles, gravity, longest, all, started, at_vertices, pairs, points, surfaces,
               first_vertex, crossed_then, forces, before, friction, friction_before, moved, of_contact,
               of_friction, of_weight] = *this;
        visit(longest, all, started, at_vertices, pairs, surfaces, crossed_then, forces, before, friction,
              friction_before, moved, of_contact, of_friction, of_weight);
    }

  private:
    struct Force {
        Vector3d force = Vector3d::Zero(), torque = Vector3d::Zero();  ///< about the centre of mass

        void add(const Vector3d& arm, const Vector3d& one) {
            force += one;
            torque += arm.cross(one);
        }
    };
    /// Adds a force (N) at a point to a body; rub(): one of friction.
    void push(std::size_t body, const Vector3d& at, const Vector3d& force);
    void rub(std::size_t body, const Vector3d& at, const Vector3d& force);
    /// Work, J, of forces on a body in the last substep, from what they were at its ends.
    double work(const Force& start, const Force& end, std::size_t body) const;
    Vector3d velocity_at(std::size_t body, const Vector3d& at) const;
    void add_vertices(std::size_t body, const Substep& substep, ContactForces& sum);
    void add_pairs(std::size_t body, const Substep& substep, ContactForces& sum);
    /// On the vertices of a pair, which are `at` these places, N.
    PairPositions friction_of(std::size_t body, const ContactPair& pair, const PairPositions& at,
                              const Substep& substep) const;
    /// Calls add(body, other, overlap, point in space) for each contact point in another collider: a body, or
    /// an obstacle, numbered after the bodies.
    template <class Add>
    void each_point(std::span<const Eigen::Isometry3d> places, Add add) const;
    void add_points(const Substep& substep, std::span<const Eigen::Isometry3d> before,
                    std::span<const Eigen::Isometry3d> places, ContactForces& sum);
    /// The forces of surfaces on each other.
    void add_surfaces(double length, std::span<const Eigen::Isometry3d> places, ContactForces& sum);
    void add_surface_pair(const SurfacePairs& two, const PairPositions& at,
                          const std::array<Index, 4>& vertices, const PairPositions& pressed,
                          const PairPositions& rubbed, ContactForces& sum);
    /// sharing: how many pairs may take the same sliding; length: s, of the substep.
    PairPositions friction_of(const SurfacePairs& two, const ContactPair& pair, const PairPositions& at,
                              const PairPlaces& places, double sharing, double length) const;
    /// Whether points of either push the other one.
    bool points_hold(const SurfacePairs& two, std::span<const Eigen::Isometry3d> places) const;
    /// The square of frequencies, 1/s^2, that firm springs add to those of the body or of vertices so near.
    double rate_of_firm_springs(std::size_t body, const StepContext& step, double margin) const;
    /// The square of frequencies, 1/s^2, that surfaces may add to those of any body in the step.
    double rate_of_surfaces(const StepContext& step) const;
    /// How points of the body, [3, P] m, move in the step as seen from the other one; m, in its frame.
    Positions motion_of(const SurfacePairs& two, const StepContext& step, const Positions& points) const;
    /// m, no point of the body moves farther.
    double longest_way(const SurfacePairs& two, const StepContext& step) const;
    /// Of all colliders, bodies first.
    std::vector<Eigen::Isometry3d> with_bodies(std::span<const Eigen::Isometry3d> places) const;
    ContactSurface with_surface(std::size_t body) const;
    void measure_triangles();
    /// The share of a body in the mobility of pair_friction(), 1/kg; force: those along the slip, on it.
    double mobility(std::size_t body, const Force& force) const;
    double least_share(const std::vector<RigidBody>& places, const Positions& x) const;
    bool passes_shell(std::size_t body, const StepContext& step, const Positions& end) const;
    /// Positions, m, of a body's points and the shell's vertices, in the body's frame.
    static Positions seen_from(const RigidBody& body, const Positions& x);
    const Collider& collider(std::size_t number) const;

    const Shell& shell;
    const std::vector<Obstacle>& obstacles;
    Vector3d gravity;
    double longest = 0;  ///< m, of the shell's triangles
    std::vector<RigidBody> all, started;
    std::vector<VertexContact> at_vertices;         ///< of each body
    std::vector<std::unique_ptr<NearPairs>> pairs;  ///< with the surface of each body; null if it has none
    std::vector<PointContact> points;
    std::vector<std::unique_ptr<SurfacePairs>> surfaces;
    std::vector<Index> first_vertex;               ///< of each obstacle, see ContactForces::deforming
    std::vector<char> crossed_then;                ///< at the beginning of the step
    std::vector<Force> forces, before;             ///< on each body, at the last two evaluations
    std::vector<Force> friction, friction_before;  ///< what of them is friction
    std::vector<Vector6d> moved;                   ///< m, rad, of each body in the last substep
    double of_contact = 0, of_friction = 0, of_weight = 0;  ///< J
};

}  // namespace sherd
