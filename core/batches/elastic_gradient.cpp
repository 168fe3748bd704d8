// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batches/elastic_gradient.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

namespace sherd {
namespace {

constexpr Index batches_at_once = 64, vertices_at_once = 1024;

}  // namespace

void HingeBatches::build(const Shell& shell, const std::vector<CubicHinge>& hinges,
                         const std::vector<Level>& levels, CornerSums& corners,
                         std::vector<Level>& at_vertices) {
    const std::size_t count = shell.hinges.size();
    std::vector<Level> of_hinges(count, 0);
    for (std::size_t h = 0; h < count; ++h) {
        for (const Index v : shell.hinges[h].vertices) raise(of_hinges[h], levels[v]);
        for (const Index v : shell.hinges[h].vertices) raise(at_vertices[v], of_hinges[h]);
    }
    order = LevelOrder(of_hinges);
    batches.assign(batches_of(count), {});
    for (Index b = 0; b < static_cast<Index>(batches.size()); ++b) {
        Batch& batch = batches[b];
        for (int lane = 0; lane < Lanes::count; ++lane) {
            const Index hinge = order[element_of(b, lane, count)];
            const Matrix3d Q = hinges[hinge].quadratic.bottomRightCorner<3, 3>();
            const double entries[] = {Q(0, 0), Q(1, 1), Q(2, 2), Q(0, 1), Q(0, 2), Q(1, 2)};
            for (int k = 0; k < 6; ++k) batch.quadratic[k].set(lane, entries[k]);
            batch.cubic.set(lane, hinges[hinge].cubic);
            for (int v = 0; v < 4; ++v) batch.vertices[v][lane] = shell.hinges[hinge].vertices[v];
        }
        batch.place = corners.append(batch.vertices, present_in(b, count));
    }
}

void HingeBatches::find(Index begin, Index end, const PaddedPositions& x, CornerSums& corners) const {
    wide_loop(begin, end, [&](Index b) {
        const auto& [Q, k, vertices, place] = batches[b];
        const LanesVector start = gather(x, vertices[0]);
        const LanesVector e0 = gather(x, vertices[1]) - start, e1 = gather(x, vertices[2]) - start,
                          e2 = gather(x, vertices[3]) - start;
        const LanesVector g1 = Q[0] * e0 + Q[3] * e1 + Q[4] * e2 - k * e1.cross(e2);
        const LanesVector g2 = Q[3] * e0 + Q[1] * e1 + Q[5] * e2 - k * e2.cross(e0);
        const LanesVector g3 = Q[4] * e0 + Q[5] * e1 + Q[2] * e2 - k * e0.cross(e1);
        scatter(-(g1 + g2 + g3), corners.at(place));  // the rows of Q sum to zero
        scatter(g1, corners.at(place + Lanes::count));
        scatter(g2, corners.at(place + 2 * Lanes::count));
        scatter(g3, corners.at(place + 3 * Lanes::count));
    });
}

ElasticGradient::ElasticGradient(const Shell& shell, const ShellEnergies& energies,
                                 const ShellEnergyOptions& options, Threads threads)
    : shell(shell),
      threads(std::move(threads)),
      cubic(cubic_hinges(energies.bending_part())),
      of_membrane(options.membrane == MembraneModel::constant_strain) {
    if (of_membrane && options.yields.empty()) coupled = energies.coupled_bending();
    if (coupled == nullptr && cubic == nullptr) others.push_back(&energies.bending_part());
    if (!of_membrane) others.push_back(&energies.membrane_part());
    if (coupled == nullptr && !options.mirrors.empty()) others.push_back(&energies.mirror_part());
}

void ElasticGradient::build() {
    const Index count = static_cast<Index>(shell.position.cols());
    if (levels.empty()) levels.assign(count, 0);
    std::vector<Level> at_vertices = levels;
    corners.clear();
    if (coupled != nullptr) {
        bends.build(shell, *coupled, levels);
        mirrors.resize(coupled->all_folds().folds_of_edges());
        std::iota(mirrors.begin(), mirrors.end(), 0);
        of_mirrors.resize(mirrors.size());
        for (const Index m : mirrors)
            for (const Index v : coupled->all_folds().vertices(m))
                if (v >= 0) raise(at_vertices[v], bends.level_of_mirror(m));
    }
    if (of_membrane)
        faces.build(shell, levels, coupled != nullptr ? &bends.moments() : nullptr, corners, at_vertices);
    if (cubic != nullptr) hinges.build(shell, *cubic, levels, corners, at_vertices);
    corners.prepare(count);
    vertices = LevelOrder(at_vertices);
    positions.resize(count);
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
    if (!others.empty() || !mirrors.empty()) unpadded = x;
    moved = false;
    find_again(0);
}

void ElasticGradient::move(Index vertex, const Vector3d& to) {
    moved = true;
    positions[vertex].coordinates = Lanes::Vector{to[0], to[1], to[2], 0};
    if (unpadded.cols() > 0) unpadded.col(vertex) = to;
}

void ElasticGradient::find_again(int level) {
    if (!others.empty() || !mirrors.empty()) unbatched.setZero(3, unpadded.cols());
    if (coupled != nullptr) find_coupled(level);
    const SideMoments* bending = coupled != nullptr ? &bends.moments() : nullptr;
    threads.share_ranges(faces.size(level), batches_at_once, [&](Index begin, Index end) {
        faces.find(begin, end, positions, bending, corners);
    });
    threads.share_ranges(hinges.size(level), batches_at_once,
                         [&](Index begin, Index end) { hinges.find(begin, end, positions, corners); });
    for (const Energy* energy : others) energy->add_gradient(unpadded, unbatched);
}

void ElasticGradient::find_coupled(int level) {
    const Folds& folds = coupled->all_folds();
    if (!mirrors.empty()) folds.find_slopes(unpadded, mirrors, slopes);
    for (const Index m : mirrors)
        of_mirrors[m] = std::remainder(slopes[m].angle - coupled->start_angle(m), 2 * std::numbers::pi);
    bends.find(positions, level, threads, of_mirrors);
    for (const Index m : mirrors)
        for (int v = 0; v < 4; ++v)
            if (const Index vertex = slopes[m].vertices[v]; vertex >= 0)
                unbatched.col(vertex) += of_mirrors[m] * slopes[m].gradient.col(v);
}

void ElasticGradient::put_forces(Positions& forces) const {
    forces.resize(3, static_cast<Eigen::Index>(positions.size()));
    threads.share_ranges(static_cast<Index>(positions.size()), vertices_at_once, [&](Index begin, Index end) {
        corners.put_negative(begin, end, forces.data());
        if (!others.empty() || !mirrors.empty())
            forces.middleCols(begin, end - begin) -= unbatched.middleCols(begin, end - begin);
    });
}

void ElasticGradient::put_forces_again(int level, Positions& forces) const {
    corners.put_negative(affected(level), forces.data());
    if (!others.empty() || !mirrors.empty())
        for (const Index v : affected(level)) forces.col(v) -= unbatched.col(v);
}

std::optional<ElasticGradient::Energies> ElasticGradient::energies() const {
    if (!built || moved || coupled == nullptr || !others.empty()) return std::nullopt;
    return Energies{bends.energy(), faces.energy(positions)};
}

Positions ElasticGradient::at(const Positions& x) {
    find(x);
    Positions forces;
    put_forces(forces);
    return -forces;
}

}  // namespace sherd
