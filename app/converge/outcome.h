// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/scene/scene.h"

namespace sherd {

/// A number that a run ends with.
struct Quantity {
    std::string name, unit;
    double value = 0;
};

/// What a run of a scene comes to, without a recording.
struct Outcome {
    std::size_t faces = 0;
    std::int64_t steps = 0, cracks = 0;
    double seconds = 0;  ///< of wall time
    /// Each gauge gives what it records: displacement, principal stress, curvature and membrane strain at the
    /// end and the largest one, and the components of the last three at the end. Each support and obstacle
    /// gives its largest force. The elastic energy at the end, the peaks of hinges and, in statics, the
    /// largest load and the one at which it fell for the first time follow.
    std::vector<Quantity> quantities;
};

/// Runs the scene. Throws what a run throws.
Outcome outcome(const Scene& scene);

/// The scene with the edges of all its meshes `times` as long. Throws Error where a mesh comes from a file
/// and is not remeshed.
Scene with_edges(Scene scene, double times);
/// The scene with steps `times` as long.
Scene with_steps(Scene scene, double times);

}  // namespace sherd
