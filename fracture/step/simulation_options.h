// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shell/face_fields.h"
#include "core/time/stepper.h"
#include "fracture/cracks/breaking.h"
#include "fracture/record/gauge.h"

namespace sherd {

/// A vertex, numbered over all inputs, and its supports, each with the directions in which it holds the
/// vertex. The vertex can move in the remaining directions.
struct SupportedVertex {
    Index vertex = 0;
    std::vector<SupportDirections> by;
};

struct SimulationOptions {
    /// Loads, winds and mirrors refer to the triangles of all sheets, numbered in the order of the inputs. A
    /// step that cannot be solved is shorter than stepper.step. stepper.tolerance is computed from
    /// `tolerance`.
    StepperOptions stepper = {.contact = {.sheets = true}};
    std::vector<Edge> cracks;  ///< edges that have failed before the run, numbered over all inputs
    /// Vertices that are held, and their supports, whose numbers are less than StepperOptions::supports.
    std::vector<SupportedVertex> supported_vertices;
    std::vector<Gauge> gauges;  ///< gauges, on faces that are numbered over all inputs
    FaceFieldChoice fields;     ///< fields of faces in snapshots
    int max_iterations = 50;    ///< limit on the minimiser's iterations, except between two stages
    double tolerance = 1e-6;    ///< largest coordinate of the minimiser's last correction, in mean edge
                                ///< lengths
    BreakingRule rule = BreakingRule::staged;
    int max_stages = 100;  ///< limit on the stages of staged breaking in one step
    /// Whether implicit and explicit steps alternate (StepPolicy), beginning with implicit ones. Explicit
    /// steps have the length stepper.step, halved until it is at most `explicit_step`, and up to 16 times
    /// this length while no edge will fail soon (Breaker::time_left()). If an explicit step fails
    /// (Outcome::failed), it and some steps after it are made with the implicit scheme.
    bool alternates = false;
    double explicit_step = 2e-6;  ///< s, see `alternates`
    /// Whether the run ends with the first hinges that fail. The step is halved as often as possible to find
    /// the time of their failure; after it no new equilibrium is sought.
    bool until_crack = false;
};

}  // namespace sherd
