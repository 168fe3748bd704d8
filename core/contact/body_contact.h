// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/body_step.h"
#include "core/energy.h"

namespace sherd {

/// All free rigid bodies in one step, with a sheet, with obstacles and with each other. The energy is that of
/// the best poses: E(x) = min over q of P(x, q), where q are the displacements and rotation vectors of all
/// bodies in the step, and P the sum of their potentials (BodyStep) and of the springs and the friction
/// between them. dE/dx is then P's derivative at these poses, and d2E/dx2 the Schur complement P_xx - P_xq
/// P_qq^-1 P_qx: Newton's method on x alone solves for sheet and bodies together. On the way to the best
/// poses, too, no motion leads through the sheet; the least is looked for from the poses on that the bodies
/// had when safe_fraction() was last asked.
///
/// Bodies meet each other by springs, by their feet: a ball with its surface, a box with its corners, which
/// are in the other body's shape; not the edges of two boxes.
class BodyContact : public Energy {
  public:
    /// q: poses at which the bodies and the sheet at the positions that are asked for next are apart, [6 B];
    /// step: s.
    BodyContact(std::vector<BodyStep> bodies, double step, const VectorXd& q);
    double value(const Positions& x) const override;
    void add_gradient(const Positions& x, Positions& gradient) const override;
    void add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const override;
    Task task() const override { return Task::contact; }
    void add_pattern(std::vector<std::pair<Index, Index>>&) const override {}
    void add_contacts(const Positions& x, bool ahead,
                      std::vector<std::pair<Index, Index>>& pairs) const override;
    double safe_fraction(const Positions& x, const Positions& motion) const override;

    /// The bodies at the end of a step in which the sheet moves to x.
    std::vector<RigidBody> moved(const Positions& x) const;
    /// Poses q at which the bodies and the sheet were apart when safe_fraction() was last asked, and on all
    /// of the motion that it granted.
    const VectorXd& apart() const { return base; }
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
    /// A foot of one body against the shape of another one.
    struct Meeting {
        std::size_t one, other;
        Vector3d foot;     ///< m, in the first one's frame
        double stiffness;  ///< N/m
    };
    /// The sliding of a meeting that was one at the beginning of the step.
    struct SlidingMeeting {
        std::size_t one, other;
        SlidingFoot foot;
    };

    void find_meetings();
    void find_sliding(double step);
    Vector6d part(const VectorXd& q, std::size_t body) const { return q.segment<6>(6 * body); }
    Potential potential(const Positions& x, const VectorXd& q) const;
    /// margin: m, around the foot's skin.
    Overlap overlap_of(const Meeting& meeting, const VectorXd& q, double margin = 0) const;
    void add_meetings(const VectorXd& q, Potential& sum) const;
    /// Adds a force between two bodies, by the position of the first one's point at `arm` from its centre
    /// against that of the second one's at `other_arm`.
    void add_between(const VectorXd& q, std::size_t one, std::size_t other, const Vector3d& arm,
                     const Vector3d& other_arm, const Vector3d& gradient, const Matrix3d& hessian,
                     Potential& sum) const;
    /// Of each body the first of those that it touches, over others too; `ahead`: or may touch soon.
    std::vector<std::size_t> groups(const VectorXd& q, bool ahead) const;
    double free_way(const Positions& x, const VectorXd& from, const VectorXd& to) const;
    /// A step of Newton's method on q; false when there is nothing more to gain.
    bool improve(const Positions& x) const;
    /// The best poses for x; kept until x changes.
    const Potential& solve(const Positions& x) const;

    std::vector<BodyStep> bodies;
    std::vector<Meeting> meetings;
    std::vector<SlidingMeeting> sliding;
    // Kept to save time, but for `base`: where bodies were when the sheet was last known to be apart from
    // them.
    mutable VectorXd base;
    mutable Positions last;
    mutable VectorXd best;
    mutable Potential at_best;
};

}  // namespace sherd
