// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/measures/cracks/crack_branching.h"
#include "app/measures/cracks/crack_directions.h"
#include "app/measures/cracks/crack_extent.h"
#include "app/measures/cracks/cracks_about.h"
#include "app/measures/cracks/tip_speeds.h"
#include "app/measures/energy_extent.h"
#include "app/measures/fragments/fragment_extent.h"
#include "app/measures/fragments/fragment_info.h"
#include "app/measures/power_law.h"
#include "app/recording/recording.h"

namespace sherd {

struct MeasuredFragment {
    FragmentInfo info;
    FragmentExtent extent;
};

/// First failure of a run, and of several in the same stage the one with the largest overload.
struct FirstFailure {
    double time = 0;                       ///< s
    double load = 0;                       ///< factor of all loads: 1, but in statics
    Vector3d position = Vector3d::Zero();  ///< m, middle of the edge at rest
    double stress = 0;                     ///< Pa, surface stress at the edge
    std::vector<double> forces = {};       ///< N, force on each support at the end of the step before
};

/// The largest reaction of a support or obstacle.
struct PeakForce {
    RecordedSupport support;
    double force = 0;                  ///< N, magnitude
    double time = 0;                   ///< s, end of the step
    std::vector<double> history = {};  ///< [steps] N, magnitude
};

/// Measures of a recorded run; docs/commands.md defines each. They are those of the last frame, unless they
/// have a time of their own.
struct Measures {
    double over = 0;                          ///< kg, largest mass of fragments that do not count
    std::vector<MeasuredFragment> fragments;  ///< fragments heavier than `over`, the heaviest first
    std::size_t fragments_below = 0;          ///< number of the other fragments
    double mass_below = 0;                    ///< kg, of the other fragments
    std::optional<PowerLaw> mass_law;         ///< law of the masses above `over`, or above the lightest
    CrackExtent cracks;
    std::optional<double> tortuosity;
    CrackDirections directions;
    bool has_axis = false;  ///< whether directions are against an axis of the material; otherwise against x
    std::vector<CrackJunction> junctions;
    std::optional<CracksAbout> about;     ///< none without a point to count about
    double lost_to_cracks = 0;            ///< J
    std::optional<TipSpeeds> tip_speeds;  ///< none in statics
    std::vector<EnergyExtent> energies;
    std::vector<double> times;  ///< [steps] s, ends of the steps
    std::optional<FirstFailure> first_crack;
    std::vector<PeakForce> peak_forces;

    /// Energy lost per area of cracks, J/m^2; none without a broken area, or without recorded thickness.
    std::optional<double> energy_per_area() const;
};

/// A number of a run, by the name that it has in studies, their tables, and, if it is not grouped, in the
/// output of `sherd info --measures`.
struct RunMeasure {
    std::string name, unit;
    std::string meaning;
    /// None if the run has none, as the time of the first crack of a plate that did not break.
    std::function<std::optional<double>(const Measures&)> value;
    bool grouped =
        false;  ///< whether measures_json() and measures_text() have it in an object or a row of several
};

/// Returns the measures, without the peak forces of single supports and obstacles.
const std::vector<RunMeasure>& all_measures();

/// Point about which radial and ring cracks are counted: `point`, or the first_contact() of an obstacle, or,
/// with neither, the first crack.
struct CrackCentre {
    std::optional<Vector3d> point = {};  ///< m, at rest
    std::string obstacle = {};
    std::vector<double> radii = {};  ///< m, see cracks_about()
};

/// Returns the measures of a recording. over: kg. Throws Error (input) if the recording is damaged, or has no
/// frame, and what first_contact() throws.
Measures measures_of(const Recording& recording, double over, const CrackCentre& centre = {});

/// Returns a JSON object; its keys are described in docs/commands.md.
std::string measures_json(const Measures& measures);

/// Returns a text for users. time_unit: RecordingHeader::time_unit.
std::string measures_text(const Measures& measures, const std::string& time_unit);

}  // namespace sherd
