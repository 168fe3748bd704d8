// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/json/json.h"
#include "app/measures/measures.h"

namespace sherd {
namespace {

Json number_json(const std::optional<double>& number) {
    return number ? Json(*number) : Json();
}

Json fragment_json(const MeasuredFragment& fragment) {
    return {{"id", fragment.info.id},         {"area", fragment.info.area},
            {"mass", fragment.info.mass},     {"length", fragment.extent.length},
            {"width", fragment.extent.width}, {"aspect_ratio", fragment.extent.aspect_ratio()}};
}

Json directions_json(const Measures& measures) {
    const CrackDirections& directions = measures.directions;
    return {{"length", directions.length},
            {"axis", measures.has_axis ? "material" : "x"},
            {"histogram", directions.histogram},
            {"mean", directions.mean},
            {"resultant", directions.resultant}};
}

Json junctions_json(const std::vector<CrackJunction>& junctions) {
    Json list = Json::array();
    std::size_t clear = 0;
    for (const CrackJunction& junction : junctions) {
        clear += !junction.angles.empty();
        list.push_back({{"position", vector_json(junction.position)},
                        {"branches", junction.branches},
                        {"angles", junction.angles}});
    }
    return {{"count", junctions.size()},
            {"clear", clear},
            {"smallest_angle", number_json(branching_angle(junctions))},
            {"junctions", list}};
}

Json about_json(const std::optional<CracksAbout>& about) {
    if (!about) return {};
    Json circles = Json::array(), rays = Json::array();
    for (const auto& [radius, cracks] : about->circles)
        circles.push_back({{"radius", radius}, {"cracks", cracks}});
    for (const auto& [angle, cracks] : about->rays) rays.push_back({{"angle", angle}, {"cracks", cracks}});
    return {{"point", vector_json(about->point)},
            {"radial", about->radial()},
            {"ring", about->ring()},
            {"circles", circles},
            {"rays", rays}};
}

Json first_crack_json(const FirstFailure& first, const std::vector<PeakForce>& peaks) {
    Json forces = Json::object();
    for (std::size_t i = 0; i < first.forces.size(); ++i) forces[peaks[i].support.name] = first.forces[i];
    return {{"time", first.time},
            {"load", first.load},
            {"position", vector_json(first.position)},
            {"stress", first.stress},
            {"forces", forces}};
}

Json tip_speeds_json(const std::optional<TipSpeeds>& speeds) {
    if (!speeds) return {};
    Json steps = Json::array();
    for (const TipStep& step : speeds->steps)
        steps.push_back({{"time", step.time},
                         {"length", step.length},
                         {"tips", step.tips},
                         {"speed", step.speed},
                         {"fastest", step.fastest}});
    return {{"mean", speeds->mean()},
            {"fastest", speeds->fastest().fastest},
            {"fastest_time", speeds->fastest().time},
            {"recorded", speeds->recorded},
            {"steps", steps}};
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
    json["tortuosity"] = number_json(measures.tortuosity);
    json["directions"] = directions_json(measures);
    json["branchings"] = junctions_json(measures.junctions);
    json["about"] = about_json(measures.about);
    json["lost_to_cracks"] = measures.lost_to_cracks;
    json["energy_per_area"] = number_json(measures.energy_per_area());
    json["first_crack"] = Json();
    if (const auto& first = measures.first_crack)
        json["first_crack"] = first_crack_json(*first, measures.peak_forces);
    json["tip_speeds"] = tip_speeds_json(measures.tip_speeds);
    json["energies"] = Json::object();
    for (const auto& [name, last, largest, time] : measures.energies)
        json["energies"][name] = {{"last", last}, {"largest", largest}, {"time", time}};
    json["times"] = measures.times;
    json["peak_forces"] = Json::array();
    for (const auto& [support, force, time, history] : measures.peak_forces)
        json["peak_forces"].push_back({{"name", support.name},
                                       {"kind", support.kind},
                                       {"force", force},
                                       {"time", time},
                                       {"history", history}});
    for (const RunMeasure& measure : all_measures())
        if (!measure.grouped) json[measure.name] = number_json(measure.value(measures));
    return json.dump(2) + "\n";
}

}  // namespace sherd
