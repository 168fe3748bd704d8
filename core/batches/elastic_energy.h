// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batches/elastic_gradient.h"
#include "core/energy.h"

namespace sherd {

/// Sum of the elastic energies of a shell, for minimisers. The gradient, which they need most often, is
/// computed in batches (ElasticGradient).
class ElasticEnergy : public Energy {
  public:
    /// Shell and energies must outlive this object. options: the options with which `energies` were made.
    ElasticEnergy(const Shell& shell, ShellEnergies& energies, const ShellEnergyOptions& options,
                  const Threads& threads)
        : parts(energies.elastic()), batches(shell, energies, options, threads) {}

    void begin(const StepContext& step) override;
    void topology_changed(const ShellChange& change, const StepContext& step) override;
    double value(const Positions& x) const override;
    double round_off() const override;
    void add_gradient(const Positions& x, Positions& gradient) const override;
    void add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const override;
    void add_pattern(std::vector<std::pair<Index, Index>>& pairs) const override;
    /// Visits nothing: the owner of the energies visits their state.
    void visit_state(StateVisitor& visit) override {
        [[maybe_unused]] auto& [parts, batches] = *this;
        if (visit.reads()) batches.shell_changed();
        visit();
    }

  private:
    std::vector<Energy*> parts;
    mutable ElasticGradient batches;  ///< mutable because of its buffers
};

}  // namespace sherd
