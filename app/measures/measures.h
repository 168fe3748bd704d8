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

/// The edge of a run that failed first. If several failed in the same stage, the edge with the largest
/// overload.
struct FirstFailure {
    double time = 0;                       ///< s, end of the step in which the edge failed
    double load = 0;                       ///< factor of all loads; 1 except in statics
    Vector3d position = Vector3d::Zero();  ///< m, middle of the edge at rest
    double stress = 0;                     ///< Pa, surface stress at the edge
    std::vector<double> forces = {};       ///< N, magnitude on each support at the end of the step before
};

/// The largest reaction of a support or obstacle.
struct PeakForce {
    RecordedSupport support;
    double force = 0;                  ///< N, magnitude of the reaction
    double time = 0;                   ///< s, end of the step with this reaction
    std::vector<double> history = {};  ///< [steps] N, magnitude at the end of each step
};

/// Measures of a recorded run; docs/commands.md defines them. Measures without a time of their own describe
/// the last frame.
struct Measures {
    double over = 0;                          ///< kg; only fragments that are heavier count
    std::vector<MeasuredFragment> fragments;  ///< fragments heavier than `over`, the heaviest first
    std::size_t fragments_below = 0;          ///< number of the other fragments
    double mass_below = 0;                    ///< kg, total mass of the other fragments
    std::optional<PowerLaw> mass_law;         ///< law of the masses above `over`; if that is 0, above the
                                              ///< lightest
    CrackExtent cracks;
    std::optional<double> tortuosity;
    CrackDirections directions;
    bool has_axis = false;  ///< whether `directions` are relative to an axis of the material; if not, to x
    std::vector<CrackJunction> junctions;
    std::optional<CracksAbout> about;     ///< none if there is no point to count about
    double lost_to_cracks = 0;            ///< J, energy lost to cracks until the last step
    std::optional<TipSpeeds> tip_speeds;  ///< none in statics
    std::vector<EnergyExtent> energies;
    std::vector<double> times;  ///< [steps] s, ends of the steps
    std::optional<FirstFailure> first_crack;
    std::vector<PeakForce> peak_forces;

    /// Returns the energy lost per area of cracks, J/m^2; none if there are no cracks, or if no thickness is
    /// recorded.
    std::optional<double> energy_per_area() const;
};

/// A measure of a run that is a single number. Studies and their tables use its name; so does the output of
/// `sherd info --measures`, unless the measure is grouped.
struct RunMeasure {
    std::string name, unit;
    std::string meaning;
    /// Returns the measure; none if the run does not have it, for example the time of the first crack if
    /// nothing broke.
    std::function<std::optional<double>(const Measures&)> value;
    bool grouped = false;  ///< measures_json() and measures_text() have it in a group
};

/// Returns all measures that are single numbers. Peak forces of single supports and obstacles are not among
/// them.
const std::vector<RunMeasure>& all_measures();

/// Point about which radial and ring cracks are counted: `point`, if given; otherwise the place that
/// `obstacle` touched first, if it is named; otherwise the place of the first crack.
struct CrackCentre {
    std::optional<Vector3d> point = {};  ///< m, at rest
    std::string obstacle = {};           ///< name; empty: none
    std::vector<double> radii = {};      ///< m, radii of circles, as for cracks_about()
};

/// Returns the measures of a recording. over: kg, Measures::over. Throws Error (input) if the recording is
/// damaged or has no frame, or if `centre` names an obstacle that does not exist or has touched nothing.
Measures measures_of(const Recording& recording, double over, const CrackCentre& centre = {});

/// Returns a JSON object; its keys are described in docs/commands.md.
std::string measures_json(const Measures& measures);

/// Returns a text for users. time_unit: RecordingHeader::time_unit.
std::string measures_text(const Measures& measures, const std::string& time_unit);

}  // namespace sherd
