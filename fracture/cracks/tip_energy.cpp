// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/cracks/tip_energy.h"

#include <Eigen/Geometry>
#include <cmath>

#include "core/tips/crack_direction.h"
#include "core/tips/stress_intensity.h"

namespace sherd {
namespace {

constexpr int rings_for_plate = 2;  // with fewer rings around the tip, k_1 and k_2 are meaningless
/// Number of vertex pairs along which a crack is followed from its tip: more than the tip has rings.
constexpr int followed = 8;
/// Cosine of the largest angle between path and last edge at which the edge counts as lying on the path.
constexpr double straight = 0.996;
/// If the energy of the computed modes and the energy released differ by more than this factor, the modes do
/// not describe the tip.
constexpr double most_of_modes = 1.5;

/// Pairs of opposite vertices on the two faces of the crack that ends at a tip, in order from the tip, as
/// long as the two vertices of a pair are copies of one vertex.
std::vector<std::array<Vertex, 2>> crack_faces_of(const BreakableShell& shell, Vertex tip) {
    const Mesh& mesh = shell.mesh();
    Halfedge to_tip;  // border halfedge between the crack faces
    for (const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(tip)))
        if (mesh.is_border(h)) to_tip = h;
    std::vector<std::array<Vertex, 2>> crack_faces;
    Halfedge before = to_tip, after = mesh.next(to_tip);
    while (static_cast<int>(crack_faces.size()) < followed) {
        const Vertex a = mesh.source(before), b = mesh.target(after);
        if (a == b || shell.cracks().original(a) != shell.cracks().original(b)) break;
        crack_faces.push_back({a, b});
        before = mesh.prev(before);
        after = mesh.next(after);
    }
    return crack_faces;
}

/// Ratio of the squared largest hoop stress of the modes to K_I^2 + K_II^2, to which the release by straight
/// propagation is proportional; at least 1.
double gain_by_turning(const ModePair& modes) {
    const double straight = modes.first * modes.first + modes.second * modes.second;
    if (!(straight > 0) || !(modes.first > 0)) return 1;
    const double half = 0.5 * hoop_angle(modes), c = std::cos(half);
    const double hoop = c * (modes.first * c * c - 1.5 * modes.second * std::sin(2 * half));
    return std::max(1.0, hoop * hoop / straight);
}

/// Whether a sheet is torn out of its plane, so that the largest hoop stress does not give a crack's
/// direction. Then either the sheet folds within the rings, so that the modes do not account for the energy
/// released by straight propagation, `energy` (J/m^2), or the mode k_2, shear across the sheet's plane,
/// dominates.
bool is_torn(const PlaneStress& material, const TipLoad& load, double energy) {
    const double modes = membrane_release(material, load.membrane) + plate_release(material, load.plate);
    return modes * most_of_modes < energy || modes > energy * most_of_modes ||
           plate_release(material, {0, load.plate.second}) > 0.5 * modes;
}

}  // namespace

void TipEnergy::mesh_changed(std::span<const GrowingTip> tips) {
    all.clear();
    around.emplace(shell.mechanics());
    const Mesh& mesh = shell.mesh();
    foreign.assign(mesh.number_of_vertices(), 0);
    for (const Halfedge h : mesh.halfedges())
        if (mesh.is_border(h)) foreign[mesh.target(h)] = 1;
    for (const GrowingTip& tip : tips) foreign[tip.vertex] = 1;
}

std::vector<char> TipEnergy::foreign_to(Index vertex) const {
    std::vector<char> others = foreign;
    std::vector<std::array<Vertex, 2>> crack_faces = crack_faces_of(shell, Vertex(vertex));
    // If there are fewer pairs, the last pair is another tip, or the crack's mouth on the outer boundary.
    if (static_cast<int>(crack_faces.size()) < followed && !crack_faces.empty()) crack_faces.pop_back();
    for (const auto& [a, b] : crack_faces) others[a] = others[b] = 0;
    others[vertex] = 0;
    return others;
}

TipEnergy::CachedTip* TipEnergy::cached_at(const GrowingTip& tip, const Equilibrium& state) {
    const auto [place, is_new] = all.try_emplace(tip.vertex);
    if (!is_new) return place->second.get();
    const Mesh& mesh = shell.mesh();
    int sides = 0;
    for (const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(Vertex(tip.vertex))))
        sides += mesh.is_border(mesh.edge(h)) ? 1 : 0;
    if (sides != 2) return nullptr;
    const CrackTip found = crack_tip(shell.mechanics(), *around, tip.vertex, foreign_to(tip.vertex));
    place->second = std::make_unique<CachedTip>(
        CachedTip{found, TipForce(shell.mechanics(), *around, {.bending = state.bending}, found)});
    return place->second.get();
}

bool TipEnergy::add_modes(const CachedTip& cached, const Equilibrium& state, double straight_on,
                          TipLoad& load) const {
    const Shell& mechanics = shell.mechanics();
    const std::optional<PlaneStress> material = isotropic_at(mechanics, (*around)[cached.tip.vertex].front());
    if (!material) return true;
    load.membrane = membrane_intensity(mechanics, *around, cached.tip, state.x);
    if (state.bending != nullptr && static_cast<int>(cached.tip.rings.size()) > rings_for_plate)
        load.plate = plate_intensity(mechanics, *around, *state.bending, cached.tip, state.x);
    if (is_torn(*material, load, straight_on / mechanics.thickness[cached.tip.vertex])) return false;
    const double turn = hoop_direction(*material, load.membrane, load.plate).angle;
    load.direction = Eigen::AngleAxisd(turn, cached.tip.normal) * cached.tip.direction;
    return true;
}

std::optional<TipLoad> TipEnergy::load(const GrowingTip& tip, const Equilibrium& state) {
    if (membrane != MembraneModel::constant_strain) return std::nullopt;
    const CachedTip* cached = cached_at(tip, state);
    if (cached == nullptr) return std::nullopt;
    const ConfigurationalForce force = cached->force.at(
        state.x, {.spread = state.elastic - state.on_crack_faces, .on_crack_faces = state.on_crack_faces});
    const Vector2d along = force.corrected();
    TipLoad load;
    load.direction = cached->tip.direction;
    load.by_energy = true;
    const bool has_modes = add_modes(*cached, state, along[0], load);
    const bool is_straight = cached->tip.direction.dot(tip.direction) > straight;
    double released = is_straight ? along[0] : along.norm();
    if (has_modes && is_straight) released += (gain_by_turning(load.membrane) - 1) * force.membrane[0];
    if (!has_modes && along[0] > 0) {
        released = along.norm();
        load.direction =
            Eigen::AngleAxisd(std::atan2(along[1], along[0]), cached->tip.normal) * cached->tip.direction;
    }
    load.intensity = std::sqrt(std::max(0.0, released) * shell.mechanics().young[tip.vertex] /
                               shell.mechanics().thickness[tip.vertex]);
    return load;
}

}  // namespace sherd
