// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/bodies/body_step.h"
#include "core/contact/bodies/point_contacts.h"
#include "core/contact/bodies/surface_pairs.h"
#include "core/contact/colliders/obstacle.h"
#include "core/energy.h"
#include "core/reaction.h"
#include "core/state_visitor.h"

namespace sherd {

/// Contact of free rigid bodies in one step: with the shell (BodyStep), with each other and with obstacles.
/// The bodies' columns (BodyColumns) follow the columns of the vertices among the unknowns: x is [3, V + 2 B]
/// m, unless a comment says that the shell is at x, which then is [3, V] m. The Hessian is a Gauss-Newton
/// approximation, without the second derivatives of rotations.
///
/// Springs act between two bodies, and between a body and an obstacle, at the body's contact points: the
/// centre of a ball with its radius, the corners of a box or of a mesh. A spring acts when such a point is in
/// the other collider's shape. Contacts without such a point, above all of edges on edges, are found by
/// SurfacePairs, whose barriers no surface passes.
class BodyContact : public Energy {
  public:
    /// bodies: their state where this object begins. Shell and obstacles must outlive this object. gravity:
    /// m/s^2. crossed: see surface_pairs().
    BodyContact(const Shell& shell, std::vector<RigidBody> bodies, const std::vector<Obstacle>& obstacles,
                const Vector3d& gravity, std::span<const char> crossed = {});
    /// If a moving collider would enter a body, the body is moved along with the collider; place() then
    /// contains this displacement.
    void begin(const StepContext& step) override;
    void topology_changed(const ShellChange& change, const StepContext& step) override;
    bool has_bodies() const override { return true; }
    /// Whether the step is too long for the bodies: without contact, a body would end too many of its own
    /// widths beyond the surface that it hits, or an obstacle moves into a body that cannot be moved along
    /// with the obstacle freely. In such a step the minimiser hardly finds a minimum, and the minimum may be
    /// on the wrong side of the surface.
    bool blocked() const { return is_blocked; }

    /// The bodies' columns in the open step, [3, 2 B] m: first as begin() has set them, then as predict() or
    /// place(columns) has set them.
    const Positions& place() const { return at; }
    void place(Positions columns) { at = std::move(columns); }
    /// The unknowns for the shell at x [3, V] and the bodies at place().
    Positions with_bodies(const Positions& x) const;
    /// Moves the bodies towards their inertial predictions, as far as this motion is free of collisions of
    /// bodies with each other, with obstacles and with the shell, which rests at x [3, V].
    void predict(const Positions& x);
    Index first_column(std::size_t body) const { return static_cast<Index>(shell.mass.size() + 2 * body); }
    const BodyColumns& prediction(std::size_t body) const { return steps[body].prediction(); }

    /// Computes the bodies at the end of the step from place(); the step stays open.
    void end_step();
    /// Whether a body passes through the shell, another body or an obstacle in the step. The shell moves
    /// straight to x [3, V], bodies along their screws, obstacles by their prescribed motion.
    bool passes(const StepContext& step, const Positions& x) const;
    /// Ends the step with the shell at x [3, V].
    void finish(const Positions& x);
    /// The bodies at the end of the last step that was finished.
    const std::vector<RigidBody>& bodies() const { return finished; }
    std::vector<char> crossed() const { return crossed_surfaces(surfaces); }  ///< see surface_pairs()

    double value(const Positions& x) const override;
    void add_gradient(const Positions& x, Positions& gradient) const override;
    void add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const override;
    Task task() const override { return Task::contact; }
    void add_contacts(const Positions& x, bool ahead,
                      std::vector<std::pair<Index, Index>>& pairs) const override;
    double safe_fraction(const Positions& x, const Positions& motion) const override;

    // At place(), with the shell at x [3, V]:
    double stored_energy(const Positions& x) const { return stored_energy(x, poses(at)); }  ///< J, elastic
    double stored_at_start() const { return start_stored; }  ///< J, at the beginning of the step
    /// Energy dissipated in the step by the friction of bodies, J.
    double friction_loss(const Positions& x) const;
    void add_touch(const Positions& x, Touch& touch) const;
    /// Work, J, of deforming obstacles on bodies in the step.
    double work_of_deforming() const;
    /// Adds the obstacles' forces on bodies to the reactions.
    void add_reactions(std::span<Reaction> of_obstacles) const;
    /// Work, J, of contact forces on the bodies in the step that end_step() has ended last; work_of_all():
    /// work of all forces, weight included.
    double contact_work() const;
    double work_of_all() const;
    double kinetic_change() const;  ///< J, change of the bodies' kinetic energy in that step
    /// Visits the state that begin() and topology_changed() do not compute.
    void visit_state(StateVisitor& visit) override {
        auto& [shell, obstacles, gravity, started, finished, ended, pairs, surfaces, steps, obstacle_starts,
               obstacle_places, points, sliding, sticks_with_shell, sticks_with_points, start_stored,
               is_blocked, at] = *this;
        visit(started, finished, pairs, surfaces, sticks_with_shell, sticks_with_points);
    }

  private:
    /// A contact point that touched another collider at the beginning of the step.
    struct SlidingContact {
        std::size_t number;  ///< index in `points`
        std::size_t body, other;
        Vector3d point;        ///< m, point of the body that touches the other collider, in the body's frame
        SlidingPoint sliding;  ///< the anchor is in the frame of the other collider
    };

    ContactSurface with_surface(std::size_t body) const;
    /// Makes `steps`, and finds the contacts of the step from the poses at its beginning.
    void make_steps(const StepContext& step);
    void place_obstacles(double time);
    void find_sliding(const StepContext& step);
    /// Whether no body that moves straight to its prediction ends too far beyond the first contact with a
    /// sheet or with another collider. The shell moves to x [3, V] meanwhile.
    bool have_straight_paths(const Positions& x) const;
    /// Moves bodies along with colliders that would enter them: sets their columns in `at`, and sets
    /// is_blocked if this is impossible.
    void move_with_colliders();
    bool is_free(std::size_t collider) const { return collider < steps.size(); }
    const Collider& collider(std::size_t number) const;
    /// Pose of a collider at the beginning of the step.
    Eigen::Isometry3d start_of(std::size_t number) const {
        return is_free(number) ? started[number].pose() : obstacle_starts[number - steps.size()];
    }
    PairPlaces start_of(const SurfacePairs& pair) const {
        return {start_of(pair.body), start_of(pair.other), true};
    }
    static PairPlaces places_of(const SurfacePairs& pair, const std::vector<BodyPose>& poses) {
        return {poses[pair.body].place, poses[pair.other].place};
    }
    Positions shell_part(const Positions& x) const { return x.leftCols(shell.mass.size()); }
    BodyColumns placed(std::size_t body) const {
        return at.middleCols<2>(static_cast<Eigen::Index>(2 * body));
    }
    /// Poses of all colliders at the end of the step; the last 2 B of `columns` are the bodies' columns.
    std::vector<BodyPose> poses(const Positions& columns) const;
    /// Overlap of a contact point with the other collider; margin: m, added to the contact radius.
    Overlap overlap_of(const PointContact& contact, const std::vector<BodyPose>& poses,
                       double margin = 0) const;
    // The following functions call add(force, hessian) for each force, as BodyStep::each_force() does. x: [3,
    // V] m, positions of the shell.
    template <class Add>
    void each_force(const Positions& x, const std::vector<BodyPose>& poses, Add add) const;
    template <class Add>
    void each_point_force(const std::vector<BodyPose>& poses, Add add) const;
    template <class Add>
    void each_surface_force(const std::vector<BodyPose>& poses, Add add) const;
    double stored_energy(const Positions& x, const std::vector<BodyPose>& poses) const;
    /// Calls use(point, column, motion) for each point of the force and each column of the unknowns that
    /// moves the point. point: index in BodyForce::points; motion: derivative of the point's position by the
    /// column.
    template <class Use>
    void each_column(const BodyForce& force, const std::vector<BodyPose>& poses, Use use) const;
    /// Returns `surfaces`, but none before the first step, when colliders have no poses yet.
    std::span<const std::unique_ptr<SurfacePairs>> surfaces_of_step() const {
        return std::span(surfaces).first(steps.empty() ? 0 : surfaces.size());
    }
    /// Appends the pairs of columns that are likely to have a block in the Hessian after small motions.
    void add_upcoming(const Positions& x, std::vector<std::pair<Index, Index>>& pairs) const;
    bool are_near(const SurfacePairs& pair, const std::vector<BodyPose>& poses) const;
    /// Angle, rad, of a body's rotation in the step; the last 2 B of `columns` are the bodies' columns.
    double turn_of(std::size_t body, const Positions& columns) const;
    double largest_turn_in(const Positions& motion) const;  ///< rad, largest turn_of() of all bodies
    // Fraction, 0 to 1, of a motion of shell and bodies from x up to which they do not reach each other.
    // free_fraction() divides the motion into parts, and free_fraction_of_part() takes the motion of the
    // shell in a body's frame as straight from x to `after`. checked_fraction() also checks the path to the
    // poses at the end of the shortened motion.
    double free_fraction(const Positions& x, const Positions& motion) const;
    double free_fraction_of_part(const Positions& x, const Positions& after) const;
    double checked_fraction(const Positions& x, const Positions& motion) const;
    /// Whether the surfaces of a pair pass through each other in the step that ends at place().
    bool passes(const StepContext& step, const SurfacePairs& pair) const;

    const Shell& shell;
    const std::vector<Obstacle>& obstacles;
    Vector3d gravity;
    /// The bodies at the beginning of the step, at the end of the last finished step, and at the end of the
    /// open step.
    std::vector<RigidBody> started, finished, ended;
    /// Pairs of the shell and each body's surface; null without a surface.
    std::vector<std::unique_ptr<NearPairs>> pairs;
    std::vector<std::unique_ptr<SurfacePairs>> surfaces;
    std::vector<BodyStep> steps;
    /// Poses at the beginning and at the end of the step.
    std::vector<Eigen::Isometry3d> obstacle_starts, obstacle_places;
    std::vector<PointContact> points;
    std::vector<SlidingContact> sliding;
    /// Elastic slip at the end of the last finished step: for each body, of its contacts with the shell; and,
    /// by index in `points`, of contact points.
    std::vector<BodySticks> sticks_with_shell;
    StickMemory<std::size_t> sticks_with_points;
    double start_stored = 0;  ///< J, see stored_at_start()
    bool is_blocked = false;
    Positions at;  ///< see place()
};

}  // namespace sherd
