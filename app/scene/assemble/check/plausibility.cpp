// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/assemble/check/plausibility.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/scene/assemble/check/crack_step_message.h"
#include "app/scene/assemble/check/reach.h"
#include "app/scene/assemble/obstacle/deforming_mesh.h"
#include "app/scene/assemble/sheet/thickness.h"
#include "core/bending/patches.h"
#include "core/shell/position_spacing.h"
#include "meshops/mesh_measures.h"

namespace sherd {
namespace {

// Limits on the ratio of a sheet's size to its thickness. The upper one is larger for foils, which include
// cloth and paper.
constexpr double most_of_plates = 2000, most_of_foils = 20000, least = 5;
constexpr double foil = 1e-3;              // m, thickness up to which a sheet is a foil
constexpr double most_short_edges = 0.05;  // share of the edges that may be shorter than the thickness
                                           // without a warning

constexpr double most_locked_faces = 0.05;  // share of the faces that may lock without a warning

constexpr double smallest_edge = 0.02;  // least edge length without a warning, as a share of the mean one
constexpr double coarsest_edge = 0.25;  // share of the sheet's size: longer edges are reported
constexpr double advised_edge = 0.03;   // share of the sheet's size: edge length to advise
/// Least number of steps in a period of the slowest vibration, whose first peak is then 39 % too low.
constexpr double steps_a_period = 10;

/// Smallest and largest credible strains at fracture. No solid fractures below a strain of 1e-6. No solid as
/// stiff as wood, or stiffer, withstands 0.2 (whiskers and fibres withstand 0.1), and no solid at all
/// withstands 10.
constexpr double weakest = 1e-6, strongest_stiff = 0.2, strongest = 10;
constexpr double stiff = 1e9;  // Pa, Young's modulus from which on a material is stiff

void warn_of_size(const SheetInput& input, const SheetSpec& sheet, std::vector<std::string>& warnings) {
    const MeshMeasures mesh = measure(input.mesh);
    const double size = (mesh.upper - mesh.lower).norm(), thickness = input.material.thickness;
    const double most = thickness > foil ? most_of_plates : most_of_foils;
    if (size >= least * thickness && size <= most * thickness) return;
    const bool large = size > thickness;
    const char* advice = "lengths are in m";
    if (std::holds_alternative<MeshFile>(sheet.mesh))
        advice =
            large ? "lengths are in m: a mesh modelled in centimetres needs scale = 0.01, one in millimetres "
                    "scale = 0.001; or say how large it is: size = 0.2"
                  : "lengths are in m: is its size or scale right?";
    warnings.push_back(fmt::format("{}: sheet.{} is {:.3g} m large and {} m thick, {}; {}", sheet.where,
                                   sheet.name, size, thickness_text(input),
                                   large ? fmt::format("{:.0f} times its thickness", size / thickness)
                                         : "hardly more than its thickness",
                                   advice));
}

/// Warns of a material in which sound is slower than in the softest gels, or faster than in diamond.
void warn_of_material(const SheetInput& input, const SheetSpec& sheet, std::vector<std::string>& warnings) {
    constexpr double slowest = 1, fastest = 25000;
    const double speed = std::sqrt(mean_young(input.material) / input.material.density);
    if (speed >= slowest && speed <= fastest) return;
    warnings.push_back(fmt::format(
        "{}: sound runs through sheet.{} at {:.2g} m/s, the root of young over density: no solid is "
        "so {}; young is in Pa (70 GPa are 70e9), density in kg/m^3 (2.4 g/cm^3 are 2400)",
        sheet.where, sheet.name, speed, speed < slowest ? "slow" : "fast"));
}

void warn_of_short_edges(const SheetInput& input, const SheetSpec& sheet,
                         std::vector<std::string>& warnings) {
    std::size_t count = 0;
    for (const Edge edge : input.mesh.edges()) {
        const Vertex a = input.mesh.vertex(edge, 0), b = input.mesh.vertex(edge, 1);
        const Vector3d along = position(input.mesh, a) - position(input.mesh, b);
        count += along.norm() < 0.5 * (input.thickness_at(a) + input.thickness_at(b));
    }
    const double share = static_cast<double>(count) / static_cast<double>(input.mesh.number_of_edges());
    const double mean = measure(input.mesh).mean_edge;
    const bool told = stretch_over_bend(thickest_material(input), mean) < least_stretch_over_bend;
    if (share <= most_short_edges || told) return;
    warnings.push_back(
        fmt::format("{}: {} of the {} edges of sheet.{} are shorter than it is thick ({} m), where the "
                    "theory of thin shells does not hold; where the sheet bends, make them longer "
                    "(edge_length, or remesh on a mesh file)",
                    sheet.where, count, input.mesh.number_of_edges(), sheet.name, thickness_text(input)));
}

void warn_of_tiny_edges(const SheetInput& input, const SheetSpec& sheet, std::vector<std::string>& warnings) {
    const MeshMeasures mesh = measure(input.mesh);
    if (mesh.smallest_edge >= smallest_edge * mesh.mean_edge) return;
    warnings.push_back(
        fmt::format("{}: the shortest edge of sheet.{}, {:.3g} m, is far below the mean, {:.3g} m: remesh",
                    sheet.where, sheet.name, mesh.smallest_edge, mesh.mean_edge));
}

/// Warns of a mesh that was modelled with as few faces as its shape needs, such as a disc of one n-gon.
void warn_of_long_edges(const SheetInput& input, const SheetSpec& sheet, std::vector<std::string>& warnings) {
    const MeshFile* file = std::get_if<MeshFile>(&sheet.mesh);
    if (!sheet.fracture || !file || file->remesh) return;
    const MeshMeasures mesh = measure(input.mesh);
    const double size = (mesh.upper - mesh.lower).norm();
    if (mesh.largest_edge <= coarsest_edge * size) return;
    warnings.push_back(
        fmt::format("{}: the longest edge of sheet.{} is {:.2g} m, in a sheet {:.2g} m large: where faces "
                    "are so large, neither "
                    "stress nor cracks mean anything; add remesh = {:g} to its mesh, or less",
                    sheet.where, sheet.name, mesh.largest_edge, size, round_step(size * advised_edge)));
}

/// Whether the longest edge and the largest angle between adjacent faces exclude locking. The test is cheap;
/// a mesh that fails it need not lock.
bool surely_free_of_locking(const SheetInput& input) {
    const Mesh& mesh = input.mesh;
    const auto normal = [&](Face face) {
        const std::array<Index, 3> corners = face_vertices(mesh, face);
        const Vector3d a = position(mesh, Vertex(corners[0]));
        return (position(mesh, Vertex(corners[1])) - a).cross(position(mesh, Vertex(corners[2])) - a).eval();
    };
    double angle = 0;
    for (const Edge edge : mesh.edges()) {
        if (mesh.is_border(edge)) continue;
        const Vector3d a = normal(mesh.face(mesh.halfedge(edge, 0))),
                       b = normal(mesh.face(mesh.halfedge(edge, 1)));
        angle = std::max(angle, std::atan2(a.cross(b).norm(), a.dot(b)));
    }
    const double edge = measure(mesh).largest_edge;
    return edge * edge * most_side_curvature(edge, angle) < locking_limit * input.thinnest();
}

void warn_of_locking(const SheetInput& input, const SheetSpec& sheet, const Scene& scene,
                     std::vector<std::string>& warnings) {
    const bool is_held = input.pinned.size() == input.mesh.number_of_vertices();
    if (scene.simulation.stepper.shell.membrane == MembraneModel::arc || is_held ||
        surely_free_of_locking(input))
        return;
    const BreakableShell alone({input});
    const VectorXd measures = locking(alone.mechanics());
    Eigen::Index worst = 0;
    const double most = measures.maxCoeff(&worst);
    const Eigen::Index count = (measures.array() > locking_limit).count();
    if (static_cast<double>(count) <= most_locked_faces * static_cast<double>(measures.size())) return;
    const auto corners = columns(alone.mechanics().rest, alone.mechanics().triangles[worst].vertices);
    const Vector3d middle = corners.rowwise().mean();
    warnings.push_back(
        fmt::format("{}: {} of the {} faces of sheet.{} have edges so long for its radius and thickness that "
                    "they resist bending by stretching: (edge)^2 / (radius thickness) is up to {:.3g}, at "
                    "({:.3g}, {:.3g}, {:.3g}) m, and should be below {:g}; use solver.membrane = \"arc\", or "
                    "edges of {:.2g} m or less",
                    sheet.where, count, measures.size(), sheet.name, most, middle.x(), middle.y(), middle.z(),
                    locking_limit, measure(input.mesh).mean_edge * std::sqrt(locking_limit / most)));
}

void warn_of_long_step(const SheetInput& input, const SheetSpec& sheet, const Scene& scene,
                       std::vector<std::string>& warnings) {
    const double period = slowest_period(input);
    if (!sheet.fracture || scene.is_static() || scene.simulation.stepper.step <= period / steps_a_period)
        return;
    warnings.push_back(
        fmt::format("{}: solver.step of {:.2g} s is long even for the slowest vibration of sheet.{}, whose "
                    "period is {:.2g} s: use "
                    "{:.2g} s or less, and compare with a run of half the step",
                    sheet.where, scene.simulation.stepper.step, sheet.name, period, period / steps_a_period));
}

/// Returns the strain at the surface at which a hinge's measure reaches `threshold`.
double strain_at(double threshold, const SheetInput& input) {
    if (input.strength.measure == Measure::stress) return threshold / mean_young(input.material);
    return threshold * input.material.thickness / 2;
}

std::string threshold_words(const SheetSpec& sheet, double threshold, double strain) {
    const bool stress = sheet.fracture->strength.measure == Measure::stress;
    return fmt::format("sheet.{} breaks at {:.3g} {}, where its surface is strained by {:.2g}", sheet.name,
                       threshold, stress ? "Pa" : "1/m", strain);
}

void warn_of_threshold(const SheetInput& input, const SheetSpec& sheet, std::vector<std::string>& warnings) {
    if (!sheet.fracture) return;
    const auto& [along, across] = std::pair(input.strength.along, input.strength.across);
    double low = std::min(along, across), high = std::max(along, across);
    if (const auto range = factor_range(input.strength.factors)) {
        // `low` and `high` become the limits over all edges: a map may contain the strengths themselves, as
        // factors of a strength of 1, and lines may be scored or unbreakable.
        high *= range->most;
        low *= range->least;
    }
    const bool stress = input.strength.measure == Measure::stress;
    if (strain_at(high, input) < weakest)
        warnings.push_back(
            fmt::format("{}: {}: no material is so weak; {}", sheet.where,
                        threshold_words(sheet, high, strain_at(high, input)),
                        stress ? "strength is in Pa: 60 MPa are 60e6"
                               : "strain is in 1/m: strain of the surface over half the thickness"));
    const double most = mean_young(input.material) >= stiff ? strongest_stiff : strongest;
    if (strain_at(low, input) > most && std::isfinite(low))
        warnings.push_back(
            fmt::format("{}: {}: no such material is so strong; {}", sheet.where,
                        threshold_words(sheet, low, strain_at(low, input)),
                        stress ? "strength is in Pa: 60 MPa are 60e6"
                               : "strain is in 1/m: strain of the surface over half the thickness"));
}

/// Returns an estimate, m/s, of the largest speed at which a sheet approaches an obstacle, a free body or
/// another sheet at the start. Motions of obstacles, and spins of bodies and other sheets, do not count.
double approach(std::size_t sheet, const Scene& scene, const std::vector<SheetInput>& inputs,
                const SimulationOptions& options) {
    const SheetInput& input = inputs[sheet];
    const MeshMeasures mesh = measure(input.mesh);
    const double spinning = input.spin.norm() * 0.5 * (mesh.upper - mesh.lower).norm();
    double fastest = options.stepper.contact.obstacles.empty() ? 0 : input.velocity.norm() + spinning;
    for (const RigidBody& body : options.stepper.contact.bodies)
        fastest = std::max(fastest, (input.velocity - body.velocity).norm() + spinning);
    for (std::size_t other = 0; other < inputs.size(); ++other)
        if (other != sheet && scene.simulation.stepper.contact.sheets)
            fastest = std::max(fastest, (input.velocity - inputs[other].velocity).norm() + spinning);
    return fastest;
}

void warn_of_long_paths(const Scene& scene, const std::vector<SheetInput>& inputs,
                        const SimulationOptions& options, std::vector<std::string>& warnings) {
    const double step = scene.simulation.stepper.step;
    for (std::size_t s = 0; s < inputs.size(); ++s) {
        const double speed = approach(s, scene, inputs, options), edge = measure(inputs[s].mesh).mean_edge;
        if (speed * step <= edge) continue;
        warnings.push_back(fmt::format(
            "{}: sheet.{} comes {:.3g} m nearer to what it hits in one solver.step of {:g} s, more than an "
            "edge ({:.3g} m): the impact is over before the rest of the sheet responds; use a step of {:g} s "
            "or less",
            scene.sheets[s].where, scene.sheets[s].name, speed * step, step, edge, round_step(edge / speed)));
    }
}

/// Warns of caches of deforming obstacles that do not match the scene's duration.
void warn_of_deforming(const Scene& scene, const SimulationOptions& options,
                       std::vector<std::string>& warnings) {
    for (std::size_t o = 0; o < scene.obstacles.size(); ++o) {
        const Obstacle& obstacle = options.stepper.contact.obstacles[o];
        if (obstacle.deformation == nullptr) continue;
        warn_of_cache(scene.obstacles[o], *obstacle.deformation, scene.duration, warnings);
    }
}

/// Warns of a sheet so far from the origin that the spacing of doubles there is a noticeable strain of its
/// edges.
void warn_of_distance(const SheetInput& input, const SheetSpec& sheet, std::vector<std::string>& warnings) {
    double farthest = 0;
    for (const Vertex v : input.mesh.vertices())
        farthest = std::max(farthest, input.starts_at(v).cwiseAbs().maxCoeff());
    const double spacing = position_spacing(farthest);
    const double edge = measure(input.mesh).mean_edge;
    if (spacing <= coarsest_spacing * edge) return;
    warnings.push_back(
        fmt::format("{}: sheet.{} is {:.3g} m from the origin, where positions are rounded to {:.1g} m, a "
                    "strain of {:.1g} in its edges of {:.3g} m: place the scene near the origin",
                    sheet.where, sheet.name, farthest, spacing, spacing / edge, edge));
}

}  // namespace

double slowest_period(const SheetInput& input) {
    const Material& m = input.material;
    const double frequency = 5.36 * std::numbers::pi / measure(input.mesh).area *
                             std::sqrt(bending_rigidity(m) / (m.density * m.thickness));
    return 2 * std::numbers::pi / frequency;
}

void warn_of_implausible(const Scene& scene, const std::vector<SheetInput>& inputs,
                         const SimulationOptions& options, std::vector<std::string>& warnings) {
    for (std::size_t s = 0; s < inputs.size(); ++s) {
        warn_of_size(inputs[s], scene.sheets[s], warnings);
        if (!scene.is_static()) warn_of_material(inputs[s], scene.sheets[s], warnings);
        warn_of_short_edges(inputs[s], scene.sheets[s], warnings);
        warn_of_tiny_edges(inputs[s], scene.sheets[s], warnings);
        warn_of_long_edges(inputs[s], scene.sheets[s], warnings);
        warn_of_distance(inputs[s], scene.sheets[s], warnings);
        warn_of_locking(inputs[s], scene.sheets[s], scene, warnings);
        warn_of_long_step(inputs[s], scene.sheets[s], scene, warnings);
        warn_of_threshold(inputs[s], scene.sheets[s], warnings);
    }
    warn_of_long_paths(scene, inputs, options, warnings);
    warn_of_deforming(scene, options, warnings);
    warn_of_unreachable(scene, inputs, options, warnings);
}

}  // namespace sherd
