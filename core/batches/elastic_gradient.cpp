// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batches/elastic_gradient.h"

#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace sherd {
namespace {

constexpr Index batches_at_once = 64, vertices_at_once = 1024;

}  // namespace

ElasticGradient::ElasticGradient(const Shell& shell, const ShellEnergies& energies,
                                 const ShellEnergyOptions& options, Threads threads)
    : shell(shell),
      threads(std::move(threads)),
      cubic(cubic_hinges(energies.bending_part())),
      membrane_part(options.membrane == MembraneModel::constant_strain) {
    if (of_membrane && options.yields.empty()) coupled = energies.coupled_bending();
    if (coupled == nullptr && cubic == nullptr) others.push_back(&energies.bending_part());
    if (!of_membrane) others.push_back(&energies.membrane_part());
    if (coupled == nullptr && !options.mirrors.empty()) others.push_back(&energies.mirror_part());
}

void ElasticGradient::build() {
    corners.clear();
    if (of_membrane) faces.build(shell, corners);
    if (cubic != nullptr) hinges.build(shell, *cubic, corners);
    corners.prepare(static_cast<Index>(shell.position.cols()));
    positions.resize(shell.position.cols());
    if (coupled != nullptr) {
        bends.build(shell, *coupled);
        mirrors.resize(coupled->all_folds().folds_of_edges());
        std::iota(mirrors.begin(), mirrors.end(), 0);
        of_mirrors.resize(mirrors.size());
    }
    built = true;
}

void ElasticGradient::find(const Positions& x) {
    if (!built) build();
    threads.share_ranges(static_cast<Index>(x.cols()), vertices_at_once, [&](Index begin, Index end) {
        const double* from = x.data();
        wide_loop(begin, end, [&](Index v) {
            positions[v].coordinates = Lanes::Vector{from[3 * v], from[3 * v + 1], from[3 * v + 2], 0};
        });
    });
    if (!others.empty() || !mirrors.empty()) unbatched.setZero(3, x.cols());
    if (coupled != nullptr) find_coupled(x);
    const SideMoments* bending = coupled != nullptr ? &bends.moments() : nullptr;
    threads.share_ranges(faces.size(), batches_at_once, [&](Index begin, Index end) {
        faces.find(begin, end, positions, bending, corners);
    });
    threads.share_ranges(hinges.size(), batches_at_once,
                         [&](Index begin, Index end) { hinges.find(begin, end, positions, corners); });
    for (const Energy* energy : others) energy->add_gradient(x, unbatched);
}

void ElasticGradient::find_coupled(const Positions& x) {
    const Folds& folds = coupled->all_folds();
    if (!mirrors.empty()) folds.find_slopes(x, mirrors, slopes);
    for (const Index m : mirrors)
        of_mirrors[m] = std::remainder(slopes[m].angle - coupled->start_angle(m), 2 * std::numbers::pi);
    bends.find(positions, threads, of_mirrors);
    for (const Index m : mirrors)
        for (int v = 0; v < 4; ++v)
            if (const Index vertex = slopes[m].vertices[v]; vertex >= 0)
                unbatched.col(vertex) += of_mirrors[m] * slopes[m].gradient.col(v);
}

void ElasticGradient::put_forces(Index begin, Index end, Positions& forces) const {
    corners.put_negative(begin, end, forces.data());
    if (!others.empty() || !mirrors.empty())
        forces.middleCols(begin, end - begin) -= unbatched.middleCols(begin, end - begin);
}

Positions ElasticGradient::at(const Positions& x) {
    find(x);
    Positions forces(3, x.cols());
    put_forces(0, static_cast<Index>(x.cols()), forces);
    return -forces;
}

}  // namespace sherd
