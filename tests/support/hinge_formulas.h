// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "core/elements/hinge.h"

namespace sherd::test {

/// Formulas of the paper, literally and for any scalar type, as reference for the tests. No code is shared
/// with core/.
template <class Scalar>
using Vector = Eigen::Matrix<Scalar, 3, 1>;
template <class Scalar>
using Quad = Eigen::Matrix<Scalar, 3, 4>;

template <class Scalar>
Scalar dot(const Vector<Scalar>& a, const Vector<Scalar>& b) {
    return Scalar(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

template <class Scalar>
Vector<Scalar> cross(const Vector<Scalar>& a, const Vector<Scalar>& b) {
    return {Scalar(a[1] * b[2] - a[2] * b[1]), Scalar(a[2] * b[0] - a[0] * b[2]),
            Scalar(a[0] * b[1] - a[1] * b[0])};
}

template <class Scalar>
struct HingeEdges {
    Vector<Scalar> e0, e1, e2, e3, e4;

    explicit HingeEdges(const Quad<Scalar>& x)
        : e0(x.col(1) - x.col(0)),
          e1(x.col(2) - x.col(0)),
          e2(x.col(3) - x.col(0)),
          e3(x.col(2) - x.col(1)),
          e4(x.col(3) - x.col(1)) {}
    Scalar triple() const { return dot<Scalar>(cross<Scalar>(e0, e1), e2); }
};

inline double cotangent(const Vector3d& a, const Vector3d& b) {
    return a.dot(b) / cross<double>(a, b).norm();
}

inline double two_areas(const HingeEdges<double>& rest) {
    return 0.5 * (cross<double>(rest.e0, rest.e1).norm() + cross<double>(rest.e0, rest.e2).norm());
}

/// Eq. 4 with the true angle.
template <class Scalar>
Scalar nonlinear_energy(const HingePositions& rest, double stiffness, const Quad<Scalar>& x) {
    const HingeEdges<double> bar(rest);
    const HingeEdges<Scalar> e(x);
    const Vector<Scalar> n0 = cross<Scalar>(e.e0, e.e1), n1 = cross<Scalar>(e.e2, e.e0);
    using std::sqrt;
    const Scalar normals = sqrt(Scalar(dot<Scalar>(n0, n0) * dot<Scalar>(n1, n1)));
    const Scalar cosine = dot<Scalar>(n0, n1) / normals;
    const Scalar sine = sqrt(dot<Scalar>(e.e0, e.e0)) * e.triple() / normals;
    const double angle = hinge_angle(rest);
    const Scalar turned = Scalar(cosine * std::cos(angle) + sine * std::sin(angle));
    return Scalar(3 * stiffness * bar.e0.squaredNorm() / two_areas(bar) * (1 - turned));
}

/// Eq. 7 with the corrected k, by the edge normals t0 and t1 of eqs. 5 and 6.
template <class Scalar>
Scalar cubic_energy_2007(const HingePositions& rest, double stiffness, const Quad<Scalar>& x) {
    const HingeEdges<double> bar(rest);
    const HingeEdges<Scalar> e(x);
    const double c01 = cotangent(bar.e0, bar.e1), c03 = cotangent(-bar.e0, bar.e3),
                 c02 = cotangent(bar.e0, bar.e2), c04 = cotangent(-bar.e0, bar.e4);
    Vector<Scalar> sum;
    for (int i = 0; i < 3; ++i)
        sum[i] = Scalar(-(c03 * e.e1[i] + c01 * e.e3[i] + c04 * e.e2[i] + c02 * e.e4[i]));
    const double angle = hinge_angle(rest), scale = 3 * stiffness / two_areas(bar);
    const double k = scale * std::sin(angle) * (c01 + c03) * (c02 + c04) / bar.e0.norm();
    const double constant = scale * bar.e0.squaredNorm() * (1 - std::cos(angle));
    return Scalar(0.5 * scale * std::cos(angle) * dot<Scalar>(sum, sum) - k * e.triple() + constant);
}

}  // namespace sherd::test
