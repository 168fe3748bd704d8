// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solver/linear/supernodes.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "core/solver/linear/cholmod_session.h"

namespace sherd {
namespace {

/// Number of vertices below which minimum degree orders as well as nested dissection, and faster.
constexpr Index vertices_for_nested_dissection = 1000;

/// View of the graph of a matrix's blocks for CHOLMOD, without the diagonal; nothing is copied.
cholmod_sparse graph(const BlockMatrix& matrix) {
    cholmod_sparse sparse{};
    sparse.nrow = sparse.ncol = static_cast<std::size_t>(matrix.size() / 3);
    sparse.nzmax = matrix.block_rows().size();
    sparse.p = const_cast<Index*>(matrix.block_columns().data());
    sparse.i = const_cast<Index*>(matrix.block_rows().data());
    sparse.stype = -1;
    sparse.itype = CHOLMOD_INT;
    sparse.xtype = CHOLMOD_PATTERN;
    sparse.dtype = CHOLMOD_DOUBLE;
    sparse.sorted = sparse.packed = 1;
    return sparse;
}

/// CHOLMOD's analysis of the pattern of a factor.
class Analysis {
  public:
    explicit Analysis(const BlockMatrix& matrix, const std::vector<Index>& order = {}) {
        session.common.supernodal = CHOLMOD_SUPERNODAL;
        session.common.method[0].ordering =
            matrix.size() / 3 < vertices_for_nested_dissection ? CHOLMOD_AMD : CHOLMOD_METIS;
        // CHOLMOD's limits count unknowns; here each column stands for three unknowns.
        for (std::size_t& columns : session.common.nrelax) columns = (columns + 2) / 3;
        cholmod_sparse sparse = graph(matrix);
        if (!order.empty()) session.common.method[0].ordering = CHOLMOD_GIVEN;
        Index* const given = order.empty() ? nullptr : const_cast<Index*>(order.data());
        factor = cholmod_analyze_p(&sparse, given, nullptr, 0, &session.common);
        session.require(factor != nullptr, "analyze the matrix");
    }
    ~Analysis() { cholmod_free_factor(&factor, &session.common); }
    Analysis(const Analysis&) = delete;

    const cholmod_factor& pattern() const { return *factor; }
    template <class T>
    static std::span<const T> array(const void* data, std::size_t size) {
        return {static_cast<const T*>(data), size};
    }

  private:
    CholmodSession session;
    cholmod_factor* factor = nullptr;
};

void find_parents(Supernodes& nodes) {
    for (Index node = 0; node + 1 < static_cast<Index>(nodes.first.size()); ++node) {
        nodes.of_column.insert(nodes.of_column.end(), nodes.first[node + 1] - nodes.first[node], node);
    }
    for (Index node = 0; node + 1 < static_cast<Index>(nodes.first.size()); ++node) {
        const std::size_t below = nodes.start[node] + nodes.first[node + 1] - nodes.first[node];
        nodes.parent.push_back(below < nodes.start[node + 1] ? nodes.of_column[nodes.row[below]] : -1);
    }
}

void place_blocks(const BlockMatrix& matrix, Supernodes& nodes) {
    nodes.block_place.reserve(matrix.block_rows().size());
    for (Index j = 0; j < matrix.size() / 3; ++j)
        for (Index b = matrix.block_columns()[j]; b < matrix.block_columns()[j + 1]; ++b) {
            const auto [column, row] = std::minmax(nodes.place[matrix.block_rows()[b]], nodes.place[j]);
            const std::span<const Index> rows = nodes.rows(nodes.of_column[column]);
            nodes.block_place.push_back(
                static_cast<Index>(std::ranges::lower_bound(rows, row) - rows.begin()));
        }
}

}  // namespace

std::vector<Index> Supernodes::order() const {
    std::vector<Index> vertex(place.size());
    for (std::size_t v = 0; v < place.size(); ++v) vertex[place[v]] = static_cast<Index>(v);
    return vertex;
}

double Supernodes::factor_entries() const {
    double sum = 0;
    for (Index node = 0; node < size(); ++node)
        sum += 9.0 * static_cast<double>(rows(node).size()) * columns(node);
    return sum;
}

double Supernodes::operations() const {
    double sum = 0;
    for (Index node = 0; node < size(); ++node)
        sum += 27.0 * std::pow(static_cast<double>(rows(node).size()), 2) * columns(node);
    return sum;
}

Supernodes supernodes(const BlockMatrix& matrix, const std::vector<Index>& given) {
    const Analysis analysis(matrix, given);
    const cholmod_factor& factor = analysis.pattern();
    Supernodes nodes;
    nodes.place.resize(factor.n);
    const auto order = Analysis::array<Index>(factor.Perm, factor.n);
    for (std::size_t at = 0; at < factor.n; ++at) nodes.place[order[at]] = static_cast<Index>(at);
    const auto first = Analysis::array<Index>(factor.super, factor.nsuper + 1);
    const auto start = Analysis::array<Index>(factor.pi, factor.nsuper + 1);
    const auto row = Analysis::array<Index>(factor.s, factor.ssize);
    nodes.first.assign(first.begin(), first.end());
    nodes.start.assign(start.begin(), start.end());
    nodes.row.assign(row.begin(), row.end());
    find_parents(nodes);
    place_blocks(matrix, nodes);
    return nodes;
}

std::vector<Index> elimination_order(const BlockMatrix& matrix) {
    const Analysis analysis(matrix);
    const auto order = Analysis::array<Index>(analysis.pattern().Perm, analysis.pattern().n);
    return {order.begin(), order.end()};
}

std::vector<Index> with_children(const std::vector<Index>& order, const std::vector<Index>& parents) {
    if (order.empty()) return {};
    std::vector<Index> next(order.size() + parents.size(), -1);
    for (std::size_t i = 0; i + 1 < order.size(); ++i) next[order[i]] = order[i + 1];
    auto child = static_cast<Index>(order.size());
    for (const Index parent : parents) {
        next[child] = next[parent];
        next[parent] = child++;
    }
    std::vector<Index> all;
    for (Index v = order.front(); v >= 0; v = next[v]) all.push_back(v);
    return all;
}

}  // namespace sherd
