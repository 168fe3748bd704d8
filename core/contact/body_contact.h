// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/friction.h"
#include "core/contact/obstacle.h"
#include "core/contact/rigid_body.h"
#include "core/energy.h"
#include "core/sheet.h"

namespace sherd {

/// A free rigid body in one step: its inertia, weight, contact with a sheet's vertices and with obstacles.
/// Both ends of every contact feel the same force. The energy is that of the best pose: E(x) = min over q of
/// P(x, q), where q are the displacement and the rotation vector of the body in the step and P is its
/// incremental potential (implicit Euler, as for the sheet: m / (2 h^2) |c - c_n - h v_n - h^2 g|^2, with the
/// inertia of the step's beginning for the rotation) plus the springs and friction of ObstacleContact. dE/dx
/// is then P's derivative at that pose, and d2E/dx2 the Schur complement P_xx - P_xq P_qq^-1 P_qx: Newton's
/// method on x alone solves for sheet and body together.
class BodyContact : public Energy {
  public:
    using Vector6d = Eigen::Matrix<double, 6, 1>;
    using Matrix6d = Eigen::Matrix<double, 6, 6>;
    using Matrix36d = Eigen::Matrix<double, 3, 6>;

    /// sheet and body as they are at the beginning of the step, at `time` (s); gravity: m/s^2. Sheet and
    /// obstacles must outlive it.
    BodyContact(const Sheet& sheet, const RigidBody& body, const std::vector<Obstacle>& obstacles,
                const Vector3d& gravity, double time, double step);
    double value(const Positions& x) const override;
    void add_gradient(const Positions& x, Positions& gradient) const override;
    void add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const override;
    Task task() const override { return Task::contact; }
    void add_pattern(std::vector<std::pair<Index, Index>>&) const override {}
    void add_contacts(const Positions& x, bool ahead,
                      std::vector<std::pair<Index, Index>>& pairs) const override;

    /// The body at the end of a step in which the sheet moves to x.
    RigidBody moved(const Positions& x) const;
    double stored_energy(const Positions& x) const;  ///< J, elastic, in the contacts
    Touch touch(const Positions& x) const;

  private:
    /// A vertex that touched at the beginning of the step.
    struct Sliding {
        Index vertex;
        Vector3d foot;  ///< m, where it was on the body, in its frame
        Matrix3d tangent;
        Friction friction;
    };
    /// What a vertex contributes to the derivatives of P.
    struct Push {
        Index vertex;
        Vector3d gradient = Vector3d::Zero();  ///< by x, N
        Matrix3d hessian = Matrix3d::Zero();   ///< by x twice, N/m
        Matrix36d mixed = Matrix36d::Zero();   ///< by x and q
    };
    /// P and its derivatives.
    struct Potential {
        double value = 0, stored = 0;
        Vector6d gradient = Vector6d::Zero();
        Matrix6d hessian = Matrix6d::Zero();
        std::vector<Push> pushes;  ///< ascending vertices
    };

    Eigen::Isometry3d pose(const Vector6d& q) const;
    Potential potential(const Positions& x, const Vector6d& q) const;
    void add_inertia(const Vector6d& q, Potential& sum) const;
    void add_obstacles(const Vector6d& q, Potential& sum) const;
    void add_sheet(const Positions& x, const Vector6d& q, Potential& sum) const;
    /// A step of Newton's method on q; false when there is nothing more to gain.
    bool improve(const Positions& x) const;
    /// The best pose for x; kept until x changes.
    const Potential& solve(const Positions& x) const;
    double stiffness(Eigen::Index vertex) const;  ///< N/m

    const Sheet& sheet;
    RigidBody body;
    const std::vector<Obstacle>& obstacles;
    double step, end;    ///< s
    Matrix3d inertia;    ///< kg m^2, in space
    Vector6d predicted;  ///< q without contact
    std::vector<Sliding> sliding;
    // Kept to save time.
    mutable Positions last;
    mutable Vector6d best;
    mutable Potential at_best;
};

}  // namespace sherd
