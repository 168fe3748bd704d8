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

/// Free rigid bodies in explicit steps. A body's shape collides with vertices of the shell, and its surface
/// with triangles and edges of the shell. Contact points and surfaces of bodies collide with obstacles and
/// with other bodies.
class ExplicitBodies {
  public:
    /// bodies: their state where this object begins. Shell and obstacles must outlive this object. gravity:
    /// m/s^2. crossed: see surface_pairs().
    ExplicitBodies(const Shell& shell, std::vector<RigidBody> bodies, const std::vector<Obstacle>& obstacles,
                   const Vector3d& gravity, std::span<const char> crossed);
    ExplicitBodies(const ExplicitBodies&) = delete;  // contacts hold references to the bodies

    /// Begins a step: sets the counted work to zero, and stores the state to which restart() returns. places:
    /// poses of the obstacles.
    void begin(std::span<const Eigen::Isometry3d> places);
    void restart();
    /// Advances the surfaces of deforming obstacles to `time` (s), the end of a substep.
    void move_to(double time);
    /// Ends the exemption of crossed surfaces (SurfacePairs) that are apart now. places: poses of the
    /// obstacles.
    void update_exemption(std::span<const Eigen::Isometry3d> places);
    void shell_changed(const ShellChange& change);
    /// Changes the velocities by gravity and by the forces of the last add_forces(), which act for half of
    /// `length` (s), the duration of a substep.
    void kick(double length);
    /// Moves the bodies by their velocities for the whole substep of `length` s.
    void drift(double length);
    /// Computes all contact forces on the bodies, and adds to `sum` the forces of bodies on the shell, on
    /// ContactForces::vertices alone, and of obstacles on bodies. before, places: poses of the obstacles at
    /// the beginning and at the end of the substep. Throws std::runtime_error if a body's surface has passed
    /// through the surface of another body or an obstacle in the substep, unless contact points push the two
    /// colliders apart.
    void add_forces(const Substep& substep, std::span<const Eigen::Isometry3d> before,
                    std::span<const Eigen::Isometry3d> places, ContactForces& sum);

    /// Whether a body has passed through the shell in the step. The shell moves straight to `end`, [3, V] m,
    /// bodies along their screws.
    bool pass_shell(const StepContext& step, const Positions& end) const;
    /// Whether the springs between bodies and the shell at x, [3, V] m, could be replaced by barriers; see
    /// NearPairs::allow_barriers().
    bool allow_barriers(const Positions& x) const;
    /// Smallest distance of a pair of a body and the shell at x, [3, V] m, as a share of its activation
    /// distance (NearPairs::least_share()), with the bodies at the beginning of the step, or at their present
    /// poses.
    double least_share_at_start(const Positions& x) const { return least_share(started, x); }
    double least_share_at_end(const Positions& x) const { return least_share(all, x); }
    void set_second_spring(SecondSpring second_spring);

    const std::vector<RigidBody>& bodies() const { return all; }
    /// Elastic energy, J, of all contacts of the bodies. x: [3, V] m, positions of the shell; places: poses
    /// of the obstacles.
    double stored_energy(const Positions& x, std::span<const Eigen::Isometry3d> places) const;
    /// Adds the bounds for contact of bodies in the step. way: m, largest displacement of the shell's
    /// vertices; margin: factor of the displacements of bodies that follow from their velocities.
    void add_rates(const StepContext& step, double way, double margin, ContactRates& sum) const;
    void add_touch(const Positions& x, std::span<const Eigen::Isometry3d> places, Touch& touch) const;

    /// Work, J, of contact forces on the bodies since begin(); work_of_all(): work of contact forces and
    /// weight.
    double contact_work() const { return of_contact; }
    double friction_work() const { return of_friction; }  ///< J, part of contact_work() by friction
    double work_of_all() const { return of_contact + of_weight; }
    double kinetic_change() const;  ///< J, change of kinetic energy since begin()
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
        Vector3d force = Vector3d::Zero(), torque = Vector3d::Zero();  ///< N; N m, about the centre of mass

        void add(const Vector3d& arm, const Vector3d& one) {
            force += one;
            torque += arm.cross(one);
        }
    };
    /// Adds a contact force (N) at the point `at` (m, in space) of a body. add_friction() adds the force to
    /// the friction, too.
    void add_body_force(std::size_t body, const Vector3d& at, const Vector3d& force);
    void add_friction(std::size_t body, const Vector3d& at, const Vector3d& force);
    /// Work, J, on a body in the last substep, by forces that are `start` at its beginning and `end` at its
    /// end.
    double work(const Force& start, const Force& end, std::size_t body) const;
    Vector3d velocity_at(std::size_t body, const Vector3d& at) const;
    void add_vertices(std::size_t body, const Substep& substep, ContactForces& sum);
    void add_pairs(std::size_t body, const Substep& substep, ContactForces& sum);
    /// Friction, N, on the vertices of a pair of the body and the shell; at: m, positions of the vertices in
    /// space.
    PairPositions friction_of(std::size_t body, const ContactPair& pair, const PairPositions& at,
                              const Substep& substep) const;
    /// Calls add(body, other, overlap, at) for each contact point of a body that overlaps another collider.
    /// other: number of that collider, bodies before obstacles; at: m, position of the point in space.
    template <class Add>
    void each_point(std::span<const Eigen::Isometry3d> places, Add add) const;
    /// Upper bound, m, on the displacement of a body's points in `length` s, by its velocity and weight.
    double displacement(std::size_t body, double length) const;
    void add_points(const Substep& substep, std::span<const Eigen::Isometry3d> before,
                    std::span<const Eigen::Isometry3d> places, ContactForces& sum);
    /// Adds the forces between the surfaces of bodies, and between them and the surfaces of obstacles.
    /// length: s, of the substep; places: poses of the obstacles.
    void add_surfaces(double length, std::span<const Eigen::Isometry3d> places, ContactForces& sum);
    void add_surface_pair(const SurfacePairs& two, const PairPositions& at,
                          const std::array<Index, 4>& vertices, const PairPositions& contact_force,
                          const PairPositions& friction_force, ContactForces& sum);
    /// Friction, N, on the vertices of a pair of two colliders' surfaces. sharing: number of pairs that
    /// together stop the sliding of the two colliders; length: s, of the substep.
    PairPositions friction_of(const SurfacePairs& two, const ContactPair& pair, const PairPositions& at,
                              const PairPlaces& places, double sharing, double length) const;
    /// Whether a contact point of one of the two colliders pushes the other collider.
    bool contact_points_push(const SurfacePairs& two, std::span<const Eigen::Isometry3d> places) const;
    /// Upper bound on the increase of squared frequencies, 1/s^2, of the body, and of vertices within
    /// `margin` (m) of it, by second springs (SecondSpring).
    double rate_of_second_springs(std::size_t body, const StepContext& step, double margin) const;
    /// Upper bound on the increase of squared frequencies, 1/s^2, of any body by surface pairs in the step.
    double rate_of_surfaces(const StepContext& step) const;
    /// Displacements, [3, P] m, of the body's points in the step, relative to the other collider and in its
    /// frame. points: [3, P] m, in space.
    Positions motion_of(const SurfacePairs& two, const StepContext& step, const Positions& points) const;
    /// Upper bound, m, on the displacements that motion_of() returns for points within
    /// SurfacePairs::radius_of_body().
    double largest_displacement(const SurfacePairs& two, const StepContext& step) const;
    /// Poses of all colliders, bodies first; empty if there are no surface pairs. places: poses of the
    /// obstacles.
    std::vector<Eigen::Isometry3d> with_bodies(std::span<const Eigen::Isometry3d> places) const;
    ContactSurface with_surface(std::size_t body) const;
    void measure_triangles();  ///< updates `longest`
    /// Contribution of a body to the mobility in pair_friction(), 1/kg; force: sum of the forces `along` that
    /// act on the body.
    double mobility(std::size_t body, const Force& force) const;
    double least_share(const std::vector<RigidBody>& places, const Positions& x) const;
    bool passes_shell(std::size_t body, const StepContext& step, const Positions& end) const;
    /// Positions, m, of the points of a body's surface, then of the shell's vertices, in the body's frame.
    static Positions in_frame_of(const RigidBody& body, const Positions& x);
    const Collider& collider(std::size_t number) const;

    const Shell& shell;
    const std::vector<Obstacle>& obstacles;
    Vector3d gravity;
    double longest = 0;  ///< m, largest size of the shell's triangles so far; size: root of twice the area
    std::vector<RigidBody> all, started;     ///< bodies now, and at the beginning of the step
    std::vector<VertexContact> at_vertices;  ///< for each body, contact of the shell's vertices with it
    /// Pairs of the shell and each body's surface; null without a surface.
    std::vector<std::unique_ptr<NearPairs>> pairs;
    std::vector<PointContact> points;
    std::vector<std::unique_ptr<SurfacePairs>> surfaces;
    /// For each obstacle, column of its first vertex in ContactForces::deforming.
    std::vector<Index> first_vertex;
    std::vector<char> crossed_at_start;  ///< crossed() at the beginning of the step
    /// Forces on each body, at the last add_forces() and at the one before.
    std::vector<Force> forces, before;
    /// The parts of `forces` and `before` that friction causes.
    std::vector<Force> friction, friction_before;
    /// Displacement, m, and rotation vector, rad, of each body in the substep; zero once its work is counted.
    std::vector<Vector6d> moved;
    double of_contact = 0, of_friction = 0, of_weight = 0;  ///< J, work on the bodies since begin()
};

}  // namespace sherd
