// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sheet_energies.h"

#include <cmath>
#include <limits>

namespace sherd {

double BendingEnergy::value(const Positions& x) const {
    double sum = 0;
    for (const HingeStencil& hinge : hinges)
        sum += sherd::value(hinge.bending, hinge_positions(x, hinge.vertices));
    return sum;
}

double BendingEnergy::round_off() const {
    double terms = 0;
    for (const HingeStencil& hinge : hinges) terms += std::abs(hinge.bending.constant);
    return 16 * std::numeric_limits<double>::epsilon() * terms;
}

void BendingEnergy::add_gradient(const Positions& x, Positions& gradient) const {
    for (const HingeStencil& hinge : hinges) {
        const HingePositions local = sherd::gradient(hinge.bending, hinge_positions(x, hinge.vertices));
        for (int i = 0; i < 4; ++i) gradient.col(hinge.vertices[i]) += local.col(i);
    }
}

void BendingEnergy::add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const {
    for (const HingeStencil& hinge : hinges)
        add_element(
            hessian, hinge.vertices,
            sherd::hessian(hinge.bending, hinge_positions(x, hinge.vertices), curvature == Curvature::exact));
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
