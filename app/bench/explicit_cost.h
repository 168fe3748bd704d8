// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace sherd {

/// What explicit steps cost, and judging what breaks at the end of each.
struct ExplicitCost {
    std::size_t faces = 0;
    double substeps = 0;  ///< in a step
    double step = 0;      ///< s, the least of many: processor time of one thread, wall time of several

    /// Faces times substeps a second.
    double face_steps() const { return static_cast<double>(faces) * substeps / step; }
};

/// Measures it on a disc of about 6,000 faces that falls on a steel nose, in steps of 2e-6 s; sheets do not
/// touch each other, and nothing breaks. model: see shell_variant().
ExplicitCost explicit_cost(const std::string& model, int threads);

/// Faces times substeps a second that one thread would make if it did nothing but read and write what a
/// substep has to, from caches as large as this many faces fill.
double explicit_bound(std::size_t faces);

}  // namespace sherd
