// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batches/coupled_batches.h"
#include "core/batches/hinge_batches.h"
#include "core/forces/shell_energies.h"

namespace sherd {

/// The gradient of the elastic energies of a shell, for those who ask for it again and again: that of
/// ShellEnergies::elastic() but for round-off, in batches where the models have them (constant strain, and
/// coupled hinges that do not yield or cubic ones), and from the energies themselves where not. It has the
/// same bits with any number of threads.
class ElasticGradient {
  public:
    /// Shell and energies must outlive this object. options: of the energies.
    ElasticGradient(const Shell& shell, const ShellEnergies& energies, const ShellEnergyOptions& options,
                    Threads threads);
    ElasticGradient(const ElasticGradient&) = delete;
    /// Must be called when the shell has changed, or its state was put back.
    void shell_changed() { built = false; }

    /// Finds it at x, [3, V] m.
    void find(const Positions& x);
    /// Puts the forces that were found, N, on the vertices from `begin` to before `end` into theirs of [3,
    /// V].
    void put_forces(Index begin, Index end, Positions& forces) const;
    /// The gradient at x, N, [3, V].
    Positions at(const Positions& x);

  private:
    void build();
    void find_coupled(const Positions& x);

    const Shell& shell;
    Threads threads;
    const CoupledBending* coupled = nullptr;         ///< in batches; null: is not
    const std::vector<CubicHinge>* cubic = nullptr;  ///< the same
    bool of_membrane;                                ///< whether the membrane is in batches
    std::vector<const Energy*> others;               ///< those that are not

    bool built = false;
    PaddedPositions positions;
    CornerSums corners;
    FaceBatches faces;
    HingeBatches hinges;
    CoupledBatches bends;
    std::vector<Index> mirrors;  ///< of coupled hinges, with numbers of folds
    std::vector<double> of_mirrors;
    std::vector<Folds::Slope> slopes;
    Positions unbatched;  ///< N, [3, V], of the others and of mirrors
};

}  // namespace sherd
