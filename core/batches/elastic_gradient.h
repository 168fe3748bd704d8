// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <utility>

#include "core/batches/corner_sums.h"
#include "core/batches/coupled_batches.h"
#include "core/bending/cubic_hinge.h"
#include "core/forces/shell_energies.h"
#include "core/shell/shell.h"

namespace sherd {

/// The cubic hinges of a shell in batches, with the gradient of their energy.
class HingeBatches {
  public:
    /// Makes the batches, and appends the vertices of all hinges to `corners`. levels: of the vertices.
    /// Raises the entries of `at_vertices` to the levels of the hinges around them.
    void build(const Shell& shell, const std::vector<CubicHinge>& hinges, const std::vector<Level>& levels,
               CornerSums& corners, std::vector<Level>& at_vertices);
    /// Number of the first batches, which together contain all hinges of at least this level.
    Index size(int level) const { return batches_of(order.count(level)); }

    /// Writes the gradients, N, of the batches from `begin` to before `end` to their places in `corners`.
    void find(Index begin, Index end, const PaddedPositions& x, CornerSums& corners) const;

  private:
    struct alignas(sizeof(Lanes)) Batch {
        std::array<Lanes, 6> quadratic;  ///< N/m, CubicHinge::quadratic without the first vertex: 00, 11, 22,
                                         ///< 01, 02, 12
        Lanes cubic;                     ///< N/m^2, CubicHinge::cubic
        std::array<LaneIndices, 4> vertices;
        Index place;  ///< number in CornerSums of the first vertex's place
    };
    LevelOrder order;
    std::vector<Batch> batches;
};

/// The gradient of the elastic energies of a shell, ShellEnergies::elastic(), for repeated evaluation. It is
/// computed in batches for these models: membranes of constant strain, cubic hinges, and coupled hinges that
/// do not yield if the membrane has constant strain. Other energies compute their gradients themselves. The
/// result equals that of the energies up to round-off, and has the same bits with any number of threads.
class ElasticGradient {
  public:
    /// Shell and energies must outlive this object. options: with which `energies` has been made.
    ElasticGradient(const Shell& shell, const ShellEnergies& energies, const ShellEnergyOptions& options,
                    Threads threads);
    ElasticGradient(const ElasticGradient&) = delete;
    /// Must be called when the shell has changed, or its state has been restored.
    void shell_changed() {
        built = false;
        levels.clear();
    }
    /// Whether find_again() can be called: all energies are in batches.
    bool is_local() const { return others.empty(); }
    /// Sets the level of each vertex, [V], until the shell changes. By default all levels are 0.
    void set_levels(std::vector<Level> of_vertices) {
        if (levels == of_vertices) return;
        levels = std::move(of_vertices);
        built = false;
    }

    /// Computes the gradient at x, [3, V] m.
    void find(const Positions& x);
    /// Moves a vertex since the last find(); find_again() uses the new position.
    void move(Index vertex, const Vector3d& to);
    Vector3d position(Index vertex) const {
        const Lanes& at_vertex = positions[vertex].coordinates;
        return {at_vertex[0], at_vertex[1], at_vertex[2]};
    }
    /// Computes the gradient again after only vertices of at least `level` have been moved.
    void find_again(int level);
    /// The vertices whose gradients depend on vertices of at least `level`.
    std::span<const Index> affected(int level) const { return vertices.of_level(level); }
    /// Writes the forces on the vertices affected(level), N, to their columns of `forces`, [3, V].
    void put_forces_again(int level, Positions& forces) const;
    /// Writes the forces of the last find(), N, [3, V], to `forces`.
    void put_forces(Positions& forces) const;
    /// Energies at the positions of the last find(), J.
    struct Energies {
        double bending, membrane;
    };
    /// Returns the energies if no vertex has been moved since the last find(), and if the hinges are coupled
    /// and all energies in batches; else nothing.
    std::optional<Energies> energies() const;
    /// The gradient at x, N, [3, V].
    Positions at(const Positions& x);

  private:
    void build();
    void find_coupled(int level);

    const Shell& shell;
    Threads threads;
    const CoupledBending* coupled = nullptr;         ///< coupled bending, if it is in batches; else null
    const std::vector<CubicHinge>* cubic = nullptr;  ///< cubic hinges, if they are in batches; else null
    bool of_membrane;                                ///< whether the membrane is in batches
    std::vector<const Energy*> others;               ///< energies that are not in batches

    bool built = false;
    bool moved = false;         ///< whether a vertex has been moved since the last find()
    std::vector<Level> levels;  ///< levels of the vertices; empty: all are 0
    LevelOrder vertices;        ///< by the levels of their gradients
    PaddedPositions positions;
    Positions unpadded;  ///< [3, V] m, positions for energies that are not in batches
    CornerSums corners;
    FaceBatches faces;
    HingeBatches hinges;
    CoupledBatches bends;
    std::vector<Index> mirrors;  ///< numbers of the mirrors of coupled hinges among the folds
    std::vector<double> of_mirrors;
    std::vector<Folds::Slope> slopes;
    Positions unbatched;  ///< N, [3, V], gradient of `others` and of mirrors
};

}  // namespace sherd
