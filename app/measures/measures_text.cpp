// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <iterator>

#include "app/measures/measures.h"
#include "app/messages/counted.h"
#include "app/messages/place_text.h"
#include "app/messages/time_text.h"

namespace sherd {
namespace {

void add_fragment_rows(std::string& text, const Measures& measures) {
    constexpr std::size_t most = 20;
    auto out = std::back_inserter(text);
    fmt::format_to(out, "fragments    {} heavier than {:g} kg; {} others of {:.5g} kg together\n",
                   measures.fragments.size(), measures.over, measures.fragments_below, measures.mass_below);
    fmt::format_to(out, "  {:>6} {:>12} {:>12} {:>10} {:>10} {:>8}\n", "id", "mass kg", "area m^2",
                   "length m", "width m", "aspect");
    for (std::size_t i = 0; i < std::min(most, measures.fragments.size()); ++i) {
        const auto& [info, extent] = measures.fragments[i];
        fmt::format_to(out, "  {:>6} {:>12.5g} {:>12.5g} {:>10.4g} {:>10.4g} {:>8.3g}\n", info.id, info.mass,
                       info.area, extent.length, extent.width, extent.aspect_ratio());
    }
    if (measures.fragments.size() > most)
        fmt::format_to(out, "  and {}\n", counted(measures.fragments.size() - most, "lighter one"));
    if (const auto& law = measures.mass_law)
        fmt::format_to(
            out, "mass law     N(> m) ~ m^-{:.3f}, {:.3f} to {:.3f} with 95 % confidence, of {} fragments\n",
            law->exponent, law->interval[0], law->interval[1], law->count);
}

void add_crack_rows(std::string& text, const Measures& measures) {
    auto out = std::back_inserter(text);
    fmt::format_to(out, "cracks       {:.5g} m, {:.5g} m^2; {:.5g} J lost", measures.cracks.length,
                   measures.cracks.area, measures.lost_to_cracks);
    if (const std::optional<double> per_area = measures.energy_per_area())
        fmt::format_to(out, ", {:.4g} J/m^2", *per_area);
    if (measures.tortuosity) fmt::format_to(out, "\ntortuosity   {:.4g}", *measures.tortuosity);
    if (const CrackDirections& directions = measures.directions; directions.length > 0) {
        fmt::format_to(
            out, "\ndirection    {:.1f} degrees to {} on average, resultant {:.3f}; by 15 degrees:",
            directions.mean, measures.has_axis ? "the material's axis" : "x", directions.resultant);
        for (const double share : directions.histogram) fmt::format_to(out, " {:.0f}", 100 * share);
        text += " %";
    }
    fmt::format_to(out, "\nbranchings   {}", measures.junctions.size());
    if (const std::optional<double> angle = branching_angle(measures.junctions))
        fmt::format_to(out, "; the smallest angle of the clear ones is {:.1f} degrees on average", *angle);
    text += "\n";
    if (!measures.about) return;
    const CracksAbout& about = *measures.about;
    fmt::format_to(out, "radial       {:g} cracks about {}, median;", about.radial(),
                   place_text(about.point));
    for (const auto& [radius, cracks] : about.circles) fmt::format_to(out, " {} at {:.3g} m", cracks, radius);
    fmt::format_to(out, "\nrings        {:g} cracks about it, median of {} rays:", about.ring(),
                   about.rays.size());
    for (const auto& [angle, cracks] : about.rays) fmt::format_to(out, " {}", cracks);
    text += "\n";
}

}  // namespace

std::string measures_text(const Measures& measures, const std::string& time_unit) {
    const auto when = [&](double time) { return time_text(fmt::format("{:.6g}", time), time_unit); };
    std::string text;
    auto out = std::back_inserter(text);
    add_fragment_rows(text, measures);
    add_crack_rows(text, measures);
    if (const auto& first = measures.first_crack)
        fmt::format_to(out, "first crack  at {}, load {:.5g}, at {:.5g} {:.5g} {:.5g} m at rest\n",
                       when(first->time), first->load, first->position.x(), first->position.y(),
                       first->position.z());
    if (measures.tip_speeds && !measures.tip_speeds->steps.empty()) {
        const TipStep fastest = measures.tip_speeds->fastest();
        fmt::format_to(out, "tips         {:.5g} m/s on average, {:.5g} m/s at most at {}\n",
                       measures.tip_speeds->mean(), fastest.fastest, when(fastest.time));
    }
    for (const auto& [name, last, largest, time] : measures.energies)
        if (largest != 0)
            fmt::format_to(out, "energy       {:<17} {:>12.5g} J at the end, {:>12.5g} J at most at {}\n",
                           name, last, largest, when(time));
    for (const auto& [support, force, time, history] : measures.peak_forces)
        fmt::format_to(out, "peak force   {}: {:.5g} N at {}\n", support.name, force, when(time));
    for (const RunMeasure& measure : all_measures()) {
        if (measure.grouped) continue;
        if (const std::optional<double> value = measure.value(measures))
            fmt::format_to(out, "{:<12} {:.5g} {}: {}\n", measure.name, *value, measure.unit,
                           measure.meaning);
    }
    return text;
}

}  // namespace sherd
