// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/bodies/body_inertia.h"

namespace sherd {

double BodyInertia::value(const Positions& x) const {
    double sum = 0;
    for (std::size_t b = 0; b < bodies.bodies().size(); ++b)
        sum += 0.5 * bodies.inertia(b) * (bodies.columns_of(b, x) - bodies.prediction(b)).squaredNorm();
    return sum;
}

void BodyInertia::add_gradient(const Positions& x, Positions& gradient) const {
    for (std::size_t b = 0; b < bodies.bodies().size(); ++b)
        gradient.middleCols<2>(bodies.first_column(b)) +=
            bodies.inertia(b) * (bodies.columns_of(b, x) - bodies.prediction(b));
}

void BodyInertia::add_hessian(const Positions&, Curvature, BlockMatrix& hessian) const {
    for (std::size_t b = 0; b < bodies.bodies().size(); ++b)
        for (const Index column : {bodies.first_column(b), bodies.first_column(b) + 1})
            hessian.add(column, column, bodies.inertia(b) * Matrix3d::Identity());
}

void BodyInertia::add_pattern(std::vector<std::pair<Index, Index>>& pairs) const {
    for (std::size_t b = 0; b < bodies.bodies().size(); ++b)
        pairs.emplace_back(bodies.first_column(b) + 1, bodies.first_column(b));
}

}  // namespace sherd
