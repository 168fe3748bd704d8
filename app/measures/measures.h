// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/measures/crack_branching.h"
#include "app/measures/crack_directions.h"
#include "app/measures/crack_extent.h"
#include "app/measures/fragment_extent.h"
#include "app/measures/fragment_info.h"
#include "app/measures/power_law.h"
#include "app/recording/recording.h"

namespace sherd {

struct MeasuredFragment {
    FragmentInfo info;
    FragmentExtent extent;
};

/// What broke first, and of several at once what was overloaded most.
struct FirstFailure {
    double time = 0;                       ///< s
    double load = 0;                       ///< factor of all loads: 1, but in statics
    Vector3d position = Vector3d::Zero();  ///< m, middle of the edge at rest
};

/// The largest reaction of a support or obstacle.
struct PeakForce {
    RecordedSupport support;
    double force = 0;  ///< N, magnitude
    double time = 0;   ///< s, end of the step
};

/// What a recorded run is compared by with others; app/README.md defines each. Of the last frame, but for
/// what tells its own time.
struct Measures {
    double over = 0;                          ///< kg, of fragments that count
    std::vector<MeasuredFragment> fragments;  ///< heavier than that, the heaviest first
    std::size_t fragments_below = 0;          ///< the others
    double mass_below = 0;                    ///< kg, of these
    std::optional<PowerLaw> mass_law;         ///< of fragments by mass, above `over` or the lightest
    CrackExtent cracks;
    std::optional<double> tortuosity;
    CrackDirections directions;
    bool has_axis = false;  ///< whether they are against the axis of a material, or all against x
    std::vector<CrackJunction> junctions;
    double lost_to_cracks = 0;  ///< J
    std::optional<FirstFailure> first_crack;
    std::vector<PeakForce> peak_forces;

    /// J/m^2; none where no area has broken, or no thickness was recorded.
    std::optional<double> energy_per_area() const;
};

/// over: kg. Throws Error (input) when the recording is damaged, or has no frame.
Measures measures_of(const Recording& recording, double over);

/// One JSON object; its keys are described in app/README.md.
std::string measures_json(const Measures& measures);

/// The same for people to read. time_unit: RecordingHeader::time_unit.
std::string measures_text(const Measures& measures, const std::string& time_unit);

}  // namespace sherd
