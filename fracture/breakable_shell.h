// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/shell/shell.h"
#include "fracture/art_direction.h"
#include "fracture/crack_mesh.h"
#include "fracture/lips.h"
#include "fracture/strength.h"
#include "fracture/toughness.h"

namespace sherd {

/// Pinned vertices with one scripted motion, relative to their rest positions.
struct MovingPin {
    std::vector<Index> vertices;
    Motion motion;
};

/// The input of a simulation for one sheet.
struct SheetInput {
    Mesh mesh;  ///< m, the rest shape at the place where the sheet starts
    Material material;
    std::vector<Vector3d>
        axes;  ///< [F] first material axis of each face, in its plane; may be empty if nothing depends on it
    Strength strength;                     ///< by default the sheet does not break
    Toughness toughness;                   ///< by default cracks go by the strength, too
    ArtDirection art_direction;            ///< by default it breaks whenever and into whatever it does
    Vector3d velocity = Vector3d::Zero();  ///< m/s
    Vector3d spin = Vector3d::Zero();      ///< rad/s, about the centre of mass
    std::vector<Index> pinned;             ///< vertices that are fixed or scripted
    std::vector<MovingPin> moving_pins;    ///< motions of pinned vertices, at most one for each
};

/// All sheets of a simulation: their mesh and their mechanics, kept consistent. A crack removes hinges and
/// duplicates vertices, and changes nothing else: rest shape, stiffness and total mass stay.
class BreakableShell {
  public:
    /// inputs: at least one. Throws Error if a material's constants are inadmissible, if material or strength
    /// or toughness depend on the direction and an axis is missing for a face, or if the number of their
    /// factors differs from the number of edges.
    explicit BreakableShell(const std::vector<SheetInput>& inputs);

    const CrackMesh& cracks() const { return crack_mesh; }
    const Mesh& mesh() const { return crack_mesh.mesh(); }
    const Shell& mechanics() const { return shell; }
    Shell& mechanics() { return shell; }
    std::span<const Index> face_sheet() const { return shell.face_sheet; }  ///< [F] number of the input
    Edge edge_of_hinge(std::size_t hinge) const { return Edge(shell.hinge_edge[hinge]); }
    /// Number of the edge's hinge in mechanics().hinges; -1 if it has none.
    Index hinge_of_edge(Edge edge) const { return shell.edge_hinge[edge]; }
    /// Strength of the hinge of `edge`, in the unit of its sheet's measure; infinite if it cannot fail, or
    /// not yet (ArtDirection::after).
    double strength(Edge edge) const { return waits(edge) ? never : shell.edge_strength[edge]; }
    /// The measure that the hinge of `edge` is compared by with its strength.
    Measure measure(Edge edge) const { return measures[sheet_of(edge)]; }
    Index sheet_of(Edge edge) const;  ///< number of the input
    const Toughness& toughness_of_sheet(Index sheet) const { return toughnesses[sheet]; }
    /// Whether strength depends on the direction in which the edge is pulled open.
    bool has_directed_strength(Edge edge) const { return directed[sheet_of(edge)] != 0; }
    /// Of an edge, in its direction and with its factor.
    Toughness toughness(Edge edge) const {
        return {.value = shell.edge_toughness[edge], .speed_limit = toughnesses[sheet_of(edge)].speed_limit};
    }
    const ArtDirection& art_direction(Index sheet) const { return art_directions[sheet]; }
    /// Tells what time (s) it is: see ArtDirection::after.
    void set_time(double now);
    void forbid(Edge edge) { shell.edge_strength[edge] = never; }  ///< makes an edge unbreakable
    double crack_tip_factor(Edge edge) const { return crack_tip_factors[sheet_of(edge)]; }
    std::vector<double> face_areas() const;  ///< [F] m^2, at rest

    /// What a crack changed in the mesh and in the mechanics.
    struct Change {
        CrackMesh::Change cracks;
        ShellChange shell;
    };
    /// Makes the hinges of `edges` fail, opens the mesh and updates all data. New vertices are appended.
    Change fail(std::span<const Edge> edges);

    /// Passes the lips of cracks that have moved apart on to SheetContact. Returns whether there were any.
    bool release_lips();

  private:
    void add_vertices(const SheetInput& input, Index sheet, Index first_vertex);
    /// Registers with the lips which vertices of one sheet coincide at the start.
    void add_coincident_vertices();
    void add_triangles(const std::vector<SheetInput>& inputs, const std::vector<Vector3d>& axes);
    void add_hinges(const std::vector<SheetInput>& inputs, const std::vector<Vector3d>& axes);
    void add_strengths(const std::vector<SheetInput>& inputs);
    void add_footprints();
    void set_rigid_motion(const SheetInput& input, Index first_vertex);
    std::array<Index, 4> hinge_vertices(Edge edge) const;
    void renumber(std::span<const Face> faces);
    void share_masses(const TopologyChange& change);

    static constexpr double never = std::numeric_limits<double>::infinity();
    bool waits(Edge edge) const { return some_wait && time < art_directions[sheet_of(edge)].after; }

    CrackMesh crack_mesh;
    Shell shell;
    Lips lips;
    std::vector<Measure> measures;  ///< of each input
    std::vector<double> crack_tip_factors;
    std::vector<char> directed;  ///< whether its strength has directions
    std::vector<Toughness> toughnesses;
    std::vector<ArtDirection> art_directions;
    double time = 0;         ///< s
    bool some_wait = false;  ///< whether there is a sheet that nothing of may fail yet
};

}  // namespace sherd
