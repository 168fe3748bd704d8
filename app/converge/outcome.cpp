// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/converge/outcome.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app/run/run_totals.h"
#include "app/run/runner.h"
#include "app/scene/build/supports.h"
#include "meshops/error.h"

namespace sherd {
namespace {

/// The largest magnitudes of what gauges and supports show.
class LargestReadings : public RunObserver {
  public:
    void stepped(const StepReport& report, const CrackEvents&) override {
        displacements.resize(report.gauges.size());
        forces.resize(report.reactions.size());
        for (std::size_t i = 0; i < displacements.size(); ++i)
            displacements[i] = std::max(displacements[i], report.gauges[i].displacement.norm());
        for (std::size_t i = 0; i < forces.size(); ++i)
            forces[i] = std::max(forces[i], report.reactions[i].force.norm());
    }
    std::vector<double> displacements, forces;  ///< m; N
};

std::vector<Quantity> quantities(const Scene& scene, const RunTotals& totals,
                                 const LargestReadings& largest) {
    std::vector<Quantity> all;
    for (std::size_t i = 0; i < largest.displacements.size(); ++i) {
        const std::string& name = scene.gauges[i].name;
        all.push_back({name + ", at the end", "m", totals.last.gauges[i].displacement.norm()});
        all.push_back({name + ", largest", "m", largest.displacements[i]});
    }
    const auto supports = support_names(scene);
    for (std::size_t i = 0; i < largest.forces.size(); ++i)
        all.push_back({"force on " + supports[i].name, "N", largest.forces[i]});
    all.push_back({"elastic energy", "J", totals.last.bending + totals.last.membrane});
    all.push_back({"peak strain", "1/m", totals.peaks.peak_strain});
    all.push_back({"peak stress", "Pa", totals.peaks.peak_stress});
    if (scene.is_static()) all.push_back({"largest load", "", totals.load.largest});
    if (totals.load.limit) all.push_back({"limit load", "", *totals.load.limit});
    return all;
}

}  // namespace

Outcome outcome(const Scene& scene) {
    std::vector<std::string> warnings;
    Runner runner(scene, build_scene(scene, warnings));
    RunTotals totals;
    LargestReadings largest;
    runner.add(totals);
    runner.add(largest);
    const RunEnd end = runner.run();
    Outcome result;
    result.faces = runner.simulation().shell().mechanics().triangles.size();
    result.steps = totals.last.step;
    result.cracks = static_cast<std::int64_t>(totals.cracks);
    result.seconds = end.wall_seconds;
    result.quantities = quantities(scene, totals, largest);
    return result;
}

Scene with_edges(Scene scene, double times) {
    for (SheetSpec& sheet : scene.sheets) {
        if (auto* generated = std::get_if<GeneratedMesh>(&sheet.mesh)) {
            generated->edge_length *= times;
            continue;
        }
        auto* file = std::get_if<MeshFile>(&sheet.mesh);
        if (file == nullptr || !file->remesh)
            throw Error(
                fmt::format("{}: a mesh from a file has no other edges: give it a remesh", sheet.where));
        file->remesh->edge_length *= times;
    }
    return scene;
}

Scene with_steps(Scene scene, double times) {
    scene.solver.step *= times;
    scene.frame_interval = std::max(scene.frame_interval, scene.solver.step);
    if (scene.solver.step > scene.duration)
        throw Error(fmt::format("a step of {:g} {} is longer than the run: give solver.step a quarter of it",
                                scene.solver.step, scene.time_unit()));
    return scene;
}

}  // namespace sherd
