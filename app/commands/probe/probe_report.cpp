// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>

#include "app/commands/commands.h"
#include "app/commands/probe/probe.h"
#include "app/files/disk/pending_file.h"
#include "app/json/json.h"
#include "app/messages/counted.h"
#include "app/messages/print.h"
#include "app/recording/hdf5_file.h"
#include "app/recording/recording_format.h"

namespace sherd {
namespace {

/// Index of the first element with the largest magnitude of strain; none without elements.
template <class Element>
std::optional<std::size_t> most_strained(const std::vector<Element>& elements) {
    const auto less = [](const Element& a, const Element& b) {
        return std::abs(a.strain) < std::abs(b.strain);
    };
    const auto most = std::max_element(elements.begin(), elements.end(), less);
    if (most == elements.end()) return std::nullopt;
    return most - elements.begin();
}

Json hinge_json(const Probe& probe) {
    const auto number = most_strained(probe.hinges);
    if (!number) return nullptr;
    const ProbedHinge& hinge = probe.hinges[*number];
    return {{"strain", hinge.strain},
            {"hinge", *number},
            {"vertices", hinge.vertices},
            {"angle", hinge.angle},
            {"rest_angle", hinge.rest_angle}};
}

Json face_json(const Probe& probe) {
    const std::size_t number = most_strained(probe.faces).value();
    return {
        {"strain", probe.faces[number].strain}, {"face", number}, {"vertices", probe.faces[number].vertices}};
}

Json peak_json(const Probe& probe, const char* name, const FieldPeak& peak) {
    return {{name, peak.value}, {"face", peak.face}, {"vertices", probe.faces[peak.face].vertices}};
}

void write_fields(hid_t file, const Probe& probe) {
    std::vector<std::array<Index, 3>> vertices;
    for (const ProbedFace& face : probe.faces) vertices.push_back(face.vertices);
    hdf5::write<std::array<Index, 3>>(file, "face/vertices", vertices, {"1", "of the file"});
    recording_format::visit_field_arrays(probe.fields, [&](const std::string& name, hdf5::Meaning meaning,
                                                           const Eigen::Matrix3Xd& values, bool) {
        hdf5::create_array(file, name, H5T_NATIVE_DOUBLE, values.cols(), 3, values.data(), meaning);
    });
}

template <class T>
void write_hinges(hid_t file, const std::string& name, const Probe& probe, T ProbedHinge::*member,
                  const hdf5::Meaning& meaning) {
    std::vector<T> values;
    for (const ProbedHinge& hinge : probe.hinges) values.push_back(hinge.*member);
    hdf5::write<T>(file, "hinge/" + name, values, meaning);
}

void write_datasets(hid_t file, const Probe& probe) {
    hdf5::write_attribute(file, "format", std::string("sherd probe"));
    hdf5::write_attribute(file, "format_version", std::int64_t{1});
    hdf5::write_attribute(file, "sherd_version", std::string(SHERD_VERSION));
    for (const ProbedEnergy& energy : probe.energies)
        hdf5::create_array(file, "force/" + energy.name, H5T_NATIVE_DOUBLE, energy.force.cols(), 3,
                           energy.force.data(), {"N", "of each vertex of the file"});
    write_hinges(file, "vertices", probe, &ProbedHinge::vertices,
                 {"1", "the edge's two, then the apexes of its left and its right triangle"});
    write_hinges(file, "angle", probe, &ProbedHinge::angle, {"rad", "of the deformed shape"});
    write_hinges(file, "rest_angle", probe, &ProbedHinge::rest_angle, {"rad"});
    write_hinges(file, "strain", probe, &ProbedHinge::strain, {"1/m", "bending strain, signed"});
    write_hinges(file, "stiffness", probe, &ProbedHinge::stiffness, {"N m", "lambda"});
    write_fields(file, probe);
}

struct ProbeOptions {
    std::filesystem::path rest, deformed, material, output;
    bool json = false, force = false;
};

int run_probe(const ProbeOptions& options) {
    if (!options.output.empty())
        check_free(options.output, options.force, {options.rest, options.deformed, options.material});
    const MaterialFile material = read_material_file(options.material);
    std::vector<std::string> warnings;
    const ProbeShapes shapes = read_probe_shapes(options.rest, options.deformed, warnings);
    const Probe result = probe(shapes, material, warnings);
    print_warnings(warnings);
    if (!options.output.empty()) write_probe(result, options.output, options.force);
    print_result("{}", options.json ? probe_json(result) : probe_text(result));
    return 0;
}

}  // namespace

std::string probe_json(const Probe& probe) {
    Json json{{"vertices", probe.energies.front().force.cols()},
              {"faces", probe.faces.size()},
              {"hinges", probe.hinges.size()}};
    for (const ProbedEnergy& energy : probe.energies) json["energy"][energy.name] = energy.energy;
    for (const ProbedEnergy& energy : probe.energies) json["force_norm"][energy.name] = energy.force.norm();
    json["largest_strain"] = {{"bending", hinge_json(probe)}, {"membrane", face_json(probe)}};
    const FieldPeak stress = stress_peak(probe.fields);
    json["largest_stress"] = peak_json(probe, "stress", stress);
    json["largest_stress"]["surface"] = stress.top ? "top" : "bottom";
    json["largest_curvature"] = peak_json(probe, "curvature", curvature_peak(probe.fields));
    return json.dump(2) + "\n";
}

std::string probe_text(const Probe& probe) {
    std::string text;
    auto out = std::back_inserter(text);
    fmt::format_to(out, "mesh                {}, {}, {}\n",
                   counted(probe.energies.front().force.cols(), "vertex", "vertices"),
                   counted(probe.faces.size(), "face"), counted(probe.hinges.size(), "hinge"));
    fmt::format_to(out, "{:<20}{:>14} {:>14}\n", "", "energy J", "force norm N");
    for (const ProbedEnergy& energy : probe.energies)
        fmt::format_to(out, "{:<20}{:>14.8g} {:>14.8g}\n", energy.name, energy.energy, energy.force.norm());
    if (const auto hinge = most_strained(probe.hinges)) {
        const ProbedHinge& most = probe.hinges[*hinge];
        fmt::format_to(out,
                       "bending strain      at most {:.6g} 1/m: hinge {}, vertices {}, angle {:.6g} rad, "
                       "{:.6g} at rest\n",
                       most.strain, *hinge, fmt::join(most.vertices, " "), most.angle, most.rest_angle);
    }
    const std::size_t face = most_strained(probe.faces).value();
    fmt::format_to(out, "membrane strain     at most {:.6g}: face {}, vertices {}\n",
                   probe.faces[face].strain, face, fmt::join(probe.faces[face].vertices, " "));
    const FieldPeak stress = stress_peak(probe.fields), curvature = curvature_peak(probe.fields);
    fmt::format_to(out, "stress              at most {:.6g} Pa: face {}, vertices {}, at the {}\n",
                   stress.value, stress.face, fmt::join(probe.faces[stress.face].vertices, " "),
                   stress.top ? "top" : "bottom");
    fmt::format_to(out, "curvature           changed by {:.6g} 1/m at most: face {}, vertices {}\n",
                   curvature.value, curvature.face, fmt::join(probe.faces[curvature.face].vertices, " "));
    return text;
}

void write_probe(const Probe& probe, const std::filesystem::path& file, bool force) {
    const OutputLock lock(file);
    check_free(file, force);
    PendingFile pending(lock, Fault::input);
    hdf5::write_new(pending, [&probe](hid_t created) { write_datasets(created, probe); });
    pending.publish(force);
}

void add_probe(CLI::App& program, Command& chosen) {
    CLI::App* command =
        program.add_subcommand("probe", "Evaluate energies, forces and strains of a deformed mesh");
    auto options = std::make_shared<ProbeOptions>();
    command->add_option("rest", options->rest, "Mesh at rest (.obj, .ply, .off, .stl)")
        ->required()
        ->option_text("REST");
    command->add_option("deformed", options->deformed, "Mesh of the same faces, deformed")
        ->required()
        ->option_text("DEFORMED");
    command
        ->add_option("--material", options->material,
                     "TOML file with the keys of [material], and bending_stiffness")
        ->required()
        ->option_text("M.toml");
    command->add_flag("--json", options->json, "For scripts: one JSON object");
    command->add_option("-o,--output", options->output, "File for forces and hinges (.h5)")
        ->option_text("OUT.h5");
    command->add_flag("--force", options->force, "Replace an output file that exists");
    command->footer("Example:\n  sherd probe rest.obj deformed.obj --material steel.toml -o probe.h5");
    command->callback([&chosen, options] { chosen = [options] { return run_probe(*options); }; });
}

}  // namespace sherd
