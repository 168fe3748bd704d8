// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/measures/energy_extent.h"

#include <cmath>
#include <string_view>
#include <type_traits>

#include "app/recording/recording_format.h"

namespace sherd {
namespace {

bool is_of_balance(std::string_view name) {
    return name == "unexplained" || name.starts_with("work_of_") || name.starts_with("lost_to_");
}

EnergyExtent extent_of(const std::string& name, double StepReport::*energy,
                       const std::vector<StepReport>& steps) {
    EnergyExtent extent{.name = name, .last = steps.back().*energy, .time = steps.front().time};
    for (const StepReport& step : steps)
        if (std::abs(step.*energy) > std::abs(extent.largest))
            extent.largest = step.*energy, extent.time = step.time;
    return extent;
}

}  // namespace

std::vector<EnergyExtent> energy_extents(const std::vector<StepReport>& steps, bool has_balance) {
    std::vector<EnergyExtent> extents;
    if (steps.empty()) return extents;
    recording_format::Table<StepReport>::visit(
        [&]<class Member>(const std::string& name, const hdf5::Meaning& meaning, Member member) {
            if constexpr (std::is_convertible_v<Member, double StepReport::*>)
                if (meaning.unit == std::string_view("J") && (has_balance || !is_of_balance(name)))
                    extents.push_back(extent_of(name, member, steps));
        });
    return extents;
}

}  // namespace sherd
