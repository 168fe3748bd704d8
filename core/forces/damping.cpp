// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/forces/damping.h"

#include "core/bending/coupled_bending.h"
#include "core/bending/cubic_bending.h"
#include "core/membrane/arc_membrane.h"
#include "core/membrane/membrane_energy.h"

namespace sherd {

StiffnessDamping::StiffnessDamping(const Shell& shell, double coefficient, BendingModel model,
                                   MembraneModel membrane_model)
    : shell(shell), coefficient(coefficient) {
    const std::vector<MirrorHinge> no_mirrors;
    if (model == BendingModel::coupled) coupled = std::make_unique<CoupledBending>(shell, no_mirrors);
    if (membrane_model == MembraneModel::arc) arcs = std::make_unique<ArcMembrane>(shell, no_mirrors);
}

StiffnessDamping::~StiffnessDamping() = default;

void StiffnessDamping::topology_changed(const ShellChange& change, const StepContext& step) {
    if (coupled) coupled->topology_changed(change, step);
    if (arcs) arcs->topology_changed(change, step);
    begin(step);
}

void StiffnessDamping::begin(const StepContext& step) {
    const double scale = coefficient / step.lag;
    if (coupled)
        coupled->start_from(step.origin, scale);
    else
        uncoupled = std::make_unique<CubicBending>(CubicHinges(shell.hinges, step.origin, scale));
    bending = coupled ? coupled.get() : uncoupled.get();
    begin_membrane(step.origin, scale);
}

void StiffnessDamping::begin_membrane(const Positions& origin, double scale) {
    if (arcs) {
        arcs->start_from(origin, scale);
    } else {
        triangles.clear();
        for (const TriangleStencil& triangle : shell.triangles)
            triangles.push_back({triangle.vertices, membrane_triangle(columns(origin, triangle.vertices),
                                                                      scale * triangle.membrane.elasticity)});
        flat = std::make_unique<MembraneEnergy>(triangles);
    }
    membrane = arcs ? arcs.get() : flat.get();
}

void StiffnessDamping::visit_state(StateVisitor& visit) {
    auto& [shell, coefficient, triangles, coupled, arcs, uncoupled, flat, bending, membrane] = *this;
    visit(coupled, arcs);
}

double StiffnessDamping::value(const Positions& x) const {
    return bending->value(x) + membrane->value(x);
}

double StiffnessDamping::round_off() const {
    return bending->round_off();
}

void StiffnessDamping::add_gradient(const Positions& x, Positions& gradient) const {
    bending->add_gradient(x, gradient);
    membrane->add_gradient(x, gradient);
}

void StiffnessDamping::add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const {
    bending->add_hessian(x, curvature, hessian);
    membrane->add_hessian(x, curvature, hessian);
}

void StiffnessDamping::add_pattern(std::vector<std::pair<Index, Index>>& pairs) const {
    bending->add_pattern(pairs);
    membrane->add_pattern(pairs);
}

}  // namespace sherd
