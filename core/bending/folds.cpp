// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bending/folds.h"

#include <algorithm>
#include <numeric>

#include "core/block_columns.h"
#include "core/elements/hinge_angles.h"

namespace sherd {
namespace {

constexpr Index folds_at_once = 512;

}  // namespace

std::array<Index, 4> Folds::vertices(Index fold) const {
    if (fold < folds_of_edges()) {
        const auto [from, to, apex] = mirrors.vertices(fold);
        return {from, to, apex, -1};
    }
    return shell.hinges[shell.edge_hinge[fold - folds_of_edges()]].vertices;
}

void Folds::collect(Index fold, std::vector<Index>& collected) const {
    for (const Index vertex : vertices(fold))
        if (vertex >= 0 && std::ranges::find(collected, vertex) == collected.end())
            collected.push_back(vertex);
}

double Folds::rest_angle(Index fold) const {
    if (fold < folds_of_edges()) return hinge_angle(mirrors.rest(fold));
    const Index hinge = shell.edge_hinge[fold - folds_of_edges()];
    return hinge < 0 ? 0 : shell.hinges[hinge].rest.angle;
}

VectorXd Folds::rest_angles() const {
    VectorXd all(size());
    for (Index fold = 0; fold < static_cast<Index>(all.size()); ++fold) all[fold] = rest_angle(fold);
    return all;
}

std::vector<Index> Folds::present() const {
    std::vector<Index> all(mirrors.size());
    std::iota(all.begin(), all.end(), 0);
    for (const Index edge : shell.hinge_edge) all.push_back(folds_of_edges() + edge);
    return all;
}

HingePositions Folds::positions(Index fold, const Positions& x) const {
    if (fold < folds_of_edges()) return mirrors.with_image(fold, x);
    return columns(x, vertices(fold));
}

Folds::Slope Folds::slope(Index fold, const Positions& x) const {
    const DihedralAngle fold_angle(positions(fold, x));
    Slope slope{vertices(fold), fold_angle.angle(), fold_angle.gradient()};
    if (fold < folds_of_edges()) slope.gradient.col(2) += mirrors.reflection(fold) * slope.gradient.col(3);
    return slope;
}

VectorXd Folds::angles(const Positions& x) const {
    return angles(x, present());
}

VectorXd Folds::angles(const Positions& x, std::span<const Index> some) const {
    VectorXd all = VectorXd::Zero(size());
    std::size_t first = 0;  // index of the first edge; edges come after mirrors
    for (; first < some.size() && some[first] < folds_of_edges(); ++first)
        all[some[first]] = hinge_angle(positions(some[first], x));
    const auto edges = some.subspan(first);
    find_hinge_angles(
        x, static_cast<Index>(edges.size()), [&](Index i) { return vertices(edges[i]); },
        [&](Index i, double angle) { all[edges[i]] = angle; });
    return all;
}

void Folds::find_slopes(const Positions& x, std::span<const Index> some, std::vector<Slope>& all,
                        const Threads& threads) const {
    all.resize(size());
    threads.share_ranges(static_cast<Index>(some.size()), folds_at_once, [&](Index begin, Index end) {
        for (Index i = begin; i < end; ++i) all[some[i]] = slope(some[i], x);
    });
}

VectorXd Folds::angles(std::span<const Slope> slopes, std::span<const Index> some) const {
    VectorXd all = VectorXd::Zero(size());
    for (const Index fold : some) all[fold] = slopes[fold].angle;
    return all;
}

void Folds::add_gradient(std::span<const Slope> slopes, const VectorXd& of_angles, Positions& gradient,
                         std::span<const Index> some) const {
    for (const Index fold : some) {
        const auto& [at, angle, by_vertex] = slopes[fold];
        for (int v = 0; v < 4; ++v)
            if (at[v] >= 0) gradient.col(at[v]) += of_angles[fold] * by_vertex.col(v);
    }
}

void Folds::extend(const ShellChange& change, VectorXd& angles) const {
    if (!change.reshaped.empty()) {
        angles = rest_angles();
        return;
    }
    const Eigen::Index known = angles.size();
    angles.conservativeResize(size());
    angles.tail(angles.size() - known).setZero();
    for (const auto& [edge, parents] : change.edges)
        if (shell.edge_hinge[edge] >= 0)
            angles[folds_of_edges() + edge] = rest_angle(folds_of_edges() + edge);
}

void Folds::add_hessian(const Positions& x, const VectorXd& of_angles, BlockMatrix& hessian,
                        std::span<const Index> some) const {
    hessian.add_elements<HingeHessian>(
        some.size(),
        [&](std::size_t i, HingeHessian& full) {
            if (!hessian.has_all(vertices(some[i]))) return false;
            full.setZero();
            DihedralAngle(positions(some[i], x)).add_hessian(of_angles[some[i]], full);
            return true;
        },
        [&](BlockMatrix::Columns& columns, std::size_t i, const HingeHessian& full) {
            if (some[i] < folds_of_edges())
                add_element(columns, mirrors.vertices(some[i]), mirrors.folded(some[i], full));
            else
                add_element(columns, vertices(some[i]), full);
        });
}

std::vector<MirrorGradient> Folds::mirror_gradients(const Positions& x, const VectorXd& of_angles) const {
    std::vector<MirrorGradient> gradients;
    for (Index m = 0; m < folds_of_edges(); ++m)
        gradients.push_back({vertices(m), of_angles[m] * slope(m, x).gradient});
    return gradients;
}

}  // namespace sherd
