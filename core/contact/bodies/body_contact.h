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

/// Contact of rigid bodies in one step: with the shell, with each other and with obstacles, which are
/// colliders whose motion is given. The energy is that of the optimal poses: E(x) = min over q of P(x, q),
/// where q holds the displacements and rotation vectors of all bodies in the step, and P is the sum of their
/// potentials (BodyStep) and of the springs and the friction between them. dE/dx is the derivative of P at
/// these poses, and d2E/dx2 the Schur complement P_xx - P_xq P_qq^-1 P_qx: Newton's method on x alone solves
/// for shell and bodies together. The search for the optimal poses never moves a body through the shell; it
/// starts from the optimal poses for the minimiser's current iterate, which moved_to() gives.
///
/// Springs act between two bodies, and between a body and an obstacle, at the body's contact points: the
/// centre of a ball with its radius, the corners of a box or of a mesh. A contact is found when such a point
/// is in the other collider's shape. Contacts without such a point, above all those of edges, are found by
/// SurfacePairs, whose barriers nothing passes.
class BodyContact : public Energy {
  public:
    /// bodies: their state at the start of the run. Shell and obstacles must outlive this object. gravity:
    /// m/s^2. crossed: see surface_pairs().
    BodyContact(const Shell& shell, std::vector<RigidBody> bodies, const std::vector<Obstacle>& obstacles,
                const Vector3d& gravity, std::span<const char> crossed = {});
    void begin(const StepContext& step) override;
    void topology_changed(const ShellChange& change, const StepContext& step) override;
    void moved_to(const Positions& x) override;
    /// Whether the step is too long for the bodies: without contact, a body would end too many of its own
    /// widths beyond what it hits, or an obstacle moves into a body that cannot get out of its way. The
    /// optimal poses of such a step are not what the impact leads to, and are hard to find.
    bool blocked() const { return is_blocked; }
    /// Moves the bodies to the end of the step, with the shell at x [3, V] m; the step stays open.
    void end_at(const Positions& x);
    /// Whether the optimal poses have been found for the shell at x. If not, the step is too long for the
    /// bodies.
    bool have_optimal_poses(const Positions& x) const;
    /// Whether a body passes through the shell, which moves straight to x, or through another body or an
    /// obstacle, in the step. Bodies move along their screws, obstacles by their motion.
    bool passes(const StepContext& step, const Positions& x) const;
    /// Ends the step with the shell at x.
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

    double stored_energy(const Positions& x) const;          ///< elastic energy of the contacts, J
    double stored_at_start() const { return start_stored; }  ///< J, at the beginning of the step
    /// Energy dissipated by friction in the step that ends at x, J.
    double friction_loss(const Positions& x) const;
    /// Work, J, of contact forces on the bodies in their last step (end_at()); work_of_all(): of all forces,
    /// weight included.
    double contact_work() const;
    double work_of_all() const;
    double kinetic_change() const;  ///< J, in that step
    void add_touch(const Positions& x, Touch& touch) const;
    /// Work, J, of deforming obstacles on bodies in the step, with the shell at x.
    double work_of_deforming(const Positions& x) const;
    /// Adds the obstacles' forces on bodies, when the shell is at x, to the reactions.
    void add_reactions(const Positions& x, std::span<Reaction> of_obstacles) const;
    /// Visits the state that begin() and topology_changed() do not compute.
    void visit_state(StateVisitor& visit) override {
        auto& [shell, obstacles, gravity, started, finished, ended, pairs, surfaces, steps, obstacle_starts,
               obstacle_places, points, sliding, sticks_with_shell, sticks_with_points, start_stored,
               is_blocked, base, last, best, at_best] = *this;
        visit(started, finished, pairs, surfaces, sticks_with_shell, sticks_with_points);
    }

  private:
    /// P and its derivatives by q. Derivatives by x are stored with each body.
    struct Potential {
        double value = 0, stored = 0;  ///< J
        VectorXd gradient;             ///< [6 B]
        Eigen::MatrixXd hessian;
        std::vector<BodyPotential> bodies;
        std::vector<double> turning;  ///< N m, of each body, see BodyPotential
    };
    /// A contact point that touched another collider at the beginning of the step.
    struct SlidingContact {
        std::size_t number;  ///< in `points`
        std::size_t body, other;
        Vector3d point;        ///< m, point of contact in the body's frame
        SlidingPoint sliding;  ///< anchor in the frame of the other collider
    };

    ContactSurface with_surface(std::size_t body) const;
    /// Makes the bodies' potentials and the contacts of the step from the poses at its beginning.
    void make_steps(const StepContext& step);
    void place_obstacles(double time);
    void find_sliding(const StepContext& step);
    /// Whether no body, on the straight way to q, gets more than `widths` of its widths beyond a sheet, or
    /// `widths_in_collider` of them beyond another collider, that it hits.
    bool have_straight_paths(const Positions& x, const VectorXd& q, double widths,
                             double widths_in_collider) const;
    /// Moves bodies along with colliders that move into them, in `base`.
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
    static PairPlaces places_of(const SurfacePairs& pair, const std::vector<BodyPose>& at) {
        return {at[pair.body].place, at[pair.other].place};
    }
    /// Poses of all colliders when the bodies are at q.
    std::vector<BodyPose> poses(const VectorXd& q) const;
    Vector6d part(const VectorXd& q, std::size_t body) const { return q.segment<6>(6 * body); }
    Potential potential(const Positions& x, const VectorXd& q) const;
    /// Overlap of a contact point with the other collider; margin: m, added to the contact radius.
    Overlap overlap_of(const PointContact& contact, const std::vector<BodyPose>& poses,
                       double margin = 0) const;
    /// Calls add(at, body, other, force, x, anchor, elastic) for each force on a point x of a body from
    /// another collider; at: poses(q).
    template <class Add>
    void each_point_force(const VectorXd& q, Add add) const;
    void add_point_contacts(const VectorXd& q, Potential& sum) const;
    /// Surface pairs; none before the first step, when colliders have no poses yet.
    std::span<const std::unique_ptr<SurfacePairs>> surfaces_of_step() const {
        return std::span(surfaces).first(steps.empty() ? 0 : surfaces.size());
    }
    /// Calls add(pairs, vertices, at, moved, gradient, hessian, value, elastic) for each pair of surfaces;
    /// at: m, [3, 4], in space; moved: m, [3, 4], displacements in the step, zero for elastic forces.
    template <class Add>
    void each_surface_force(const std::vector<BodyPose>& at_q, Add add) const;
    void add_surface_pairs(const VectorXd& q, Potential& sum) const;
    /// Adds a force on the point x of a body, and the opposite force on the point `anchor` of another
    /// collider.
    void add_between(const std::vector<BodyPose>& poses, std::size_t body, std::size_t other,
                     const PointForce& force, const Vector3d& x, const Vector3d& anchor,
                     Potential& sum) const;
    /// For each body, the smallest number of a body that it is connected to by contacts, directly or through
    /// others. `ahead` also counts bodies that are near contact.
    std::vector<std::size_t> groups(const VectorXd& q, bool ahead) const;
    double free_fraction(const Positions& x, const VectorXd& from, const VectorXd& to) const;
    bool passes(const StepContext& step, const SurfacePairs& pair) const;  ///< when bodies get to `best`
    bool is_small(const VectorXd& correction) const;
    /// The correction of Newton's method at the best q so far.
    VectorXd correction() const;
    /// Takes one step of Newton's method on q. Returns false when the potential cannot be lowered further.
    bool improve(const Positions& x) const;
    /// The potential at the optimal poses for x, which are kept until x changes.
    const Potential& solve(const Positions& x) const;

    const Shell& shell;
    const std::vector<Obstacle>& obstacles;
    Vector3d gravity;
    /// States at the beginning of the step, at the end of the last finished step, and at the end of the open
    /// one.
    std::vector<RigidBody> started, finished, ended;
    std::vector<std::unique_ptr<NearPairs>> pairs;  ///< shell and each body's surface; null without one
    std::vector<std::unique_ptr<SurfacePairs>> surfaces;
    std::vector<BodyStep> steps;
    std::vector<Eigen::Isometry3d> obstacle_starts,
        obstacle_places;  ///< at the beginning and end of the step
    std::vector<PointContact> points;
    std::vector<SlidingContact> sliding;
    /// Elastic slip at the end of the last finished step: of each body's contacts with the shell, and by
    /// number of a contact point.
    std::vector<BodySticks> sticks_with_shell;
    StickMemory<std::size_t> sticks_with_points;
    double start_stored = 0;  ///< J
    bool is_blocked = false;
    /// [6 B], empty before the first step: motions to poses free of overlap with the shell, where solve()
    /// starts.
    VectorXd base;
    // Caches: no result depends on them.
    mutable Positions last;
    mutable VectorXd best;
    mutable Potential at_best;
};

}  // namespace sherd
