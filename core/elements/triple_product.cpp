// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/elements/triple_product.h"

#include <Eigen/Geometry>

namespace sherd {
namespace {

/// The edges e0, e1 and e2 from x0: small numbers, which lose fewer digits than positions.
struct EdgesFromStart {
    explicit EdgesFromStart(const HingePositions& x)
        : e0(x.col(1) - x.col(0)), e1(x.col(2) - x.col(0)), e2(x.col(3) - x.col(0)) {}
    Vector3d e0, e1, e2;
};

}  // namespace

double triple_product(const HingePositions& x) {
    const EdgesFromStart edges(x);
    return edges.e0.cross(edges.e1).dot(edges.e2);
}

HingePositions triple_gradient(const HingePositions& x) {
    const EdgesFromStart edges(x);
    HingePositions g;
    g.col(1) = edges.e1.cross(edges.e2);
    g.col(2) = edges.e2.cross(edges.e0);
    g.col(3) = edges.e0.cross(edges.e1);
    g.col(0) = -(g.col(1) + g.col(2) + g.col(3));
    return g;
}

void add_triple_hessian(double factor, const HingePositions& x, HingeHessian& hessian) {
    const EdgesFromStart edges(x);
    const auto add = [&](int a, int b, const Matrix3d& block) {
        hessian.block<3, 3>(3 * a, 3 * b) += factor * block;
        hessian.block<3, 3>(3 * b, 3 * a) += factor * block.transpose();
    };
    // d(e1 x e2)/de1 = -[e2] and d(e1 x e2)/de2 = [e1], and cyclically; the blocks of x0 follow from
    // translation invariance.
    const Matrix3d d12 = -cross_matrix(edges.e2), d13 = cross_matrix(edges.e1), d23 = -cross_matrix(edges.e0);
    add(1, 2, d12);
    add(1, 3, d13);
    add(2, 3, d23);
    add(1, 0, -(d12 + d13));
    add(2, 0, -(d12.transpose() + d23));
    add(3, 0, -(d13.transpose() + d23.transpose()));
}

}  // namespace sherd
