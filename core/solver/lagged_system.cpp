// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solver/lagged_system.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <numeric>
#include <utility>

#include "core/shell/pieces.h"
#include "core/solver/vertex_rotations.h"

namespace sherd {
namespace {

/// A change of a vertex's contact stiffness needs no patch if, in every direction, it is at most the share
/// `small_part` of a known contact stiffness plus the share `small_change` of the vertex's diagonal block
/// and, in a loose piece, also at most the share `small_change` of known contact stiffness and inertia of the
/// piece. The bound by inertia is needed because a block is far stiffer than the rigid motions and long waves
/// of sheets and shards: a small share of it may be many times their stiffness. A contact stiffness that
/// changes by a share of itself remains a good preconditioner for these motions, too.
constexpr double small_change = 0.03, small_part = 0.3;
/// Number of systems of a search that are remembered. If the contact stiffness of each vertex is close to its
/// value in one of them, contacts are taken to alternate.
constexpr std::size_t most_fitted = 5;
constexpr int rings_around = 3;  // rings of triangles that a patch has around changed vertices
/// Share of the vertices; a factor costs little more than a larger patch.
constexpr double largest_patch = 0.4;

void grow(const Shell& shell, std::vector<char>& flags) {
    const std::vector<char> before = flags;
    for (const TriangleStencil& triangle : shell.triangles)
        if (std::ranges::any_of(triangle.vertices, [&](Index v) { return before[v] != 0; }))
            for (const Index vertex : triangle.vertices) flags[vertex] = 1;
}

/// Inertia and mass damping of each vertex's piece, N/m, [N]: the only resistance of a loose piece to a rigid
/// motion, and small beside the elastic stiffness of a small piece. 0 where pins or guides hold the piece,
/// and for bodies, whose diagonal blocks have no elastic stiffness.
VectorXd inertia_of_pieces(const Potential& potential) {
    const Shell& shell = potential.mechanics();
    const Pieces all = pieces(shell);
    const auto vertices = static_cast<Index>(shell.mass.size());
    VectorXd mass = VectorXd::Zero(all.count), result = VectorXd::Zero(vertices + potential.body_columns());
    for (Index v = 0; v < vertices; ++v) mass[all.of_vertex[v]] += shell.mass[v];
    for (Index v = 0; v < vertices; ++v)
        if (shell.fixed[v] || shell.guide[v]) mass[all.of_vertex[v]] = 0;
    const double hessian_per_mass = potential.hessian_per_mass();
    for (Index v = 0; v < vertices; ++v) result[v] = hessian_per_mass * mass[all.of_vertex[v]];
    return result;
}

/// Whether a change is at most `allowed`, a positive definite matrix, in every direction.
bool is_within(const Matrix3d& change, const Matrix3d& allowed) {
    const Matrix3d inverse_root = allowed.llt().matrixL().solve(Matrix3d::Identity());
    return (inverse_root * change * inverse_root.transpose()).norm() <= 1;
}

}  // namespace

void LaggedSystem::factorize(const Potential& potential, const Positions& x) {
    if (outdated) system.topology_changed({}, potential, x);
    outdated = false;
    sources.clear();  // if the next line throws, there is no factor
    system.factorize(potential, x);
    sources.resize(x.cols());
    std::iota(sources.begin(), sources.end(), 0);
    cracked.assign(x.cols(), 0);
    frames = inverse_frames(potential.mechanics(), x);
    rotations.clear();
    of_piece = inertia_of_pieces(potential);
    in_factor = potential.contact_stiffness(x);
    reset(x);
}

void LaggedSystem::reset(Positions x) {
    patch.clear();
    fitted.clear();
    fitted.push_back({in_factor, std::move(x)});
    fits_two = false;
}

void LaggedSystem::turn(const Potential& potential, const Positions& x) {
    rotations = vertex_rotations(potential.mechanics(), frames, x);
    rotations.resize(x.cols(), Matrix3d::Identity());
    of_piece = inertia_of_pieces(potential);
    reset();
}

bool LaggedSystem::differ(std::size_t vertex, const Matrix3d& stiffness, const Matrix3d& known,
                          double part) const {
    if (stiffness == known) return false;
    const Matrix3d change = stiffness - known, allowed = part * known;
    const double loose = of_piece[static_cast<Eigen::Index>(vertex)];
    if (loose > 0 && !is_within(change, allowed + small_change * (known + loose * Matrix3d::Identity())))
        return true;
    const Matrix3d block = small_change * system.hessian().diagonal_block(sources[vertex]);
    if (rotations.empty()) return !is_within(change, allowed + block);
    const Matrix3d& turn = rotations[vertex];
    return !is_within(turn.transpose() * change * turn, turn.transpose() * allowed * turn + block);
}

std::vector<char> LaggedSystem::changed(const Shell& shell, const std::vector<Matrix3d>& stiffness) const {
    std::vector<char> flags = cracked;
    for (std::size_t v = 0; v < flags.size(); ++v)
        if (differ(v, stiffness[v], in_factor[v], 0) ||
            (fits_two && differ(v, fitted.back().stiffness[v], in_factor[v], 0)))
            flags[v] = 1;
    if (std::ranges::count(flags, 1) == 0) return flags;
    for (int ring = 0; ring < rings_around; ++ring) grow(shell, flags);
    return flags;
}

bool LaggedSystem::is_unchanged(const std::vector<Matrix3d>& stiffness, std::size_t count) const {
    const std::size_t first = fitted.size() - std::min(count, fitted.size());
    for (std::size_t v = 0; v < stiffness.size(); ++v) {
        std::size_t i = fitted.size();
        while (i > first && differ(v, stiffness[v], fitted[i - 1].stiffness[v], small_part)) --i;
        if (i == first) return false;
    }
    return true;
}

LaggedSystem::Fit LaggedSystem::fit(const Potential& potential, const Positions& x) {
    std::vector<Matrix3d> stiffness = potential.contact_stiffness(x);
    const bool is_patched = !patch.empty() || std::ranges::count(cracked, 1) == 0;
    if (is_patched && is_unchanged(stiffness, fits_two ? 2 : 1)) return Fit::fits;
    const Positions& before = fitted.back().x;
    fits_two = fitted.size() == most_fitted && before.size() > 0 && is_unchanged(stiffness, most_fitted);
    const std::vector<char> inside = changed(potential.mechanics(), stiffness);
    const auto count = static_cast<double>(std::ranges::count(inside, 1));
    patch.clear();
    if (count > largest_patch * static_cast<double>(inside.size())) return Fit::needs_factor;
    if (graph.size() == 0) graph = VertexGraph(static_cast<Index>(inside.size()), potential.pattern());
    if (count > 0 && !patch.build(potential, graph, x, fits_two ? &before : nullptr, inside, threads))
        return Fit::needs_factor;
    for (std::size_t v = 0; v < inside.size(); ++v)
        if (!inside[v]) stiffness[v] = in_factor[v];
    fitted.push_back({std::move(stiffness), x});
    if (fitted.size() > most_fitted) fitted.pop_front();
    return Fit::patched;
}

Positions LaggedSystem::solve_lagged(const Potential& potential, const Positions& right_side) {
    Positions gathered = Positions::Zero(3, system.hessian().size() / 3);
    for (std::size_t v = 0; v < sources.size(); ++v) {
        const auto column = right_side.col(static_cast<Eigen::Index>(v));
        if (rotations.empty())
            gathered.col(sources[v]) += column;
        else
            gathered.col(sources[v]) += rotations[v].transpose() * column;
    }
    const Positions solution = system.solve(potential, gathered);
    Positions motion(3, right_side.cols());
    for (std::size_t v = 0; v < sources.size(); ++v) {
        const auto column = solution.col(sources[v]);
        motion.col(static_cast<Eigen::Index>(v)) =
            rotations.empty() ? Vector3d(column) : rotations[v] * column;
    }
    return motion;
}

Positions LaggedSystem::solve(const Potential& potential, const Positions& right_side) {
    if (patch.empty()) return solve_lagged(potential, right_side);
    Positions motion = patch.solve(right_side);
    motion += solve_lagged(potential, patch.residual(right_side, motion));
    motion += patch.solve(patch.residual(right_side, motion));
    return motion;
}

void LaggedSystem::topology_changed(const ShellChange& change, Index body_columns) {
    outdated = true;
    system.follow(change);
    graph = {};
    if (change.remeshes()) sources.clear();
    if (!has_factor()) return;
    const auto insert = [&](auto& of_columns, auto value) {
        of_columns.insert(of_columns.end() - body_columns, value);
    };
    for (const IndexWithParents& inserted : change.vertices) {
        if (inserted.parents.empty()) return sources.clear();
        const Index parent = inserted.parents.front().element;
        insert(sources, sources[parent]);
        insert(in_factor, in_factor[parent]);
        cracked[parent] = 1;
        insert(cracked, char{1});
    }
    reset();
    rotations.clear();
}

void LaggedSystem::visit_state(StateVisitor& visit) {
    auto& [threads, system, outdated, sources, cracked, frames, rotations, of_piece, in_factor, fitted,
           fits_two, graph, patch] = *this;
    visit(system, outdated, sources, cracked, frames, in_factor);
    if (has_factor()) system.visit_factor(visit);
}

}  // namespace sherd
