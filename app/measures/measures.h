// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/measures/crack_branching.h"
#include "app/measures/crack_directions.h"
#include "app/measures/crack_extent.h"
#include "app/measures/cracks_about.h"
#include "app/measures/energy_extent.h"
#include "app/measures/fragment_extent.h"
#include "app/measures/fragment_info.h"
#include "app/measures/power_law.h"
#include "app/measures/tip_speeds.h"
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
    double stress = 0;                     ///< Pa, that the edge bore at its surface
    std::vector<double> forces = {};       ///< N, of each support at the end of the step before
};

/// The largest reaction of a support or obstacle.
struct PeakForce {
    RecordedSupport support;
    double force = 0;                  ///< N, magnitude
    double time = 0;                   ///< s, end of the step
    std::vector<double> history = {};  ///< [steps] N, magnitude
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
    std::optional<CracksAbout> about;     ///< none where there is no point to count about
    double lost_to_cracks = 0;            ///< J
    std::optional<TipSpeeds> tip_speeds;  ///< none in statics
    std::vector<EnergyExtent> energies;
    std::vector<double> times;  ///< [steps] s, at their ends
    std::optional<FirstFailure> first_crack;
    std::vector<PeakForce> peak_forces;

    /// J/m^2; none where no area has broken, or no thickness was recorded.
    std::optional<double> energy_per_area() const;
};

/// Where radial and ring cracks are counted: about a point, or the first_contact() of an obstacle, or, with
/// neither, about the first crack.
struct CrackCentre {
    std::optional<Vector3d> point = {};  ///< m, at rest
    std::string obstacle = {};
    std::vector<double> radii = {};  ///< as of cracks_about()
};

/// over: kg. Throws Error (input) when the recording is damaged, or has no frame, and what first_contact()
/// throws.
Measures measures_of(const Recording& recording, double over, const CrackCentre& centre = {});

/// One JSON object; its keys are described in app/README.md.
std::string measures_json(const Measures& measures);

/// The same for people to read. time_unit: RecordingHeader::time_unit.
std::string measures_text(const Measures& measures, const std::string& time_unit);

}  // namespace sherd
