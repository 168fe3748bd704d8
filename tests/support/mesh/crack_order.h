// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "fracture/mesh/crack_mesh.h"
#include "tests/support/shell/random_shapes.h"

namespace sherd::test {

inline void shuffle(std::vector<Edge>& edges, Random& random) {
    for (std::size_t i = 1; i < edges.size(); ++i) std::swap(edges[i], edges[random.below(i + 1)]);
}

inline CrackMesh cracked_one_by_one(const Mesh& mesh, std::span<const Edge> failed) {
    CrackMesh cracks(mesh);
    for (const Edge edge : failed) cracks.fail(std::array{edge});
    return cracks;
}

/// Lets the edges fail in the order of `failed`, in batches of random size, more often small than large.
inline CrackMesh cracked_in_batches(const Mesh& mesh, std::span<const Edge> failed, Random& random) {
    CrackMesh cracks(mesh);
    while (!failed.empty()) {
        const std::size_t batch = 1 + random.below(1 + random.below(failed.size()));
        cracks.fail(failed.first(batch));
        failed = failed.subspan(batch);
    }
    return cracks;
}

}  // namespace sherd::test
