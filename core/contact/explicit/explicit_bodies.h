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

/// Free rigid bodies in explicit steps. Their shapes collide with vertices of the shell, their surfaces with
/// its triangles and edges, and both their contact points and their surfaces with obstacles and each other.
class ExplicitBodies {
  public:
    /// bodies: at the start of the run. Shell and obstacles must outlive this object. gravity: m/s^2.
    /// crossed: see surface_pairs().
    ExplicitBodies(const Shell& shell, std::vector<RigidBody> bodies, const std::vector<Obstacle>& obstacles,
                   const Vector3d& gravity, std::span<const char> crossed);
    ExplicitBodies(const ExplicitBodies&) = delete;  // contacts refer to the bodies

    /// Begins a step, from which work is counted and to whose beginning restart() returns. places: poses of
    /// the obstacles.
    void begin(std::span<const Eigen::Isometry3d> places);
    void restart();
    /// Advances deforming surfaces to `time` (s), the end of a substep.
    void move_to(double time);
    /// Ends the exemption of crossed surfaces that are apart. places: poses of the obstacles.
    void update_exemption(std::span<const Eigen::Isometry3d> places);
    void shell_changed(const ShellChange& change);
    /// Changes the velocities in half a substep of `length` s, by gravity and the forces that were added
    /// last.
    void kick(double length);
    /// Moves the bodies through the substep.
    void drift(double length);
    /// Adds all contact forces on the bodies, and to `sum` those on the shell and of the obstacles, whose
    /// poses were `before` and are `places`. Throws std::runtime_error if a surface has passed through
    /// another one in between and no contact points push the two.
    void add_forces(const Substep& substep, std::span<const Eigen::Isometry3d> before,
                    std::span<const Eigen::Isometry3d> places, ContactForces& sum);

    /// Whether a body has passed through the shell in the step, with the shell moving straight to `end` [3,
    /// V] m and bodies along their screws.
    bool pass_shell(const StepContext& step, const Positions& end) const;
    /// See SheetContact; x: [3, V] m.
    bool allow_barriers(const Positions& x) const;
    /// See NearPairs; x: [3, V] m. The bodies are at the beginning of the step, or at their present poses.
    double least_share_at_start(const Positions& x) const { return least_share(started, x); }
    double least_share_at_end(const Positions& x) const { return least_share(all, x); }
    void set_second_spring(SecondSpring second_spring);

    const std::vector<RigidBody>& bodies() const { return all; }
    /// Elastic energy, J, of the contacts with the shell at x and the obstacles at these poses.
    double stored_energy(const Positions& x, std::span<const Eigen::Isometry3d> places) const;
    /// See ExplicitContact; margin: m, by which shell and bodies may approach each other.
    double largest_rate(const StepContext& step, double margin) const;
    void add_touch(const Positions& x, std::span<const Eigen::Isometry3d> places, Touch& touch) const;

    /// Work, J, of contact forces on the bodies since begin(); work_of_all(): of contact forces and weight.
    double contact_work() const { return of_contact; }
    double friction_work() const { return of_friction; }  ///< J, friction's part of contact_work()
    double work_of_all() const { return of_contact + of_weight; }
    double kinetic_change() const;                                            ///< J, since begin()
    std::vector<char> crossed() const { return crossed_surfaces(surfaces); }  ///< see surface_pairs()
    void visit_state(StateVisitor& visit) {
        auto& [shell, obstacles, gravity, longest, all, started, at_vertices, pairs, points, surfaces,
               first_vertex, crossed_at_start, forces, before, friction, friction_before, moved, of_contact,
               of_friction, of_weight] = *this;
        visit(longest, all, started, at_vertices, pairs, surfaces, crossed_at_start, forces, before, friction,
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
    /// Adds a contact force (N) at a point of a body; add_friction() adds friction.
    void add_body_force(std::size_t body, const Vector3d& at, const Vector3d& force);
    void add_friction(std::size_t body, const Vector3d& at, const Vector3d& force);
    /// Work, J, of forces on a body in the last substep, from the forces at its two ends.
    double work(const Force& start, const Force& end, std::size_t body) const;
    Vector3d velocity_at(std::size_t body, const Vector3d& at) const;
    void add_vertices(std::size_t body, const Substep& substep, ContactForces& sum);
    void add_pairs(std::size_t body, const Substep& substep, ContactForces& sum);
    /// Friction, N, on the vertices of a pair that are at these positions.
    PairPositions friction_of(std::size_t body, const ContactPair& pair, const PairPositions& at,
                              const Substep& substep) const;
    /// Calls add(body, other, overlap, point in space) for each contact point in another collider: a body, or
    /// an obstacle, numbered after the bodies.
    template <class Add>
    void each_point(std::span<const Eigen::Isometry3d> places, Add add) const;
    void add_points(const Substep& substep, std::span<const Eigen::Isometry3d> before,
                    std::span<const Eigen::Isometry3d> places, ContactForces& sum);
    /// Adds the forces of surfaces of bodies and obstacles on each other.
    void add_surfaces(double length, std::span<const Eigen::Isometry3d> places, ContactForces& sum);
    void add_surface_pair(const SurfacePairs& two, const PairPositions& at,
                          const std::array<Index, 4>& vertices, const PairPositions& contact_force,
                          const PairPositions& friction_force, ContactForces& sum);
    /// sharing: number of pairs that may stop the same sliding; length: s, of the substep.
    PairPositions friction_of(const SurfacePairs& two, const ContactPair& pair, const PairPositions& at,
                              const PairPlaces& places, double sharing, double length) const;
    /// Whether contact points of either collider push the other one.
    bool contact_points_push(const SurfacePairs& two, std::span<const Eigen::Isometry3d> places) const;
    /// The square of frequencies, 1/s^2, that second springs (SecondSpring) add to those of the body or of
    /// vertices within `margin`, m.
    double rate_of_second_springs(std::size_t body, const StepContext& step, double margin) const;
    /// The square of frequencies, 1/s^2, that surfaces may add to those of any body in the step.
    double rate_of_surfaces(const StepContext& step) const;
    /// Motion, m, in the step of the body's points, [3, P] m in space, relative to the other collider and in
    /// its frame.
    Positions motion_of(const SurfacePairs& two, const StepContext& step, const Positions& points) const;
    /// Upper bound, m, on the motion of the body's points in motion_of().
    double largest_displacement(const SurfacePairs& two, const StepContext& step) const;
    /// Poses of all colliders, bodies first; empty where no surfaces collide.
    std::vector<Eigen::Isometry3d> with_bodies(std::span<const Eigen::Isometry3d> places) const;
    ContactSurface with_surface(std::size_t body) const;
    void measure_triangles();
    /// Share of a body in the mobility of pair_friction(), 1/kg; force: sum of the forces `along` on the
    /// body.
    double mobility(std::size_t body, const Force& force) const;
    double least_share(const std::vector<RigidBody>& places, const Positions& x) const;
    bool passes_shell(std::size_t body, const StepContext& step, const Positions& end) const;
    /// Positions, m, of a body's points and the shell's vertices, in the body's frame.
    static Positions in_frame_of(const RigidBody& body, const Positions& x);
    const Collider& collider(std::size_t number) const;

    const Shell& shell;
    const std::vector<Obstacle>& obstacles;
    Vector3d gravity;
    double longest = 0;  ///< m, largest size of the shell's triangles: the root of twice the area
    std::vector<RigidBody> all, started;
    std::vector<VertexContact> at_vertices;         ///< contact of vertices with each body
    std::vector<std::unique_ptr<NearPairs>> pairs;  ///< shell and each body's surface; null without one
    std::vector<PointContact> points;
    std::vector<std::unique_ptr<SurfacePairs>> surfaces;
    std::vector<Index> first_vertex;     ///< first vertex of each obstacle in ContactForces::deforming
    std::vector<char> crossed_at_start;  ///< crossed() at the beginning of the step
    std::vector<Force> forces, before;   ///< on each body, at the last two evaluations
    std::vector<Force> friction, friction_before;  ///< friction's part of these forces
    std::vector<Vector6d> moved;                   ///< m, rad, motion of each body in the last substep
    double of_contact = 0, of_friction = 0, of_weight = 0;  ///< J
};

}  // namespace sherd
