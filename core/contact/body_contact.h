// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/body_potential.h"
#include "core/contact/near_pairs.h"
#include "core/contact/obstacle.h"
#include "core/contact/rigid_body.h"
#include "core/contact/sheet_friction.h"
#include "core/energy.h"
#include "core/sheet.h"

namespace sherd {

/// What NearPairs need of a sheet and a body that has a surface.
ContactSurface surface_with(const Sheet& sheet, const RigidBody& body);

/// A free rigid body in one step: its inertia, weight, contact with a sheet's vertices, with its triangles
/// and edges by the body's surface, and with obstacles. Both ends of every contact feel the same force. The
/// energy is that of the best pose: E(x) = min over q of P(x, q), where q are the displacement and the
/// rotation vector of the body in the step and P is its incremental potential (implicit Euler, as for the
/// sheet: m / (2 h^2) |c - c_n - h v_n - h^2 g|^2, with the inertia of the step's beginning for the rotation)
/// plus the springs and friction of ObstacleContact and the barriers of SheetContact. dE/dx is then P's
/// derivative at that pose, and d2E/dx2 the Schur complement P_xx - P_xq P_qq^-1 P_qx: Newton's method on x
/// alone solves for sheet and body together. On the way to the best pose, too, no motion leads through the
/// sheet; the least is looked for from the pose on that the body had when safe_fraction() was last asked.
class BodyContact : public Energy {
  public:
    /// sheet and body as they are at the beginning of the step, at `time` (s); gravity: m/s^2. near: pairs of
    /// the sheet and the body's surface, which rests in its frame; null: it has none. q: a pose at which the
    /// body and the sheet at the positions that are asked for next are apart. Sheet, obstacles and near must
    /// outlive it.
    BodyContact(const Sheet& sheet, const RigidBody& body, const std::vector<Obstacle>& obstacles,
                const Vector3d& gravity, double time, double step, const NearPairs* near = nullptr,
                const Vector6d& q = Vector6d::Zero());
    double value(const Positions& x) const override;
    void add_gradient(const Positions& x, Positions& gradient) const override;
    void add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const override;
    void add_pattern(std::vector<std::pair<Index, Index>>&) const override {}
    void add_contacts(const Positions& x, bool ahead,
                      std::vector<std::pair<Index, Index>>& pairs) const override;
    double safe_fraction(const Positions& x, const Positions& motion) const override;

    /// The body at the end of a step in which the sheet moves to x.
    RigidBody moved(const Positions& x) const;
    /// A pose q at which the body and the sheet were apart when safe_fraction() was last asked, and on all of
    /// the motion that it granted.
    const Vector6d& apart() const { return base; }
    double stored_energy(const Positions& x) const;  ///< J, elastic, in the contacts
    void add_touch(const Positions& x, Touch& touch) const;

  private:
    /// A vertex that touched at the beginning of the step.
    struct Sliding {
        Index vertex;
        Vector3d foot;  ///< m, where it was on the body, in its frame
        Matrix3d tangent;
        Friction friction;
    };

    void find_sliding();
    BodyPose pose(const Vector6d& q) const;
    /// The body's points and the sheet's vertices, m, in the body's frame; what `near` is asked for.
    Positions seen_from(const BodyPose& pose, const Positions& x) const;
    BodyPotential potential(const Positions& x, const Vector6d& q) const;
    void add_inertia(const Vector6d& q, BodyPotential& sum) const;
    void add_obstacles(const BodyPose& here, BodyPotential& sum) const;
    void add_vertices(const Positions& x, const BodyPose& here, BodyPotential& sum) const;
    void add_pairs(const Positions& x, const BodyPose& here, BodyPotential& sum) const;
    void add_sliding_pairs(const Positions& x, const BodyPose& here, BodyPotential& sum) const;
    /// Fraction of the way from one q to another that is free of the sheet at x.
    double free_way(const Positions& x, const Vector6d& from, const Vector6d& to) const;
    /// A step of Newton's method on q; false when there is nothing more to gain.
    bool improve(const Positions& x) const;
    /// The best pose for x; kept until x changes.
    const BodyPotential& solve(const Positions& x) const;
    double stiffness(Eigen::Index vertex) const;  ///< N/m

    const Sheet& sheet;
    RigidBody body;
    const std::vector<Obstacle>& obstacles;
    const NearPairs* near;
    double step, end;    ///< s
    Matrix3d inertia;    ///< kg m^2, in space
    Vector6d predicted;  ///< q without contact
    std::vector<Sliding> sliding;
    std::vector<SlidingPair> sliding_pairs;  ///< with the body's points as the first vertices
    // Kept to save time, but for `base`: where the body was when the sheet was last known to be apart from
    // it.
    mutable Vector6d base;
    mutable Positions last;
    mutable Vector6d best;
    mutable BodyPotential at_best;
};

}  // namespace sherd
