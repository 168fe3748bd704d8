// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <iterator>

#include "app/json/json.h"
#include "app/measures/measures.h"
#include "app/words/moment_words.h"

namespace sherd {
namespace {

Json fragment_json(const MeasuredFragment& fragment) {
    return {{"id", fragment.info.id},         {"area", fragment.info.area},
            {"mass", fragment.info.mass},     {"length", fragment.extent.length},
            {"width", fragment.extent.width}, {"aspect_ratio", fragment.extent.aspect_ratio()}};
}

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
        fmt::format_to(out, "  and {} lighter ones\n", measures.fragments.size() - most);
    if (const auto& law = measures.mass_law)
        fmt::format_to(out,
                       "mass law     N(> m) ~ m^-{:.3f}, {:.3f} to {:.3f} in 95 of 100, of {} fragments\n",
                       law->exponent, law->interval[0], law->interval[1], law->count);
}

}  // namespace

std::string measures_json(const Measures& measures) {
    Json json{{"over", measures.over}, {"fragments", Json::array()}};
    for (const MeasuredFragment& fragment : measures.fragments)
        json["fragments"].push_back(fragment_json(fragment));
    json["fragments_below"] = measures.fragments_below;
    json["mass_below"] = measures.mass_below;
    json["mass_law"] = Json();
    if (const auto& law = measures.mass_law)
        json["mass_law"] = {{"exponent", law->exponent}, {"interval", law->interval}, {"count", law->count}};
    json["crack_length"] = measures.cracks.length;
    json["crack_area"] = measures.cracks.area;
    json["lost_to_cracks"] = measures.lost_to_cracks;
    const std::optional<double> per_area = measures.energy_per_area();
    json["energy_per_area"] = per_area ? Json(*per_area) : Json();
    json["first_crack"] = Json();
    if (const auto& first = measures.first_crack)
        json["first_crack"] = {
            {"time", first->time}, {"load", first->load}, {"position", vector_json(first->position)}};
    json["peak_forces"] = Json::array();
    for (const auto& [support, force, time] : measures.peak_forces)
        json["peak_forces"].push_back(
            {{"name", support.name}, {"kind", support.kind}, {"force", force}, {"time", time}});
    return json.dump(2) + "\n";
}

std::string measures_text(const Measures& measures, const std::string& time_unit) {
    const auto when = [&](double time) { return moment_words(fmt::format("{:.6g}", time), time_unit); };
    std::string text;
    auto out = std::back_inserter(text);
    add_fragment_rows(text, measures);
    fmt::format_to(out, "cracks       {:.5g} m, {:.5g} m^2; {:.5g} J lost", measures.cracks.length,
                   measures.cracks.area, measures.lost_to_cracks);
    if (const std::optional<double> per_area = measures.energy_per_area())
        fmt::format_to(out, ", {:.4g} J/m^2", *per_area);
    text += "\n";
    if (const auto& first = measures.first_crack)
        fmt::format_to(out, "first crack  at {}, load {:.5g}, at {:.5g} {:.5g} {:.5g} m at rest\n",
                       when(first->time), first->load, first->position.x(), first->position.y(),
                       first->position.z());
    for (const auto& [support, force, time] : measures.peak_forces)
        fmt::format_to(out, "peak force   {}: {:.5g} N at {}\n", support.name, force, when(time));
    return text;
}

}  // namespace sherd
