// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solver/linear/multifrontal.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "core/solver/linear/dense_elimination.h"

namespace sherd {
namespace {

/// Number of entries of a factor below which threads cost more time than they save.
constexpr double least_entries = 2e5;

/// Largest share of all operations that a subtree in a part may have. With a smaller share, more operations
/// would be above the parts, where threads share only strips of dense matrices.
constexpr double largest_part = 1.0 / 6;

/// Number of operations of each supernode's subtree, counted as in Supernodes::operations(), but in
/// operations on blocks, which count 27 there.
std::vector<double> subtree_operations(const Supernodes& pattern) {
    std::vector<double> all(pattern.size());
    for (Index node = 0; node < pattern.size(); ++node) {
        all[node] += std::pow(static_cast<double>(pattern.rows(node).size()), 2) * pattern.columns(node);
        if (pattern.parent[node] >= 0) all[pattern.parent[node]] += all[node];
    }
    return all;
}

/// Number of operations on blocks that the largest subtree in a part may have.
double most_in_a_subtree(const Supernodes& pattern) {
    if (pattern.factor_entries() < least_entries) return std::numeric_limits<double>::infinity();
    return largest_part * pattern.operations() / 27;
}

EliminationPart part_of(const Supernodes& pattern, Index begin, Index end) {
    EliminationPart part{begin, end, pattern.first[begin], pattern.first[end] - pattern.first[begin], {}};
    for (Index node = begin; node < end; ++node) {
        if (pattern.parent[node] < end && pattern.parent[node] >= 0) continue;
        // The supernode is the root of a subtree in the part, and its rows include all rows of this subtree
        // outside of the part.
        const std::span<const Index> rows = pattern.rows_below(node);
        part.outside.insert(part.outside.end(), rows.begin(), rows.end());
    }
    std::ranges::sort(part.outside);
    part.outside.erase(std::unique(part.outside.begin(), part.outside.end()), part.outside.end());
    return part;
}

void find_places(const Supernodes& pattern, const EliminationPart& part, std::vector<Index>& place) {
    for (std::size_t i = pattern.start[part.first]; i < pattern.start[part.end]; ++i) {
        const Index row = pattern.row[i];
        if (row < part.first_column + part.columns)
            place[i] = row - part.first_column;
        else
            place[i] = part.columns +
                       static_cast<Index>(std::ranges::lower_bound(part.outside, row) - part.outside.begin());
    }
}

constexpr Index nodes_at_once = 64, columns_at_once = 512;

std::vector<Index> nodes_of(const EliminationPart& part) {
    std::vector<Index> nodes(part.end - part.first);
    std::iota(nodes.begin(), nodes.end(), part.first);
    return nodes;
}

}  // namespace

EliminationParts::EliminationParts(const Supernodes& pattern)
    : is_above(pattern.size(), 0), place(pattern.row) {
    const std::vector<double> operations = subtree_operations(pattern);
    const double most = most_in_a_subtree(pattern);
    for (Index node = 0; node < pattern.size(); ++node) is_above[node] = operations[node] > most;
    Index begin = 0;
    double in_part = 0;
    const auto end_part = [&](Index end) {
        if (begin < end) parts.push_back(part_of(pattern, begin, end));
        begin = end;
        in_part = 0;
    };
    // Children are numbered before their parents, so that each subtree is a consecutive range. A supernode
    // above comes after its own subtrees, possibly between others, and ends the part before it.
    for (Index node = 0; node < pattern.size(); ++node) {
        const Index parent = pattern.parent[node];
        if (is_above[node] != 0) {
            end_part(node);
            above.push_back(begin++);
        } else if (parent < 0 || is_above[parent] != 0) {
            in_part += operations[node];
            if (in_part > most / 2) end_part(node + 1);
        }
    }
    end_part(pattern.size());
    for (const EliminationPart& part : parts) find_places(pattern, part, place);
}

template <class Real>
MultifrontalFactor<Real>::MultifrontalFactor(std::shared_ptr<const Supernodes> of, Threads threads)
    : pattern(std::move(of)),
      threads(std::move(threads)),
      shares(*pattern),
      children(pattern->size()),
      in_parent(pattern->row.size(), -1),
      stacks(shares.parts.size() + 1),
      update(pattern->size()),
      diagonal_before(3 * pattern->place.size()) {
    start.push_back(0);
    for (Index node = 0; node < pattern->size(); ++node)
        start.push_back(start.back() + static_cast<std::size_t>(height(node)) * width(node));
    values.resize(start.back());
    find_children();
    for (std::size_t p = 0; p < shares.parts.size(); ++p)
        stacks[p].values.resize(stack_size(nodes_of(shares.parts[p])));
    stacks.back().values.resize(stack_size(shares.above));
}

template <class Real>
void MultifrontalFactor<Real>::find_children() {
    for (Index node = 0; node < pattern->size(); ++node) {
        const Index parent = pattern->parent[node];
        if (parent < 0) continue;
        children[parent].push_back(node);
        const std::span<const Index> rows = pattern->rows(parent);
        auto at = rows.begin();
        std::size_t i = pattern->start[node] + pattern->columns(node);
        for (const Index row : pattern->rows_below(node)) {
            while (*at < row) ++at;
            in_parent[i++] = static_cast<Index>(at - rows.begin());
        }
    }
}

template <class Real>
std::size_t MultifrontalFactor<Real>::size_of_children(Index node) const {
    std::size_t sum = 0;
    for (const Index child : children[node])
        if (shares.is_above[child] == shares.is_above[node]) sum += update_size(child);
    return sum;
}

template <class Real>
std::size_t MultifrontalFactor<Real>::stack_size(const std::vector<Index>& nodes) const {
    std::size_t top = 0, highest = 0;
    for (const Index node : nodes) {
        top += update_size(node);
        highest = std::max(highest, top);
        top -= size_of_children(node);
    }
    return highest;
}

template <class Real>
void MultifrontalFactor<Real>::scatter(const BlockMatrix& matrix) {
    threads.share_ranges(pattern->size(), nodes_at_once,
                         [&](Index begin, Index end) { std::fill(panel(begin), panel(end), Real(0)); });
    threads.share_ranges(matrix.size() / 3, columns_at_once, [&](Index begin, Index end) {
        for (Index vertex = begin; vertex < end; ++vertex) scatter_column(matrix, vertex);
    });
}

template <class Real>
void MultifrontalFactor<Real>::scatter_column(const BlockMatrix& matrix, Index j) {
    const Index own = pattern->place[j], node = pattern->of_column[own];
    const Index diagonal = own - pattern->first[node];
    for (Index c = 0; c < 3; ++c) {
        const double* value = matrix.values().data() + matrix.columns()[3 * j + c];
        Real* const target = column_of(panel(node), height(node), 3 * diagonal + c) + 3 * diagonal;
        diagonal_before[3 * own + c] = static_cast<Real>(*value);
        for (Index r = c; r < 3; ++r) target[r] = static_cast<Real>(*value++);
        for (Index b = matrix.block_columns()[j]; b < matrix.block_columns()[j + 1]; ++b, value += 3) {
            const Index other = pattern->place[matrix.block_rows()[b]], below = pattern->block_place[b];
            const Index left = std::min(own, other), of = pattern->of_column[left];
            const Index column = 3 * (left - pattern->first[of]), rows = height(of);
            for (Index r = 0; r < 3; ++r) {
                const auto [down, right] = own < other ? std::pair(r, c) : std::pair(c, r);
                column_of(panel(of), rows, column + right)[3 * below + down] = static_cast<Real>(value[r]);
            }
        }
    }
}

template <class Real>
void MultifrontalFactor<Real>::extend(Index child, Index node, Columns columns, Real* target) const {
    const Index size = static_cast<Index>(pattern->rows_below(child).size()), own = pattern->columns(node);
    const Index* const place = in_parent.data() + pattern->start[child] + pattern->columns(child);
    const auto split = static_cast<Index>(std::lower_bound(place, place + size, own) - place);
    const bool below = columns == Columns::below;
    const Index first = below ? own : 0, stride = below ? height(node) - width(node) : height(node);
    for (Index b = below ? split : 0; b < (below ? size : split); ++b)
        for (Index c = 0; c < 3; ++c) {
            const Real* const from = column_of(update[child], 3 * size, 3 * b + c);
            Real* const to = column_of(target, stride, 3 * (place[b] - first) + c) - 3 * first;
            for (Index a = b; a < size; ++a) {
                Real* const at = to + 3 * place[a];
                for (Index r = 0; r < 3; ++r) at[r] += from[3 * a + r];
            }
        }
}

template <class Real>
std::size_t MultifrontalFactor<Real>::update_size(Index node) const {
    const auto below = static_cast<std::size_t>(height(node) - width(node));
    return below * below;
}

template <class Real>
double MultifrontalFactor<Real>::eliminate(Index node, Stack& stack, const Threads& team) {
    const Index rows = height(node), columns = width(node);
    for (const Index child : children[node]) extend(child, node, Columns::own, panel(node));
    if (const Index j = eliminate_columns(panel(node), rows, columns, team); j < columns) {
        const double share =
            column_of(panel(node), rows, j)[j] / std::abs(diagonal_before[3 * pattern->first[node] + j]);
        return share < 1 ? share : 0;  // 0: not a number, or infinite
    }
    Real* const left = stack.values.data() + stack.top;
    negative_square(panel(node) + columns, rows, rows - columns, columns, left, team);
    for (const Index child : children[node]) extend(child, node, Columns::below, left);
    stack.top -= size_of_children(node);
    Real* const place = stack.values.data() + stack.top;
    if (place != left) std::copy_n(left, update_size(node), place);
    update[node] = place;
    stack.top += update_size(node);
    return 1;
}

template <class Real>
bool MultifrontalFactor<Real>::factorize(const BlockMatrix& matrix) {
    scatter(matrix);
    for (Stack& stack : stacks) stack.top = 0;
    const auto parts = static_cast<Index>(shares.parts.size());
    std::vector<double> of_part(parts, 1);
    threads.share(parts, [&](Index p) {
        const EliminationPart& part = shares.parts[p];
        for (Index node = part.first; node < part.end && of_part[p] == 1; ++node)
            of_part[p] = eliminate(node, stacks[p], Threads());
    });
    pivot = parts > 0 ? std::ranges::min(of_part) : 1;
    for (auto node = shares.above.begin(); node != shares.above.end() && pivot == 1; ++node)
        pivot = eliminate(*node, stacks.back(), threads);
    return pivot == 1;
}

/// Forward substitution y <- L^-1 * y in the columns of a supernode, with its effect on the rows below.
/// below: a buffer.
template <class Real>
void MultifrontalFactor<Real>::solve_forward(Index node, Vector& y, Vector& below) const {
    const Index rows = height(node), columns = width(node), rest = rows - columns;
    const Index* const at = places(node);
    substitute_forward(panel(node), rows, columns, y.data() + 3 * at[0], below.data());
    for (Index a = 0; a < rest / 3; ++a)
        y.template segment<3>(3 * at[columns / 3 + a]) -= below.template segment<3>(3 * a);
}

/// Back substitution y <- L^-T * y in the columns of a supernode, from the rows below. below: a buffer.
template <class Real>
void MultifrontalFactor<Real>::solve_backward(Index node, Vector& y, Vector& below) const {
    const Index rows = height(node), columns = width(node), rest = rows - columns;
    const Index* const at = places(node);
    for (Index a = 0; a < rest / 3; ++a)
        below.template segment<3>(3 * a) = y.template segment<3>(3 * at[columns / 3 + a]);
    substitute_back(panel(node), rows, columns, y.data() + 3 * at[0], below.data());
}

template <class Real>
VectorXd MultifrontalFactor<Real>::solve(const VectorXd& right_side) const {
    const auto vertices = static_cast<Index>(pattern->place.size());
    const double scale = right_side.size() > 0 ? right_side.cwiseAbs().maxCoeff() : 0;
    if (!(scale > 0)) return VectorXd::Zero(right_side.size());
    Vector y(right_side.size());
    Vector below = Vector::Zero(right_side.size());  // BLAS may read entries that it overwrites
    for (Index v = 0; v < vertices; ++v)
        y.template segment<3>(3 * pattern->place[v]) =
            (right_side.segment<3>(3 * v) / scale).template cast<Real>();

    const auto& parts = shares.parts;
    std::vector<Vector> of_part(parts.size()), buffers(parts.size());
    threads.share(static_cast<Index>(parts.size()), [&](Index p) {
        const Index own = 3 * parts[p].columns, outside = 3 * static_cast<Index>(parts[p].outside.size());
        of_part[p].setZero(own + outside);
        of_part[p].head(own) = y.segment(3 * parts[p].first_column, own);
        buffers[p].setZero(own + outside);
        for (Index node = parts[p].first; node < parts[p].end; ++node)
            solve_forward(node, of_part[p], buffers[p]);
    });
    const auto outside = [&](std::size_t p, const auto& with) {
        for (std::size_t i = 0; i < parts[p].outside.size(); ++i)
            with(y.template segment<3>(3 * parts[p].outside[i]),
                 of_part[p].template segment<3>(3 * (parts[p].columns + static_cast<Index>(i))));
    };
    for (std::size_t p = 0; p < parts.size(); ++p)
        outside(p, [](auto&& all, auto&& of_this) { all += of_this; });
    for (const Index node : shares.above) solve_forward(node, y, below);
    for (auto node = shares.above.rbegin(); node != shares.above.rend(); ++node)
        solve_backward(*node, y, below);
    threads.share(static_cast<Index>(parts.size()), [&](Index p) {
        outside(p, [](auto&& all, auto&& of_this) { of_this = all; });
        for (Index node = parts[p].end - 1; node >= parts[p].first; --node)
            solve_backward(node, of_part[p], buffers[p]);
        const Index own = 3 * parts[p].columns;
        y.segment(3 * parts[p].first_column, own) = of_part[p].head(own);
    });

    VectorXd x(right_side.size());
    for (Index v = 0; v < vertices; ++v)
        x.segment<3>(3 * v) = scale * y.template segment<3>(3 * pattern->place[v]).template cast<double>();
    return x;
}

template class MultifrontalFactor<float>;
template class MultifrontalFactor<double>;

}  // namespace sherd
