// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/assemble/sheet/sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/scene/assemble/sheet/material_axes.h"
#include "app/scene/assemble/sheet/mesh.h"
#include "app/scene/assemble/sheet/score.h"
#include "app/scene/assemble/sheet/strength_map.h"
#include "app/scene/assemble/sheet/supports.h"
#include "app/scene/assemble/sheet/thickness.h"
#include "app/scene/scene.h"
#include "fracture/shell/toughness.h"
#include "meshops/error.h"
#include "meshops/mesh.h"
#include "meshops/mesh_measures.h"

namespace sherd {
namespace {

/// Least factor on the toughness. A factor of 0 would give the toughness 0, which means that there is none,
/// and that hinges fail by their strength alone.
constexpr double least_factor = 1e-6;

/// Returns the seed of a sheet's scatter. Sheets have different seeds, which also differ from the seed of
/// generated meshes.
std::uint32_t scatter_seed(const SheetSpec& sheet, const Scene& scene) {
    const auto number = static_cast<std::uint32_t>(&sheet - scene.sheets.data());
    constexpr std::uint32_t odd = 0x9E3779B9;
    return static_cast<std::uint32_t>(scene.seed) + odd * (number + 1);
}

/// Multiplies the factors of edges [E] by the factors of the sheet's maps and scores of the strength, or of
/// the toughness. law: which of the two; factors: empty if all are 1.
void add_maps(const SheetSpec& sheet, FractureLaw law, const Mesh& placed, std::vector<double>& factors,
              std::vector<std::string>& warnings) {
    const auto factor_of = [&](Edge edge) -> double& {
        factors.resize(placed.number_of_edges(), 1);
        return factors[edge];
    };
    for (const StrengthMap& map : sheet.fracture->maps) {
        if (map.of != law) continue;
        const std::vector<double> values = map_factors(map, sheet, placed, warnings);
        for (const Edge edge : placed.edges()) {
            double& factor = factor_of(edge);
            const bool never = std::isinf(factor) || std::isinf(values[edge]);  // also infinity times zero
            factor = never ? std::numeric_limits<double>::infinity() : factor * values[edge];
        }
    }
    for (const Score& score : sheet.fracture->scores)
        if (score.of == law)
            for (const Edge edge : scored_edges(score, placed, sheet.place)) factor_of(edge) *= score.factor;
}

/// Returns the strength of a sheet that can fail. The factor of each edge of `placed` is the product of the
/// factors of the scatter (with the scene's seed), of the maps and of the scored lines for the strength; it
/// is infinite if the edge never fails. Throws Error naming the scene's line and key; warnings are sentences.
Strength sheet_strength(const SheetSpec& sheet, const Scene& scene, const Mesh& placed,
                        std::vector<std::string>& warnings) {
    const FractureSpec& fracture = *sheet.fracture;
    Strength strength = fracture.strength;
    if (fracture.weibull_modulus > 0)
        strength.factors = weibull_factors(placed, {.modulus = fracture.weibull_modulus,
                                                    .area = fracture.weibull_area,
                                                    .seed = scatter_seed(sheet, scene)});
    add_maps(sheet, FractureLaw::strength, placed, strength.factors, warnings);
    return strength;
}

/// Returns the toughness of a sheet that can fail, with the factors that maps and scored lines for the
/// toughness give its edges, and with the given speed limit or, by default, usual_speed_limit(). Throws Error
/// like sheet_strength().
Toughness sheet_toughness(const SheetSpec& sheet, const Mesh& placed, std::vector<std::string>& warnings) {
    const FractureSpec& fracture = *sheet.fracture;
    Toughness toughness;
    toughness.value = fracture.fracture_energy > 0
                          ? toughness_of_energy(fracture.fracture_energy, sheet.material)
                          : fracture.toughness;
    toughness.across = fracture.toughness_across;
    toughness.path = fracture.path;
    toughness.speed_limit =
        fracture.speed_limit > 0 ? fracture.speed_limit : usual_speed_limit(sheet.material);
    add_maps(sheet, FractureLaw::toughness, placed, toughness.factors, warnings);
    for (double& factor : toughness.factors) factor = std::max(factor, least_factor);
    return toughness;
}

constexpr double flat = 1e-6;  // tolerance, as a share of the mesh's diagonal: accuracy of single-precision
                               // files

Vector3d normal_of_flat(const Mesh& mesh, const BendSpec& bend) {
    const MeshMeasures extent = measure(mesh);
    Vector3d normal = triangle_normal(face_points(mesh, Face(0))).normalized();
    const Vector3d on = position(mesh, Vertex(0));
    for (const Vertex v : mesh.vertices())
        if (std::abs(normal.dot(position(mesh, v) - on)) > flat * (extent.upper - extent.lower).norm())
            throw Error(fmt::format("{}: needs a sheet that is flat at rest", bend.where));
    return normal;
}

/// Returns the start positions, [3, V] m, of a sheet that is flat at rest and is rolled to a cylinder: lines
/// along bend.along become arcs of the same length. Throws Error naming the scene's line and key if the mesh
/// is not flat, or bend.along is normal to it.
Positions bent_start(const BendSpec& bend, const Mesh& placed, const Eigen::Isometry3d& place) {
    const Vector3d normal = normal_of_flat(placed, bend), from = place * bend.from;
    Vector3d along = place.linear() * bend.along;
    along -= normal.dot(along) * normal;
    if (along.norm() < flat)
        throw Error(fmt::format("{}.along: must not be the sheet's normal: give a direction in its plane",
                                bend.where));
    along.normalize();
    Positions start(3, static_cast<Index>(placed.number_of_vertices()));
    for (const Vertex v : placed.vertices()) {
        const Vector3d p = position(placed, v);
        const double length = along.dot(p - from), half = 0.5 * bend.curvature * length;
        // The chord of the arc makes half the arc's angle with the tangent.
        const double chord = half == 0 ? length : length * std::sin(half) / half;
        start.col(static_cast<Index>(v)) =
            p + (chord * std::cos(half) - length) * along + chord * std::sin(half) * normal;
    }
    return start;
}

/// Warns if the edges are so short for the thickness that the hinges are beyond their limit of validity
/// (paper, section 8).
void warn_of_stretching(const SheetInput& input, const SheetSpec& sheet, std::vector<std::string>& warnings) {
    const Material material = thickest_material(input);
    const double edge = measure(input.mesh).mean_edge, ratio = stretch_over_bend(material, edge);
    if (ratio >= least_stretch_over_bend) return;
    warnings.push_back(
        fmt::format("{}: stretching stiffness Y t is {:.3g} times the hinges' bending stiffness lambda / L^2 "
                    "(edges of L = {:.3g} m, thickness t = {:.3g} m); thin-shell bending needs {:.0f}: where "
                    "the sheet bends, make the edges {:.2g} m or longer",
                    sheet.where, ratio, edge, material.thickness, least_stretch_over_bend,
                    edge * std::sqrt(least_stretch_over_bend / ratio)));
}

/// Whether the sheet's material, strength or toughness depend on the material axis.
bool has_directions(const SheetSpec& sheet) {
    if (!is_isotropic(sheet.material)) return true;
    return sheet.fracture && (sheet.fracture->strength.along != sheet.fracture->strength.across ||
                              sheet.fracture->toughness_across);
}

}  // namespace

SheetInput make_sheet(const SheetSpec& sheet, const Scene& scene, std::vector<std::string>& warnings,
                      std::string* remeshed) {
    SheetInput input;
    input.mesh = make_mesh(sheet, scene, warnings, remeshed);
    if (sheet.bend) input.start = bent_start(*sheet.bend, input.mesh, sheet.place);
    input.pinned = pinned_vertices(sheet, input.mesh);
    input.moving_pins = moving_pins(sheet, input.mesh);
    input.material = sheet.material;
    set_thickness(sheet, input, warnings);
    std::vector<std::string> axis_warnings;
    std::vector<Vector3d> axes = material_axes(sheet.axis, input.mesh, sheet.place, axis_warnings);
    if (has_directions(sheet)) {
        input.axes = std::move(axes);
        warnings.insert(warnings.end(), axis_warnings.begin(), axis_warnings.end());
    }
    warn_of_stretching(input, sheet, warnings);
    if (sheet.fracture) {
        input.strength = sheet_strength(sheet, scene, input.mesh, warnings);
        input.toughness = sheet_toughness(sheet, input.mesh, warnings);
        input.art_direction = sheet.fracture->art_direction;
    }
    input.velocity = sheet.velocity;
    input.spin = sheet.spin;
    return input;
}

}  // namespace sherd
