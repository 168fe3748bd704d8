// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "app/commands.h"
#include "app/fault_picture.h"
#include "app/scene/scene_simulation.h"
#include "app/scene/scene_variant.h"
#include "app/scene/sheet_parting.h"
#include "meshops/components.h"
#include "meshops/error.h"
#include "meshops/mesh_measures.h"

namespace sherd {
namespace {

/// Period (s) of the slowest bending vibration of a free disc of the sheet's area: omega R^2 sqrt(rho h / D)
/// = 5.36 at a Poisson ratio of 0.3 (Leissa, Vibration of Plates, 1969). A curved shell vibrates faster.
double slowest_period(const Material& m, double area) {
    const double frequency =
        5.36 * std::numbers::pi / area * std::sqrt(bending_rigidity(m) / (m.density * m.thickness));
    return 2 * std::numbers::pi / frequency;
}

void add_hints(const SheetSpec& sheet, const Scene& scene, const MeshMeasures& measures,
               std::vector<std::string>& warnings) {
    if (measures.smallest_edge < measures.mean_edge / 50)
        warnings.push_back(fmt::format("the shortest edge, {:.3g} m, is far below the mean, {:.3g} m: remesh",
                                       measures.smallest_edge, measures.mean_edge));
    // 20 steps a period lose a tenth of the peak strain with implicit Euler.
    const double step = slowest_period(sheet.material, measures.area) / 20;
    if (sheet.fracture && scene.solver.step > step)
        warnings.push_back(
            fmt::format("solver.step of {:.2g} s is long for this sheet: peaks of strain come out "
                        "low; use {:.1g} s or less",
                        scene.solver.step, step));
}

void print_strength(const SheetSpec& sheet, const Strength& strength) {
    if (!sheet.fracture) {
        fmt::print("  does not break\n");
        return;
    }
    const auto words = [&](double value) {
        if (strength.measure == Measure::stress)
            return fmt::format("{:.4g} Pa of tension at its surface", value);
        return fmt::format("{:.4g} 1/m, {:.3g} of strain at its surface", value,
                           value * sheet.material.thickness / 2);
    };
    if (strength.along == strength.across)
        fmt::print("  breaks above {}\n", words(strength.along));
    else
        fmt::print("  breaks above {} along its axis, {} across\n", words(strength.along),
                   words(strength.across));
    if (strength.factors.empty()) return;
    const auto [least, most] = std::minmax_element(strength.factors.begin(), strength.factors.end());
    fmt::print("  times {:.3g} to {:.3g}, edge by edge\n", *least, *most);
}

SheetInput print_sheet(const SheetSpec& sheet, const Scene& scene) {
    std::vector<std::string> warnings;
    const SheetInput input = make_sheet(sheet, scene, warnings);
    const Mesh& mesh = input.mesh;
    const MeshMeasures m = measure(mesh);
    add_hints(sheet, scene, m, warnings);
    fmt::print("sheet {}\n", sheet.name);
    fmt::print("  vertices {}, faces {}, components {}, boundary loops {}, pinned vertices {}\n",
               mesh.number_of_vertices(), mesh.number_of_faces(), connected_components(mesh).count,
               m.boundary_loops, input.pinned.size());
    fmt::print("  area {:.6g} m^2, mass {:.6g} kg\n", m.area,
               m.area * sheet.material.thickness * sheet.material.density);
    fmt::print("  box {:.4g} {:.4g} {:.4g} to {:.4g} {:.4g} {:.4g} m\n", m.lower.x(), m.lower.y(),
               m.lower.z(), m.upper.x(), m.upper.y(), m.upper.z());
    fmt::print("  edges {:.4g} m on the mean, {:.4g} to {:.4g} m\n", m.mean_edge, m.smallest_edge,
               m.largest_edge);
    print_strength(sheet, input.strength);
    for (const std::string& warning : warnings) fmt::print("  warning: {}\n", warning);
    return input;
}

/// Throws Error with all mistakes that only the meshes show.
void check(const Scene& scene) {
    if (!scene.variant.empty()) fmt::print("variant {}\n", scene.variant);
    fmt::print("{}: {:.6g} s in {} steps of {:.3g} s, a frame every {:.3g} s\n", scene.file.string(),
               scene.duration, step_count(scene), scene.solver.step, scene.frame_interval);
    std::vector<std::string> mistakes;
    std::vector<SheetInput> inputs;
    for (const SheetSpec& sheet : scene.sheets) {
        try {
            inputs.push_back(print_sheet(sheet, scene));
        } catch (const Error& error) {
            mistakes.emplace_back(error.what());
        }
    }
    if (!mistakes.empty()) throw Error(fmt::format("{}", fmt::join(mistakes, "\n")));
    std::vector<std::string> warnings;
    part_sheets(scene, inputs, warnings);
    simulation_options(scene, inputs, warnings);  // throws where a load or a support reaches nothing
    for (const std::string& warning : warnings) fmt::print("warning: {}\n", warning);
}

struct CheckOptions {
    SceneOptions scene;
    std::filesystem::path faults;  ///< PLY file of the faces concerned; empty: none
    bool force = false;
};

int check_all(const CheckOptions& options) {
    VariantMistakes mistakes;
    const std::vector<Scene> scenes = read_scenes(options.scene);
    if (!options.faults.empty())
        for (const Scene& scene : scenes)
            require_fault_file(scene, part_file(options.faults, scene.variant), options.force);
    for (const Scene& scene : scenes) {
        try {
            check(scene);
            mistakes.add(scene.variant, "");
        } catch (const Error& error) {
            mistakes.add(scene.variant, error.what());
        }
        if (!options.faults.empty())
            write_fault_picture(scene, part_file(options.faults, scene.variant), options.force);
    }
    mistakes.throw_if_any();
    return 0;
}

}  // namespace

void add_check(CLI::App& program, Command& chosen) {
    CLI::App* command =
        program.add_subcommand("check", "Say what is wrong with a scene before hours are spent");
    auto options = std::make_shared<CheckOptions>();
    add_scene_options(*command, options->scene);
    command
        ->add_option("-o,--output", options->faults,
                     "PLY file of the sheets with the faces that keep the scene from starting coloured; of "
                     "variants NAME.ply becomes NAME-VARIANT.ply")
        ->option_text("FAULTS.ply");
    command->add_flag("--force", options->force, "Replace FAULTS.ply if it exists");
    command->footer("Example:\n  sherd check scenes/plate_drop.toml -o faults.ply");
    command->callback([&chosen, options] { chosen = [options] { return check_all(*options); }; });
}

}  // namespace sherd
