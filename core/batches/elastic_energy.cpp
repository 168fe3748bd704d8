// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batches/elastic_energy.h"

namespace sherd {

void ElasticEnergy::begin(const StepContext& step) {
    for (Energy* part : parts) part->begin(step);
}

void ElasticEnergy::topology_changed(const ShellChange& change, const StepContext& step) {
    for (Energy* part : parts) part->topology_changed(change, step);
    batches.shell_changed();
}

double ElasticEnergy::value(const Positions& x) const {
    double sum = 0;
    for (const Energy* part : parts) sum += part->value(x);
    return sum;
}

double ElasticEnergy::round_off() const {
    double sum = 0;
    for (const Energy* part : parts) sum += part->round_off();
    return sum;
}

void ElasticEnergy::add_gradient(const Positions& x, Positions& gradient) const {
    gradient += batches.at(x);
}

void ElasticEnergy::add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const {
    for (const Energy* part : parts) part->add_hessian(x, curvature, hessian);
}

void ElasticEnergy::add_pattern(std::vector<std::pair<Index, Index>>& pairs) const {
    for (const Energy* part : parts) part->add_pattern(pairs);
}

}  // namespace sherd
