// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/info/info.h"
#include "app/json/json.h"

namespace sherd {
namespace {

Json balance_json(const EnergyBalance& balance) {
    return {{"work_of_loads", balance.work_of_loads},
            {"work_of_wind", balance.work_of_wind},
            {"work_of_supports", balance.work_of_supports},
            {"work_of_obstacles", balance.work_of_obstacles},
            {"lost_to_friction", balance.lost_to_friction},
            {"lost_to_damping", balance.lost_to_damping},
            {"lost_to_cracks", balance.lost_to_cracks},
            {"lost_to_remeshing", balance.lost_to_remeshing},
            {"lost_to_yield", balance.lost_to_yield},
            {"lost_to_scheme", balance.lost_to_scheme},
            {"unexplained", balance.unexplained}};
}

Json gauge_json(const GaugeInfo& g) {
    Json json{{"name", g.gauge.name}, {"sheet", g.gauge.sheet}};
    if (g.gauge.displacement) {
        json["displacement"] = vector_json(g.last.displacement);
        json["largest"] = g.displacement;
    }
    if (g.gauge.fields.stress) {
        json["stress_top"] = vector_json(g.last.stress_top);
        json["stress_bottom"] = vector_json(g.last.stress_bottom);
        json["largest_stress"] = g.stress ? Json(*g.stress) : Json();
    }
    if (g.gauge.fields.curvature) {
        json["curvature"] = vector_json(g.last.curvature);
        json["largest_curvature"] = g.curvature ? Json(*g.curvature) : Json();
    }
    if (g.gauge.fields.membrane_strain) {
        json["membrane_strain"] = vector_json(g.last.membrane_strain);
        json["largest_membrane_strain"] = g.membrane_strain ? Json(*g.membrane_strain) : Json();
    }
    return json;
}

}  // namespace

std::string run_info_json(const RunInfo& info) {
    const StepReport last = info.last.value_or(StepReport{});
    Json json{{"steps", last.step},
              {"time", last.time},
              {"time_unit", info.time_unit},
              {"load", info.load.last},
              {"largest_load", info.load.largest},
              {"frames", info.frames},
              {"vertices", info.vertices},
              {"faces", info.faces},
              {"crack_events", info.failures},
              {"edges_opened", info.openings},
              {"vertices_split", info.splits},
              {"vertices_born", info.vertex_insertions},
              {"faces_born", info.face_insertions}};
    json["fragments"] = Json::array();
    for (const FragmentInfo& f : info.fragments)
        json["fragments"].push_back(
            {{"id", f.id}, {"parent", f.parent}, {"faces", f.faces}, {"area", f.area}, {"mass", f.mass}});
    json["sheets"] = Json::array();
    for (const SheetInfo& s : info.sheets)
        json["sheets"].push_back({{"name", s.name}, {"faces", s.faces}, {"area", s.area}});
    json["tips"] = tips_json(info.tips);
    json["energy"] = {{"kinetic", last.kinetic},   {"bending", last.bending}, {"membrane", last.membrane},
                      {"residual", last.residual}, {"gravity", last.gravity}, {"contact", last.contact}};
    json["balance"] = info.has_balance ? balance_json(last) : Json();
    json["momentum"] = {{"linear", vector_json(last.linear_momentum)},
                        {"angular", vector_json(last.angular_momentum)}};
    json["reactions"] = Json::array();
    for (std::size_t i = 0; i < last.reactions.size(); ++i)
        json["reactions"].push_back({{"name", info.supports[i].name},
                                     {"kind", info.supports[i].kind},
                                     {"force", vector_json(last.reactions[i].force)},
                                     {"moment", vector_json(last.reactions[i].moment)}});
    json["gauges"] = Json::array();
    for (const GaugeInfo& g : info.gauges) json["gauges"].push_back(gauge_json(g));
    json["modes"] = Json::array();
    for (const RecordedMode& mode : info.modes)
        json["modes"].push_back({{"frequency", mode.frequency}, {"growth", mode.growth}});
    json["peak_strain"] = info.peaks.peak_strain;
    json["peak_bending_strain"] = info.peaks.peak_bending_strain;
    json["peak_stress"] = info.peaks.peak_stress;
    json["peak_overload"] = info.peaks.peak_overload;
    json["peak_yield"] = info.peaks.peak_yield;
    json["capped_steps"] = info.capped_steps;
    json["limit_load"] = info.load.limit ? Json(*info.load.limit) : Json();
    json["membrane_strain"] = nullptr;
    if (const auto& largest = info.membrane_strain)
        json["membrane_strain"] = {{"strain", largest->strain}, {"face", largest->face}};
    json["largest_stress"] = json["largest_curvature"] = nullptr;
    if (const auto& stress = info.stress)
        json["largest_stress"] = {{"stress", stress->peak.value},
                                  {"face", stress->peak.face},
                                  {"surface", stress->peak.top ? "top" : "bottom"},
                                  {"time", stress->time}};
    if (const auto& curvature = info.curvature)
        json["largest_curvature"] = {
            {"curvature", curvature->peak.value}, {"face", curvature->peak.face}, {"time", curvature->time}};
    json["newton_iterations"] = info.newton_iterations;
    json["halvings"] = info.halvings;
    json["most_stages"] = info.most_stages;
    json["wall_seconds"] = info.wall_seconds;
    json["end"] = info.end;
    json["seed"] = info.seed;
    json["scene_file"] = info.scene_file;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace sherd
