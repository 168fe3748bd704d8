// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/vector.h"

namespace sherd {

/// Plastic bending of a face.
struct PlasticBend {
    Vector3d curvature = Vector3d::Zero();  ///< (00, 11, 2 * 01), 1/m, at which it has no moment
    double passed = 0;                      ///< accumulated plastic curvature, in all directions, 1/m
};

/// Moment over yield moment that a section of an elastic and perfectly plastic material bears after the
/// plastic curvature `passed`, in multiples of the curvature at which its surface begins to yield: its layers
/// yield from the surfaces inwards, and M / M_y = 3/2 - (k_y / k)^2 / 2, up to the 3/2 of a section that
/// yields as a whole.
double share_of_yield_moment(double passed);

/// The bending of a square metre of a plate that yields: an elastic plate whose moment (00, 11, 01), N, stays
/// within a von Mises moment, sqrt(m00^2 + m11^2 - m00 m11 + 3 m01^2), which grows from the yield moment on
/// by share_of_yield_moment(). In one direction this is exact, for a section that is bent and bent back; for
/// the rest it is J2 plasticity of the resultants with isotropic hardening (Crisfield's modified Ilyushin
/// criterion without membrane forces), so that a section that is bent the other way yields too late.
/// The plastic curvature of a step is found at its end, so that the moment is the derivative of a potential
/// of the curvature.
class YieldingSection {
  public:
    /// rigidity: N m, symmetric and positive definite; yield_moment: N, yield stress times t^2 / 6.
    YieldingSection(const Matrix3d& rigidity, double yield_moment)
        : rigidity(rigidity), yield_moment(yield_moment) {}

    struct State {
        Vector3d moment;      ///< N
        PlasticBend plastic;  ///< plastic bending if the step ends there
        double stored = 0;    ///< J/m^2, elastic
        double taken = 0;     ///< J/m^2, dissipated in the step
    };
    /// State at a change of curvature (00, 11, 2 * 01), 1/m, in a step that began with `before`.
    State at(const Vector3d& bent, const PlasticBend& before) const;
    /// Derivative of the moment by the curvature in that state, N m: symmetric and positive definite.
    Matrix3d tangent(const State& state, const PlasticBend& before) const;

  private:
    /// Reduces an elastic moment to one that the section bears. elastic: curvature of the elastic moment,
    /// 1/m.
    void yield(const Vector3d& elastic, State& state) const;
    double moment_after(double passed) const;  ///< N, von Mises moment borne after this plastic curvature
    double first_curvature() const;  ///< 1/m, curvature in one direction at which the surface yields
    /// Energy dissipated by plastic curvature since the beginning, J/m^2.
    double work_after(double passed) const;

    Matrix3d rigidity;
    double yield_moment;
};

}  // namespace sherd
