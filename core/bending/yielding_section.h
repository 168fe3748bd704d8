// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/vector.h"

namespace sherd {

/// Plastic bending of a face.
struct PlasticBend {
    Vector3d curvature = Vector3d::Zero();  ///< change of curvature, (00, 11, 2 * 01), 1/m, without moment
    double passed = 0;                      ///< plastic curvature accumulated in all directions, 1/m
};

/// Moment over yield moment, M / M_y, that a section of an elastic and perfectly plastic material bears after
/// a plastic curvature. passed: this curvature, in multiples of the curvature k_y at which the section's
/// surface begins to yield. The layers of the section yield from the surfaces inwards, so that M / M_y = 3/2
/// - (k_y / k)^2 / 2 at the curvature k; if the whole section yields, this is 3/2.
double share_of_yield_moment(double passed);

/// The bending of a square metre of a plate that yields: an elastic plate whose moment m (00, 11, 01), N, is
/// limited. The von Mises moment, sqrt(m00^2 + m11^2 - m00 m11 + 3 m01^2), does not exceed a limit, which
/// begins at the yield moment and grows by share_of_yield_moment(). For a section that is bent in one
/// direction and then unloaded this is exact. In general it is J2 plasticity of the resultants with isotropic
/// hardening (Crisfield's modified Ilyushin criterion without membrane forces); therefore a section that is
/// bent in the opposite direction afterwards yields too late. The plastic curvature of a step is found at the
/// end of the step, so that the moment is the derivative of a potential of the curvature.
class YieldingSection {
  public:
    /// rigidity: N m, symmetric and positive definite; yield_moment: N, yield stress times t^2 / 6.
    YieldingSection(const Matrix3d& rigidity, double yield_moment)
        : rigidity(rigidity), yield_moment(yield_moment) {}

    struct State {
        Vector3d moment;      ///< N
        PlasticBend plastic;  ///< plastic bending if the step ends in this state
        double stored = 0;    ///< J/m^2, elastic energy
        double taken = 0;     ///< J/m^2, dissipated in the step
    };
    /// Returns the state at the change of curvature `bent`, (00, 11, 2 * 01), 1/m, in a step that began with
    /// the plastic bending `before`.
    State at(const Vector3d& bent, const PlasticBend& before) const;
    /// Derivative of the moment by the curvature, N m, in a state that at() has found with the same `before`:
    /// symmetric and positive definite.
    Matrix3d tangent(const State& state, const PlasticBend& before) const;

  private:
    /// Reduces the moment of `state` to a moment that the section bears, and enters the plastic bending.
    /// elastic: change of curvature less the plastic curvature before, 1/m.
    void yield(const Vector3d& elastic, State& state) const;
    double moment_after(double passed) const;  ///< N, limit of the von Mises moment
    double first_curvature() const;  ///< 1/m, curvature in one direction at which the surface yields
    /// Energy, J/m^2, that has been dissipated when the accumulated plastic curvature is `passed` (1/m).
    double work_after(double passed) const;

    Matrix3d rigidity;
    double yield_moment;
};

}  // namespace sherd
