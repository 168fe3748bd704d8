// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batches/corner_sums.h"

#include <numeric>

namespace sherd {

void CornerSums::prepare(Index vertices) {
    start.assign(vertices + 1, 0);
    for (const Index vertex : vertex_of)
        if (vertex >= 0) ++start[vertex + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<Index> next(start.begin(), start.end() - 1);
    at_vertex.resize(start.back());
    for (std::size_t place = 0; place < vertex_of.size(); ++place)
        if (vertex_of[place] >= 0) at_vertex[next[vertex_of[place]]++] = static_cast<Index>(place);
    places.assign(vertex_of.size(), {0});
}

inline void CornerSums::put_negative(Index vertex, double* of_all) const {
    Lanes sum = 0;
    for (Index i = start[vertex]; i < start[vertex + 1]; ++i) sum -= places[at_vertex[i]].coordinates;
    for (int c = 0; c < 3; ++c) of_all[3 * vertex + c] = sum[c];
}

void CornerSums::put_negative(Index begin, Index end, double* of_all) const {
    wide_loop(begin, end, [&](Index vertex) { put_negative(vertex, of_all); });
}

void CornerSums::put_negative(std::span<const Index> some, double* of_all) const {
    wide_loop(0, static_cast<Index>(some.size()), [&](Index i) { put_negative(some[i], of_all); });
}

}  // namespace sherd
