// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "core/shell/thickness.h"
#include "core/state_visitor.h"
#include "fracture/mesh/crack_mesh.h"
#include "fracture/shell/crack_faces.h"
#include "fracture/shell/mesh_inheritance.h"
#include "fracture/shell/rest_parents.h"
#include "fracture/shell/sheet_input.h"
#include "fracture/shell/start_exemptions.h"

namespace sherd {

/// All sheets of a simulation: their mesh and their mechanics, kept consistent. The failure of edges removes
/// hinges and duplicates vertices, and changes nothing else: rest shape, stiffness and total mass stay. The
/// points of the mesh are rest positions at all times.
class BreakableShell {
  public:
    /// inputs: at least one. Throws Error if a material's constants are inadmissible, if material, strength
    /// or toughness depends on the direction and a face has no axis, if the number of factors on strength or
    /// toughness differs from the number of edges, or if a thickness is missing or not positive.
    explicit BreakableShell(const std::vector<SheetInput>& inputs);

    const CrackMesh& cracks() const { return crack_mesh; }
    const Mesh& mesh() const { return crack_mesh.mesh(); }
    const Shell& mechanics() const { return shell; }
    Shell& mechanics() { return shell; }
    /// [F] number of each face's sheet among the inputs.
    std::span<const Index> face_sheet() const { return shell.face_sheet; }
    Edge edge_of_hinge(std::size_t hinge) const { return Edge(shell.hinge_edge[hinge]); }
    /// Number of the edge's hinge in mechanics().hinges; -1 if it has none.
    Index hinge_of_edge(Edge edge) const { return shell.edge_hinge[edge]; }
    /// Strength of the hinge of `edge`, in the unit of its sheet's measure; infinite if the hinge cannot
    /// fail, or must not fail yet (ArtDirection::after). If the measure is stress, the strength includes the
    /// compression of a tempered sheet's surface.
    double strength(Edge edge) const { return waits(edge) ? never : shell.edge_strength[edge]; }
    /// Whether the edge has a hinge that can fail.
    bool can_fail(Edge edge) const { return hinge_of_edge(edge) >= 0 && std::isfinite(strength(edge)); }
    /// The measure that is compared with the strength of the hinge of `edge`.
    Measure measure(Edge edge) const { return strengths[sheet_of(edge)].measure; }
    Index sheet_of(Edge edge) const;  ///< number of the edge's sheet
    bool yields() const {             ///< whether any sheet has a yield stress
        return std::ranges::any_of(materials, [](const Material& one) { return one.yield > 0; });
    }
    double yield_of_sheet(Index sheet) const { return materials[sheet].yield; }  ///< Pa, see Material::yield
    const Toughness& toughness_of_sheet(Index sheet) const { return toughnesses[sheet]; }
    /// The toughness of the sheet of a vertex.
    const Toughness& toughness_at(Index vertex) const { return toughnesses[shell.vertex_sheet[vertex]]; }
    /// The material of the sheet of a vertex or a face, with the thickness there.
    Material material_at(Index vertex) const {
        return material_of(shell.vertex_sheet[vertex], std::array{vertex});
    }
    Material material_of(Face face) const {
        return material_of(shell.face_sheet[face], shell.triangles[face].vertices);
    }
    /// Whether strength depends on the direction in which the edge is pulled open.
    bool has_directed_strength(Edge edge) const {
        const Strength& strength = strengths[sheet_of(edge)];
        return strength.along != strength.across;
    }
    /// Toughness of an edge: K_Ic in the edge's direction, with the edge's factor, and the speed limit. Other
    /// members have their default values.
    Toughness toughness(Edge edge) const {
        return {.value = shell.edge_toughness[edge], .speed_limit = toughnesses[sheet_of(edge)].speed_limit};
    }
    /// K_Ic, Pa m^0.5, of a crack that propagates from a vertex in a direction of the rest shape; infinite if
    /// no edge ahead can fail.
    double toughness_towards(Vertex from, const Vector3d& direction) const;
    const ArtDirection& art_direction(Index sheet) const { return art_directions[sheet]; }
    /// Determines the sheets that must not fail yet at `time` (s): see ArtDirection::after.
    void hold_back(double time);
    void make_unbreakable(Edge edge);  ///< makes an edge unbreakable
    double crack_tip_factor(Edge edge) const {
        const Index sheet = sheet_of(edge);
        return toughnesses[sheet].given() ? 1 : strengths[sheet].crack_tip_factor;
    }
    std::vector<double> face_areas() const;  ///< [F] m^2, at rest

    /// A change of the mesh and of the mechanics by a crack.
    struct Change {
        CrackMesh::Change cracks;
        ShellChange shell;
    };
    /// Makes the hinges of `edges` fail, opens the mesh and updates all data. New vertices are appended.
    Change fail(std::span<const Edge> edges);

    /// An edge that has been made along a ray: see AdvancedEdge.
    struct Advanced {
        AdvancedEdge::Way way;
        Halfedge halfedge;  ///< runs from the tip to the edge's other end
        Vector3d direction;
        double off_course;  ///< rad, see AdvancedEdge
        Change change;      ///< `shell` is empty if the edge existed already
    };
    /// Inserts an edge from `tip` along a ray of the rest shape, and triangulates the sheet around it again
    /// (advance_edge(), CrackMesh::advance()). The edge does not fail yet. Besides what options.kept keeps,
    /// the following stay in place: crack faces, pinned and scripted vertices, vertices that are held or
    /// guided differently from a neighbour, vertices of exempt pairs, vertices that have overlapped a
    /// collider since the start, and what lock_vertices() and lock_border() keep.
    ///
    /// The mass of each old face is distributed to its parts by area, so that mass is conserved; a vertex has
    /// a third of its faces' mass. Positions and velocities are interpolated; then the patch of new triangles
    /// gets the rigid motion that keeps its momentum (follow_in_motion()). Rest angles, stiffness and
    /// strength are computed from the new triangles. A face has the material axis of the old face of which it
    /// has the largest share, turned into its own plane. Each half of a split edge has the edge's factors on
    /// strength and toughness. An edge across old faces has the mean of the finite factors of the edges
    /// around these faces, and infinite factors if there is no finite one.
    std::optional<Advanced> advance(Vertex tip, const Vector3d& direction, const AdvanceOptions& options);
    /// Makes later calls of advance() keep these vertices at their places in the rest shape.
    void lock_vertices(std::span<const Index> vertices);
    /// Makes later calls of advance() keep the edges between these faces and other faces as lines of the
    /// mesh.
    void lock_border(std::span<const Index> faces);

    /// How the mesh lies in the unfractured mesh.
    const RestParents& rest_parents() const { return parents_at_rest; }
    std::span<const Vector3d> axes() const { return shell.face_axis; }  ///< [F] Shell::face_axis
    /// Factor on the strength of the edge: see Strength::factors.
    double strength_factor(Edge edge) const { return shell.edge_strength_factor[edge]; }

    /// Exempts faces that overlap at the start from contact until they have separated (StartExemptions).
    void exempt(std::span<const StartOverlap> overlaps);
    /// Number of vertex pairs of exempt faces.
    std::size_t exempt_pairs() const { return exemptions.count(); }
    /// Re-enables SheetContact between crack faces, and between exempt faces, that have separated. Returns
    /// whether there were any such faces.
    bool release_apart();
    void visit_state(StateVisitor& visit);

  private:
    void add_vertices(const SheetInput& input, Index sheet, Index first_vertex);
    /// Registers in `crack_faces` the vertices of one sheet that coincide at the start.
    void add_coincident_vertices();
    void add_triangles();
    void add_hinges();
    void add_strengths(const std::vector<SheetInput>& inputs);
    void add_footprints();
    void set_rigid_motion(const SheetInput& input, Index first_vertex);
    std::array<Index, 4> hinge_vertices(Edge edge) const;
    /// The material of a sheet with the mean thickness of `vertices`.
    template <std::size_t N>
    Material material_of(Index sheet, const std::array<Index, N>& vertices) const {
        Material local = materials[sheet];
        if (shell.uneven) local.thickness = mean_thickness(shell, vertices);
        return local;
    }
    TriangleStencil stencil(Face face) const;
    HingeStencil stencil(Edge edge) const;
    double hinge_axis(Edge edge) const;
    double strength_of_hinge(Edge edge) const;
    double toughness_of_hinge(Edge edge) const;
    double mass_of_faces(Vertex vertex) const;
    void renumber(std::span<const Face> faces);
    void share_masses(const TopologyChange& change);

    /// Whether a vertex is held or guided and a neighbour is not, or is held or guided differently.
    bool is_supported_alone(Vertex vertex) const;
    bool overlaps_collider(Vertex vertex) const;  ///< whether it has overlapped a collider since the start
    AdvanceOptions with_locks(const AdvanceOptions& options) const;
    ShellChange reshape(const TopologyChange& topology);
    void write_pairs();  ///< sets shell.exempt_pairs, shell.near and shell.crack_faces
    void reshape_faces(const ShellChange& change);
    void reshape_hinges(ShellChange& change);
    void add_footprints(std::span<const Index> faces, const OldSides* old, double sign);

    static constexpr double never = std::numeric_limits<double>::infinity();
    bool waits(Edge edge) const { return !waiting.empty() && waiting[sheet_of(edge)] != 0; }

    CrackMesh crack_mesh;
    Shell shell;
    RestParents parents_at_rest;
    CrackFaces crack_faces;
    StartExemptions exemptions;
    std::vector<Material> materials;     ///< [sheets]
    std::vector<Strength> strengths;     ///< [sheets], without factors
    std::vector<Toughness> toughnesses;  ///< [sheets], without factors
    std::vector<ArtDirection> art_directions;
    std::vector<char> waiting;  ///< [sheets] 1: the sheet must not fail yet; empty: all sheets may fail
};

}  // namespace sherd
