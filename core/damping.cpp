// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/damping.h"

namespace sherd {

StiffnessDamping::StiffnessDamping(const Sheet& sheet, double coefficient, double step)
    : bending(hinges), membrane(triangles) {
    const double scale = coefficient / step;
    for (const HingeStencil& hinge : sheet.hinges) {
        const HingePositions now = hinge_positions(sheet.position, hinge.vertices);
        hinges.push_back(hinge);
        hinges.back().rest = rest_hinge(now);
        hinges.back().stiffness = scale * hinge.stiffness;
        hinges.back().cubic = cubic_hinge(now, scale * hinge.stiffness);
    }
    for (const TriangleStencil& triangle : sheet.triangles)
        triangles.push_back(
            {triangle.vertices, membrane_triangle(triangle_positions(sheet.position, triangle.vertices),
                                                  scale * triangle.membrane.elasticity)});
}

double StiffnessDamping::value(const Positions& x) const {
    return bending.value(x) + membrane.value(x);
}

double StiffnessDamping::round_off() const {
    return bending.round_off();
}

void StiffnessDamping::add_gradient(const Positions& x, Positions& gradient) const {
    bending.add_gradient(x, gradient);
    membrane.add_gradient(x, gradient);
}

void StiffnessDamping::add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const {
    bending.add_hessian(x, curvature, hessian);
    membrane.add_hessian(x, curvature, hessian);
}

void StiffnessDamping::add_pattern(std::vector<std::pair<Index, Index>>& pairs) const {
    bending.add_pattern(pairs);
    membrane.add_pattern(pairs);
}

double MassDamping::value(const Positions& x) const {
    return 0.5 * scale * sheet.mass.dot((x - sheet.position).colwise().squaredNorm().transpose());
}

void MassDamping::add_gradient(const Positions& x, Positions& gradient) const {
    gradient += (x - sheet.position) * (scale * sheet.mass).asDiagonal();
}

void MassDamping::add_hessian(const Positions&, Curvature, BlockMatrix& hessian) const {
    for (Index v = 0; v < static_cast<Index>(sheet.mass.size()); ++v)
        hessian.add(v, v, scale * sheet.mass[v] * Matrix3d::Identity());
}

}  // namespace sherd
