// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sheet_energies.h"

namespace sherd {

namespace {

/// Calls `visit` with the member of HingeStencil that holds the model's hinge.
template <class Visit>
auto with_hinge_of(BendingModel model, const Visit& visit) {
    switch (model) {
        case BendingModel::cubic_2007:
            return visit(&HingeStencil::cubic_2007);
        case BendingModel::nonlinear:
            return visit(&HingeStencil::nonlinear);
        case BendingModel::cubic:
            break;
    }
    return visit(&HingeStencil::cubic);
}

}  // namespace

BendingJacobian exact_jacobian(BendingModel model) {
    return model == BendingModel::nonlinear ? BendingJacobian::nonlinear : BendingJacobian::cubic;
}

double BendingEnergy::value(const Positions& x) const {
    return with_hinge_of(options.model, [&](auto member) {
        double sum = 0;
        for (const HingeStencil& hinge : hinges)
            sum += sherd::value(hinge.*member, hinge_positions(x, hinge.vertices));
        return sum;
    });
}

double BendingEnergy::round_off() const {
    return with_hinge_of(options.model, [&](auto member) {
        double sum = 0;
        for (const HingeStencil& hinge : hinges) sum += sherd::round_off(hinge.*member);
        return sum;
    });
}

void BendingEnergy::add_gradient(const Positions& x, Positions& gradient) const {
    with_hinge_of(options.model, [&](auto member) {
        for (const HingeStencil& hinge : hinges) {
            const HingePositions local = sherd::gradient(hinge.*member, hinge_positions(x, hinge.vertices));
            for (int i = 0; i < 4; ++i) gradient.col(hinge.vertices[i]) += local.col(i);
        }
    });
}

HingeHessian BendingEnergy::hinge_hessian(const HingeStencil& hinge, const HingePositions& x,
                                          Curvature curvature) const {
    const bool convex = curvature == Curvature::convex;
    if (options.jacobian == BendingJacobian::nonlinear) return hessian(hinge.nonlinear, x, convex);
    const bool as_in_2007 = options.model == BendingModel::cubic_2007 && !convex;
    return hessian(as_in_2007 ? hinge.cubic_2007 : hinge.cubic, x,
                   options.jacobian == BendingJacobian::cubic && !convex);
}

void BendingEnergy::add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const {
    for (const HingeStencil& hinge : hinges)
        add_element(hessian, hinge.vertices,
                    hinge_hessian(hinge, hinge_positions(x, hinge.vertices), curvature));
}

void BendingEnergy::add_pattern(std::vector<std::pair<Index, Index>>& pairs) const {
    for (const HingeStencil& hinge : hinges) add_pairs(pairs, hinge.vertices);
}

double MembraneEnergy::value(const Positions& x) const {
    double sum = 0;
    for (const TriangleStencil& triangle : triangles)
        sum += sherd::value(triangle.membrane, triangle_positions(x, triangle.vertices));
    return sum;
}

void MembraneEnergy::add_gradient(const Positions& x, Positions& gradient) const {
    for (const TriangleStencil& triangle : triangles) {
        const TrianglePositions local =
            sherd::gradient(triangle.membrane, triangle_positions(x, triangle.vertices));
        for (int i = 0; i < 3; ++i) gradient.col(triangle.vertices[i]) += local.col(i);
    }
}

void MembraneEnergy::add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const {
    for (const TriangleStencil& triangle : triangles)
        add_element(hessian, triangle.vertices,
                    sherd::hessian(triangle.membrane, triangle_positions(x, triangle.vertices),
                                   curvature == Curvature::convex));
}

void MembraneEnergy::add_pattern(std::vector<std::pair<Index, Index>>& pairs) const {
    for (const TriangleStencil& triangle : triangles) add_pairs(pairs, triangle.vertices);
}

}  // namespace sherd
