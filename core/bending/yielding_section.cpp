// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bending/yielding_section.h"

#include <Eigen/LU>
#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace sherd {
namespace {

/// Matrix P such that the root of m^T P m is the von Mises moment.
Matrix3d mises_form() {
    return Matrix3d{{1, -0.5, 0}, {-0.5, 1, 0}, {0, 0, 3}};
}

double mises(const Vector3d& moment) {
    return std::sqrt(moment.dot(mises_form() * moment));
}

/// Returns the curvature u after the plastic curvature `passed`; the unit of both is the curvature at which
/// the surface begins to yield. u is the root >= 1 of u^3 - (3/2 + passed) u^2 + 1/2, which Newton's method
/// approaches from above.
double curvature_after(double passed) {
    double u = 1.5 + passed;
    for (int i = 0; i < 100; ++i) {
        const double next = u - (u * u * (u - 1.5 - passed) + 0.5) / (u * (3 * u - 3 - 2 * passed));
        if (!(next < u) || next < 1) break;
        u = next;
    }
    return u;
}

constexpr double least_hardening = 1e-6;  // share of the elastic rigidity, with which the tangent stays
                                          // definite

}  // namespace

double share_of_yield_moment(double passed) {
    const double u = curvature_after(passed);
    return 1.5 - 0.5 / (u * u);
}

double YieldingSection::first_curvature() const {
    return yield_moment * rigidity.inverse()(0, 0);
}

double YieldingSection::moment_after(double passed) const {
    return yield_moment * share_of_yield_moment(passed / first_curvature());
}

double YieldingSection::work_after(double passed) const {
    // The integral of M/M_y (1 - u^-3) du from 1 to u.
    const double u = curvature_after(passed / first_curvature()), v = 1 / u;
    const double integral = 1.5 * u + v * (0.5 + v * (0.75 - 0.125 * v * v)) - 2.625;
    return yield_moment * first_curvature() * integral;
}

YieldingSection::State YieldingSection::at(const Vector3d& bent, const PlasticBend& before) const {
    const Vector3d elastic = bent - before.curvature;
    State state{rigidity * elastic, before};
    if (mises(state.moment) > moment_after(before.passed)) yield(elastic, state);
    state.stored = 0.5 * state.moment.dot(bent - state.plastic.curvature);
    return state;
}

void YieldingSection::yield(const Vector3d& elastic, State& state) const {
    // The moment at the end follows from the rigidity D lowered by yielding: (D^-1 + share P)^-1.
    const Matrix3d compliance = rigidity.inverse();
    const auto lowered = [&](double share) {
        return Vector3d((compliance + share * mises_form()).inverse() * elastic);
    };
    const PlasticBend before = state.plastic;
    const auto beyond = [&](double share) {
        const double moment = mises(lowered(share));
        return moment - moment_after(before.passed + share * moment);
    };
    if (beyond(0) <= 0) return;  // the moment exceeds the limit by round-off alone
    double most = compliance(0, 0);
    while (beyond(most) > 0) most *= 2;
    std::uintmax_t calls = 200;
    const auto [least, enough] = boost::math::tools::toms748_solve(
        beyond, 0.0, most, boost::math::tools::eps_tolerance<double>(), calls);
    const double share = std::midpoint(least, enough);
    state.moment = lowered(share);
    state.plastic.passed += share * mises(state.moment);
    state.plastic.curvature += elastic - compliance * state.moment;
    state.taken = work_after(state.plastic.passed) - work_after(before.passed);
}

Matrix3d YieldingSection::tangent(const State& state, const PlasticBend& before) const {
    const double passed = state.plastic.passed - before.passed;
    if (!(passed > 0)) return rigidity;
    const double moment = mises(state.moment);
    const Vector3d along = mises_form() * state.moment / moment;
    const Matrix3d turning = mises_form() / moment - along * along.transpose() / moment;
    const Matrix3d beside = (rigidity.inverse() + passed * turning).inverse();
    const double u = curvature_after(state.plastic.passed / first_curvature()), left = 1 / (u * u * u);
    const double hardening =
        yield_moment / first_curvature() * std::max(least_hardening, left / std::max(1 - left, 1e-12));
    const Vector3d across = beside * along;
    return beside - across * across.transpose() / (along.dot(across) + hardening);
}

}  // namespace sherd
