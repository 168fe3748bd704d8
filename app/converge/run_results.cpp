// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/converge/run_results.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "app/run/run_totals.h"
#include "app/run/runner.h"
#include "app/scene/assemble/sheet/supports.h"
#include "core/elements/principal_values.h"
#include "meshops/error.h"

namespace sherd {
namespace {

/// Largest readings of a gauge.
struct LargestReading {
    double displacement = 0;                    ///< m
    std::optional<double> stress = {};          ///< Pa, largest_stress(); none before the first reading
    double curvature = 0, membrane_strain = 0;  ///< 1/m and 1, principal values of largest magnitude, signed

    void add(const GaugeReading& reading) {
        displacement = std::max(displacement, reading.displacement.norm());
        stress = std::max(stress.value_or(largest_stress(reading)), largest_stress(reading));
        raise(curvature, principal_strain(reading.curvature));
        raise(membrane_strain, principal_strain(reading.membrane_strain));
    }

  private:
    static void raise(double& largest, double value) {
        if (std::abs(value) > std::abs(largest)) largest = value;
    }
};

/// Largest readings of gauges, and largest forces of supports and obstacles.
class LargestReadings : public RunObserver {
  public:
    void stepped(const StepReport& report, const CrackEvents&) override {
        gauges.resize(report.gauges.size());
        forces.resize(report.reactions.size());
        for (std::size_t i = 0; i < gauges.size(); ++i) gauges[i].add(report.gauges[i]);
        for (std::size_t i = 0; i < forces.size(); ++i)
            forces[i] = std::max(forces[i], report.reactions[i].force.norm());
    }
    std::vector<LargestReading> gauges;
    std::vector<double> forces;  ///< N
};

void add_components(std::vector<Quantity>& all, const std::string& name, const std::string& unit,
                    const Vector3d& tensor) {
    constexpr std::array components{"00", "11", "01"};
    for (std::size_t i = 0; i < components.size(); ++i)
        all.push_back(
            {fmt::format("{} {}, at the end", name, components[i]), unit, tensor[static_cast<Index>(i)]});
}

/// Adds the readings that a gauge records.
void add_gauge(std::vector<Quantity>& all, const GaugeSpec& gauge, const GaugeReading& last,
               const LargestReading& largest) {
    const std::string& name = gauge.name;
    const auto add = [&](const std::string& what, const std::string& unit, double end, double most) {
        all.push_back({name + what + ", at the end", unit, end});
        all.push_back({name + what + ", largest", unit, most});
    };
    if (gauge.displacement) add("", "m", last.displacement.norm(), largest.displacement);
    if (gauge.fields.stress) {
        add_components(all, name + ", stress top", "Pa", last.stress_top);
        add_components(all, name + ", stress bottom", "Pa", last.stress_bottom);
        add(", principal stress", "Pa", largest_stress(last), largest.stress.value_or(0));
    }
    if (gauge.fields.curvature) {
        add_components(all, name + ", curvature", "1/m", last.curvature);
        add(", principal curvature", "1/m", principal_strain(last.curvature), largest.curvature);
    }
    if (gauge.fields.membrane_strain) {
        add_components(all, name + ", membrane strain", "", last.membrane_strain);
        add(", principal membrane strain", "", principal_strain(last.membrane_strain),
            largest.membrane_strain);
    }
}

std::vector<Quantity> quantities(const Scene& scene, const RunTotals& totals,
                                 const LargestReadings& largest) {
    std::vector<Quantity> all;
    for (std::size_t i = 0; i < largest.gauges.size(); ++i)
        add_gauge(all, scene.gauges[i], totals.last.gauges[i], largest.gauges[i]);
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

RunResults results_of(const Scene& scene) {
    std::vector<std::string> warnings;
    Runner runner(scene, build_scene(scene, warnings));
    RunTotals totals;
    LargestReadings largest;
    runner.add(totals);
    runner.add(largest);
    const RunEnd end = runner.run();
    RunResults result;
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
            throw Error(fmt::format(
                "{}: the edge length of a mesh from a file can be changed only with remesh: add remesh",
                sheet.where));
        file->remesh->edge_length *= times;
    }
    return scene;
}

Scene with_steps(Scene scene, double times) {
    scene.simulation.stepper.step *= times;
    scene.frame_interval = std::max(scene.frame_interval, scene.simulation.stepper.step);
    if (scene.simulation.stepper.step > scene.duration)
        throw Error(fmt::format("a step of {:g} {} is longer than the run: divide solver.step by four",
                                scene.simulation.stepper.step, scene.time_unit()));
    return scene;
}

}  // namespace sherd
