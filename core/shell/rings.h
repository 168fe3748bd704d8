// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "core/shell/shell.h"

namespace sherd {

/// Marks the next ring of vertices: raises the entries of all corners of the faces that have a corner with an
/// entry of at least `mark` to it. marks: [V].
template <class Mark>
void add_ring(const Shell& shell, Mark mark, std::vector<Mark>& marks) {
    const std::vector<Mark> before = marks;
    for (const TriangleStencil& triangle : shell.triangles)
        if (std::ranges::any_of(triangle.vertices, [&](Index v) { return before[v] >= mark; }))
            for (const Index v : triangle.vertices) marks[v] = std::max(marks[v], mark);
}

}  // namespace sherd
