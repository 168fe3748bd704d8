// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/vector.h"

namespace sherd {

/// What a face has kept of being bent.
struct KeptBend {
    Vector3d curvature = Vector3d::Zero();  ///< (00, 11, 2 * 01), 1/m, at which it has no moment
    double passed = 0;                      ///< plastic curvature that it has gone through, to and fro, 1/m
};

/// How much of the yield moment a section of an elastic and perfectly plastic material bears after a plastic
/// curvature, in multiples of the curvature at which its surface begins to yield: its layers yield from the
/// surfaces inwards, and M / M_y = 3/2 - (k_y / k)^2 / 2, up to the 3/2 of a section that yields as a whole.
double share_of_yield_moment(double passed);

/// The bending of a square metre of a plate that yields: an elastic plate whose moment (00, 11, 01), N, stays
/// within a von Mises moment, sqrt(m00^2 + m11^2 - m00 m11 + 3 m01^2), which grows from the yield moment on
/// by share_of_yield_moment(). In one direction this is exact, for a section that is bent and bent back; for
/// the rest it is J2 plasticity of the resultants with isotropic hardening (Crisfield's modified Ilyushin
/// criterion without membrane forces), so that a section that is bent the other way yields too late.
/// What a step keeps is found at its end: a potential of the curvature, of which the moment is the
/// derivative.
class YieldingSection {
  public:
    /// rigidity: N m, symmetric and positive definite; yield_moment: N, yield stress times t^2 / 6.
    YieldingSection(const Matrix3d& rigidity, double yield_moment)
        : rigidity(rigidity), yield_moment(yield_moment) {}

    struct State {
        Vector3d moment;    ///< N
        KeptBend kept;      ///< when the step ends there
        double stored = 0;  ///< J/m^2, elastic
        double taken = 0;   ///< J/m^2, by what is kept more than before
    };
    /// With a change of curvature (00, 11, 2 * 01), 1/m, in a step that began with `before`.
    State at(const Vector3d& bent, const KeptBend& before) const;
    /// Derivative of the moment by the curvature there, N m: symmetric and positive definite.
    Matrix3d tangent(const State& state, const KeptBend& before) const;

  private:
    /// Takes from an elastic moment what the section does not bear. elastic: 1/m, that the moment is of.
    void yield(const Vector3d& elastic, State& state) const;
    double moment_after(double passed) const;  ///< N, that is borne then
    double first_curvature() const;            ///< 1/m, in one direction, at which the surface yields
    /// J/m^2, that plastic curvature has taken since the beginning.
    double work_after(double passed) const;

    Matrix3d rigidity;
    double yield_moment;
};

}  // namespace sherd
