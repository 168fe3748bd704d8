// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shell/face_fields.h"
#include "core/time/stepper.h"
#include "fracture/cracks/breaking.h"
#include "fracture/record/gauge.h"

namespace sherd {

/// A vertex, numbered over all inputs, and its supports, each with the directions that it holds. The vertex
/// moves in the remaining directions.
struct SupportedVertex {
    Index vertex = 0;
    std::vector<SupportDirections> by;
};

struct SimulationOptions {
    /// Loads, winds and mirrors refer to the triangles of all sheets, numbered in the order of the inputs. A
    /// step that cannot be solved is halved. The stepper's tolerance is set from `tolerance`.
    StepperOptions stepper = {.contact = {.sheets = true}};
    std::vector<Edge> cracks;  ///< edges that have failed before the run, numbered over all inputs
    /// Vertices with supports numbered below StepperOptions::supports.
    std::vector<SupportedVertex> supported_vertices;
    std::vector<Gauge> gauges;  ///< at the start
    FaceFieldChoice fields;     ///< fields of snapshots
    int max_iterations = 50;    ///< limit on those of the minimiser, except between two stages
    double tolerance = 1e-6;    ///< largest coordinate of the last correction, in mean edge lengths
    BreakingRule rule = BreakingRule::staged;
    int max_stages = 100;  ///< stages of staged breaking in one step
    /// Whether implicit and explicit steps alternate (StepPolicy), beginning with implicit ones. Explicit
    /// steps have the stepper's length, halved until it is at most explicit_step, s. If one fails
    /// (Outcome::failed), it is made with implicit steps, as are some after it.
    bool alternates = false;
    double explicit_step = 2e-6;
    /// Whether the run ends with the first hinges that fail. The step is halved as often as possible to find
    /// their time; no new equilibrium is sought.
    bool until_crack = false;
};

}  // namespace sherd
