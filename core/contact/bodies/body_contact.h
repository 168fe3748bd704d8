// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/bodies/body_step.h"
#include "core/contact/colliders/obstacle.h"
#include "core/energy.h"

namespace sherd {

/// The rigid world in one step: free bodies with a sheet, with each other and with obstacles, which are
/// bodies whose motion is given. The energy is that of
/// the best poses: E(x) = min over q of P(x, q), where q are the displacements and rotation vectors of all
/// bodies in the step, and P the sum of their potentials (BodyStep) and of the springs and the friction
/// between them. dE/dx is then P's derivative at these poses, and d2E/dx2 the Schur complement P_xx - P_xq
/// P_qq^-1 P_qx: Newton's method on x alone solves for sheet and bodies together. On the way to the best
/// poses, too, no motion leads through the sheet; the least is looked for from the best poses of where the
/// minimiser is, which moved_to() says.
///
/// Bodies meet each other, and obstacles, by springs, by their feet: a ball with its surface, a box with its
/// corners, which are in the other one's shape; not the edges of two boxes.
class BodyContact : public Energy {
  public:
    /// bodies: as they are at the start of the run. Sheet and obstacles must outlive it. gravity: m/s^2.
    BodyContact(const Sheet& sheet, std::vector<RigidBody> bodies, const std::vector<Obstacle>& obstacles,
                const Vector3d& gravity);
    void begin(const StepContext& step) override;
    void topology_changed(const ShellChange& change, const StepContext& step) override;
    void moved_to(const Positions& x) override;
    /// Ends the step with the sheet at x.
    void finish(const Positions& x);
    /// At the end of the last step that was finished.
    const std::vector<RigidBody>& bodies() const { return finished; }

    double value(const Positions& x) const override;
    void add_gradient(const Positions& x, Positions& gradient) const override;
    void add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const override;
    Task task() const override { return Task::contact; }
    void add_contacts(const Positions& x, bool ahead,
                      std::vector<std::pair<Index, Index>>& pairs) const override;
    double safe_fraction(const Positions& x, const Positions& motion) const override;

    double stored_energy(const Positions& x) const;  ///< J, elastic, in the contacts
    void add_touch(const Positions& x, Touch& touch) const;

  private:
    /// P and its derivatives by q; the others are those of each body.
    struct Potential {
        double value = 0, stored = 0;  ///< J
        VectorXd gradient;             ///< [6 B]
        Eigen::MatrixXd hessian;
        std::vector<BodyPotential> bodies;
    };
    /// A foot of a body against the shape of another collider: bodies are numbered first, then obstacles.
    struct FootContact {
        std::size_t body, other;
        Vector3d foot;  ///< m, in the body's frame
    };
    /// A foot that touched another collider at the beginning of the step.
    struct SlidingFoot {
        std::size_t body, other;
        Vector3d foot;       ///< m, where it touched, in the body's frame
        SlidingPoint point;  ///< with the anchor in the other one's frame
    };

    /// Makes the bodies' potentials in the step, from where they are at its beginning.
    void make_steps(const StepContext& step);
    void find_feet();
    void find_sliding(const StepContext& step);
    bool is_free(std::size_t collider) const { return collider < steps.size(); }
    const Collider& collider(std::size_t number) const;
    /// Where it stands when the bodies are at q.
    Eigen::Isometry3d place(std::size_t collider, const VectorXd& q) const;
    Vector6d part(const VectorXd& q, std::size_t body) const { return q.segment<6>(6 * body); }
    Potential potential(const Positions& x, const VectorXd& q) const;
    /// margin: m, around the foot's skin.
    Overlap overlap_of(const FootContact& contact, const VectorXd& q, double margin = 0) const;
    void add_feet(const VectorXd& q, Potential& sum) const;
    /// Adds the force on the point x of a body, and the opposite one on the point `anchor` of another
    /// collider.
    void add_between(const VectorXd& q, std::size_t body, std::size_t other, const PointForce& force,
                     const Vector3d& x, const Vector3d& anchor, Potential& sum) const;
    /// Of each body the first of those that it touches, over others too; `ahead`: or may touch soon.
    std::vector<std::size_t> groups(const VectorXd& q, bool ahead) const;
    double free_way(const Positions& x, const VectorXd& from, const VectorXd& to) const;
    /// A step of Newton's method on q; false when there is nothing more to gain.
    bool improve(const Positions& x) const;
    /// The best poses for x; kept until x changes.
    const Potential& solve(const Positions& x) const;

    const Sheet& sheet;
    const std::vector<Obstacle>& obstacles;
    Vector3d gravity;
    std::vector<RigidBody> started,
        finished;  ///< at the beginning of the step, and at the end of the last one
    std::vector<std::unique_ptr<NearPairs>> pairs;  ///< with the surface of each body; null: it has none
    std::vector<BodyStep> steps;
    std::vector<Eigen::Isometry3d> obstacle_places;  ///< at the end of the step
    std::vector<FootContact> feet;
    std::vector<SlidingFoot> sliding;
    VectorXd
        base;  ///< [6 B] poses at which bodies and sheet are apart, from which the best ones are looked for
    // Kept to save time; no answer depends on them.
    mutable Positions last;
    mutable VectorXd best;
    mutable Potential at_best;
};

}  // namespace sherd
