// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/scene/scene.h"

namespace sherd {

/// A result of a run.
struct Quantity {
    std::string name, unit;
    double value = 0;
};

/// Results of a run of a scene, without a recording.
struct RunResults {
    std::size_t faces = 0;
    std::int64_t steps = 0, cracks = 0;
    double seconds = 0;  ///< s, wall time
    /// For each gauge, of the quantities that it records: the final and the largest displacement, principal
    /// stress, principal curvature and principal membrane strain, and the final components of stress,
    /// curvature and membrane strain. For each support and obstacle its largest force. Then the elastic
    /// energy at the end, the largest strain and the largest stress of hinges and, in statics, the largest
    /// load and the load before its first decrease.
    std::vector<Quantity> quantities;
};

/// Runs the scene. Throws the errors of build_scene() and Runner::run().
RunResults results_of(const Scene& scene);

/// Returns the scene with the edges of all its meshes `times` as long. Throws Error if a mesh comes from a
/// file and is not remeshed.
Scene with_edges(Scene scene, double times);
/// Returns the scene with steps `times` as long. Throws Error if a step is longer than the run.
Scene with_steps(Scene scene, double times);

}  // namespace sherd
