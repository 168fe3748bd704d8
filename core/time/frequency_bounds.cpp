// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time/frequency_bounds.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "core/block_matrix.h"
#include "core/shell/rings.h"

namespace sherd {
namespace {

/// Rings of vertices around a change whose rows of the Hessian depend on it, and further rings that contain
/// the vertices of all elements that these rows consist of. A face's energy of coupled hinges depends on the
/// patches around its three sides.
constexpr int rings_of_change = 4, rings_of_element = 4;

/// Hash of a sequence of numbers, by multiplication and shift.
class Hash {
  public:
    Hash& operator<<(std::uint64_t next) {
        state = (state ^ next) * 0x9e3779b97f4a7c15U;
        state ^= state >> 29;
        return *this;
    }
    Hash& operator<<(double next) { return *this << std::bit_cast<std::uint64_t>(next); }
    std::uint64_t value() const { return state; }

  private:
    std::uint64_t state = 1;
};

/// Hashes of each vertex's faces, hinges and mass, whatever their order.
std::vector<std::uint64_t> surroundings_of(const Shell& shell) {
    std::vector<std::uint64_t> all(shell.mass.size());
    for (std::size_t v = 0; v < all.size(); ++v)
        all[v] = (Hash() << shell.mass[static_cast<Index>(v)] << std::uint64_t(shell.fixed[v])).value();
    const auto add = [&](const auto& vertices, double shape) {
        Hash element;
        for (const Index v : vertices) element << std::uint64_t(v);
        element << shape;
        for (const Index v : vertices) all[v] += element.value();
    };
    for (const TriangleStencil& triangle : shell.triangles) add(triangle.vertices, triangle.membrane.area);
    for (const HingeStencil& hinge : shell.hinges) add(hinge.vertices, hinge.rest.angle);
    return all;
}

void grow(const Shell& shell, int rings, std::vector<char>& marks) {
    for (int ring = 0; ring < rings; ++ring) add_ring(shell, char{1}, marks);
}

std::vector<Index> marked_in(const std::vector<char>& marked) {
    std::vector<Index> some;
    for (std::size_t v = 0; v < marked.size(); ++v)
        if (marked[v] != 0) some.push_back(static_cast<Index>(v));
    return some;
}

}  // namespace

void FrequencyBounds::find(std::span<Energy* const> energies, const Shell& shell, const Positions& x) {
    surroundings = surroundings_of(shell);
    square = VectorXd::Zero(x.cols());
    find_near(energies, shell, x, std::vector<char>(surroundings.size(), 1));
}

void FrequencyBounds::follow(std::span<Energy* const> energies, const Shell& shell, const Positions& x) {
    const std::vector<std::uint64_t> before = std::exchange(surroundings, surroundings_of(shell));
    std::vector<char> changed(surroundings.size(), 1);
    for (std::size_t v = 0; v < before.size(); ++v) changed[v] = before[v] != surroundings[v];
    square.conservativeResize(x.cols());
    grow(shell, rings_of_change, changed);
    find_near(energies, shell, x, std::move(changed));
}

void FrequencyBounds::find_near(std::span<Energy* const> energies, const Shell& shell, const Positions& x,
                                std::vector<char> near) {
    std::vector<char> inside = near;
    if (std::ranges::find(near, 0) != near.end()) grow(shell, rings_of_element, inside);
    const std::vector<Index> some = marked_in(inside);
    std::vector<std::pair<Index, Index>> pairs;
    for (const Energy* energy : energies) energy->add_pattern_among(inside, pairs);
    BlockMatrix hessian = BlockMatrix::part(some, static_cast<Index>(x.cols()), pairs, {}, {}, {});
    for (const Energy* energy : energies) energy->add_hessian(x, Curvature::exact, hessian);
    VectorXd sums = VectorXd::Zero(static_cast<Eigen::Index>(some.size()));
    for (Index j = 0; j < static_cast<Index>(some.size()); ++j) {
        if (shell.fixed[some[j]]) continue;
        sums[j] += hessian.diagonal_block(j).norm();
        for (Index b = hessian.block_columns()[j]; b < hessian.block_columns()[j + 1]; ++b) {
            const Index i = hessian.block_rows()[b];
            if (shell.fixed[some[i]]) continue;
            const double norm = hessian.block_below(b, j).norm();
            sums[i] += norm;
            sums[j] += norm;
        }
    }
    for (Index i = 0; i < static_cast<Index>(some.size()); ++i)
        if (near[some[i]] != 0) square[some[i]] = sums[i] / shell.mass[some[i]];
    find_fastest(shell);
}

void FrequencyBounds::find_fastest(const Shell& shell) {
    const auto sum = [&](const TriangleStencil& triangle) {
        return square[triangle.vertices[0]] + square[triangle.vertices[1]] + square[triangle.vertices[2]];
    };
    fastest =
        static_cast<Index>(std::ranges::max_element(shell.triangles, {}, sum) - shell.triangles.begin());
}

}  // namespace sherd
