// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solver/conserve_momentum.h"

#include "core/shell/pieces.h"

namespace sherd {
namespace {

constexpr double outer_force = 1e-9;  // share of all contact forces, below which an outer force is round-off

}  // namespace

void conserve_momentum(const Potential& potential, const Positions& x, const Positions& gradient,
                       double tolerance, Positions& correction) {
    const double hessian_per_mass = potential.hessian_per_mass();
    if (hessian_per_mass == 0) return;
    const Shell& shell = potential.mechanics();
    const Pieces all = pieces(shell, potential.contacts(x));
    const Positions contact = potential.contact_gradient(x);
    std::vector<char> is_held(all.count, 0);
    VectorXd mass = VectorXd::Zero(all.count), touch = mass;
    Positions lacking = Positions::Zero(3, all.count), outer = lacking;
    for (Index v = 0; v < static_cast<Index>(x.cols()); ++v) {
        const Index piece = all.of_vertex[v];
        if (shell.fixed[v] || shell.guide[v]) is_held[piece] = 1;
        mass[piece] += shell.mass[v];
        touch[piece] += contact.col(v).norm();
        outer.col(piece) += contact.col(v);
        lacking.col(piece) -= gradient.col(v) / hessian_per_mass + shell.mass[v] * correction.col(v);
    }
    const Positions shift = lacking * mass.cwiseInverse().asDiagonal();
    for (Index piece = 0; piece < all.count; ++piece)
        if (outer.col(piece).norm() > outer_force * touch[piece] ||
            !(shift.col(piece).cwiseAbs().maxCoeff() <= tolerance))
            is_held[piece] = 1;
    for (Index v = 0; v < static_cast<Index>(x.cols()); ++v)
        if (!is_held[all.of_vertex[v]]) correction.col(v) += shift.col(all.of_vertex[v]);
}

}  // namespace sherd
