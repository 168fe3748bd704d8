// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bending/cubic_hinge.h"

#include <Eigen/QR>
#include <cmath>
#include <limits>

#include "core/elements/triple_product.h"

namespace sherd {
namespace {

/// Pairs of vertices joined by the five edges of the stencil.
constexpr int stencil_edges[5][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}};

/// Positions relative to x0: the energy is translation invariant, and small numbers lose fewer digits.
HingePositions relative(const HingePositions& x) {
    return x.colwise() - Vector3d(x.col(0));
}

/// The hinge of the paper's eq. 7, without the constant.
CubicHinge eq_7(const RestHinge& rest, double stiffness) {
    const auto [c01, c03, c02, c04] =
        std::array{rest.cotangents[0], rest.cotangents[1], rest.cotangents[2], rest.cotangents[3]};
    const Eigen::Vector4d K(c03 + c04, c01 + c02, -c01 - c03, -c02 - c04);
    const double scale = 3 * stiffness / rest.area;
    CubicHinge hinge;
    hinge.quadratic = scale * std::cos(rest.angle) * K * K.transpose();
    hinge.cubic = scale * std::sin(rest.angle) * (c01 + c03) * (c02 + c04) / rest.edge_length;
    return hinge;
}

/// Subtracts sum_j a_j |e_j|^2 over the edges e_j of the stencil, with the coefficients a_j that cancel the
/// gradient at rest.
void bring_to_equilibrium(CubicHinge& hinge, const HingePositions& rest) {
    Eigen::Matrix<double, 12, 5> squares;
    for (int j = 0; j < 5; ++j) {
        const auto [p, q] = stencil_edges[j];
        HingePositions g = HingePositions::Zero();
        g.col(p) = 2 * (rest.col(p) - rest.col(q));
        g.col(q) = -g.col(p);
        squares.col(j) = g.reshaped();
    }
    const HingePositions force = gradient(hinge, rest);
    const Eigen::Matrix<double, 5, 1> a =
        squares.colPivHouseholderQr().solve(Eigen::Matrix<double, 12, 1>(force.reshaped()));
    for (int j = 0; j < 5; ++j) {
        const auto [p, q] = stencil_edges[j];
        hinge.quadratic(p, p) -= 2 * a[j];
        hinge.quadratic(q, q) -= 2 * a[j];
        hinge.quadratic(p, q) += 2 * a[j];
        hinge.quadratic(q, p) += 2 * a[j];
    }
}

}  // namespace

CubicHinge cubic_hinge_2007(const HingePositions& rest, double stiffness) {
    const HingePositions r = relative(rest);
    CubicHinge hinge = eq_7(rest_hinge(r), stiffness);
    hinge.constant = -value(hinge, r);
    return hinge;
}

CubicHinge cubic_hinge(const HingePositions& rest, double stiffness) {
    const HingePositions r = relative(rest);
    CubicHinge hinge = eq_7(rest_hinge(r), stiffness);
    bring_to_equilibrium(hinge, r);
    hinge.constant = -value(hinge, r);
    return hinge;
}

double value(const CubicHinge& hinge, const HingePositions& x) {
    const HingePositions r = relative(x);
    return 0.5 * (r * hinge.quadratic).cwiseProduct(r).sum() - hinge.cubic * triple_product(r) +
           hinge.constant;
}

double round_off(const CubicHinge& hinge) {
    return 16 * std::numeric_limits<double>::epsilon() * std::abs(hinge.constant);
}

HingePositions gradient(const CubicHinge& hinge, const HingePositions& x) {
    const HingePositions r = relative(x);
    return r * hinge.quadratic - hinge.cubic * triple_gradient(r);
}

HingeHessian hessian(const CubicHinge& hinge, const HingePositions& x, bool cubic_part) {
    HingeHessian h;
    for (int a = 0; a < 4; ++a)
        for (int b = 0; b < 4; ++b)
            h.block<3, 3>(3 * a, 3 * b) = hinge.quadratic(a, b) * Matrix3d::Identity();
    if (!cubic_part || hinge.cubic == 0) return h;
    add_triple_hessian(-hinge.cubic, x, h);
    return h;
}

}  // namespace sherd
