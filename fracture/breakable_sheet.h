// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/shell/sheet.h"
#include "fracture/crack_mesh.h"
#include "fracture/lips.h"
#include "fracture/strength.h"

namespace sherd {

/// Pinned vertices that move together, from where they are placed.
struct MovingPin {
    std::vector<Index> vertices;
    Motion motion;
};

/// One sheet of a simulation as it starts.
struct SheetInput {
    Mesh mesh;  ///< at rest, where it starts, m
    Material material;
    std::vector<Vector3d>
        axes;  ///< [F] first material axis of each face, in its plane; may be empty when no direction differs
    Strength strength;                     ///< by default it does not break
    Vector3d velocity = Vector3d::Zero();  ///< m/s
    Vector3d spin = Vector3d::Zero();      ///< rad/s, about the centre of mass
    std::vector<Index> pinned;             ///< vertices that stay where they are, or are carried
    std::vector<MovingPin> moving_pins;    ///< of pinned vertices; none has two of them
};

/// All sheets of a simulation: their mesh and their mechanics, kept in step. A crack removes hinges and
/// duplicates vertices, and changes nothing else: rest shape, stiffness and total mass stay.
class BreakableSheet {
  public:
    /// inputs: at least one. Throws Error when a material's constants are inadmissible, when material or
    /// strength have directions and there is no axis for each face, or when the strength's factors are not as
    /// many as the edges.
    explicit BreakableSheet(const std::vector<SheetInput>& inputs);

    const CrackMesh& cracks() const { return crack_mesh; }
    const Mesh& mesh() const { return crack_mesh.mesh(); }
    const Sheet& mechanics() const { return sheet; }
    Sheet& mechanics() { return sheet; }
    std::span<const Index> face_sheet() const { return sheet.face_sheet; }  ///< [F] number of the input
    Edge edge_of_hinge(std::size_t hinge) const { return Edge(sheet.hinge_edge[hinge]); }
    /// Number of the edge's hinge in mechanics().hinges, -1 when it has none.
    Index hinge_of_edge(Edge edge) const { return sheet.edge_hinge[edge]; }
    /// What the hinge of `edge` withstands, in the unit of its sheet's measure; infinite when it cannot fail.
    double strength(Edge edge) const { return sheet.edge_strength[edge]; }
    /// By what the hinge of `edge` is judged.
    Measure measure(Edge edge) const { return measures[sheet_of(edge)]; }
    Index sheet_of(Edge edge) const;  ///< number of the input
    double crack_tip_factor(Edge edge) const { return crack_tip_factors[sheet_of(edge)]; }
    std::span<const double> face_areas() const { return sheet.face_area; }  ///< [F] at rest, m^2

    /// What a crack changed, in the mesh and in the mechanics.
    struct Change {
        CrackMesh::Change cracks;
        ShellChange shell;
    };
    /// Lets the hinges of `edges` fail, opens the mesh and carries all data over. Vertices are appended.
    Change fail(std::span<const Edge> edges);

    /// Leaves the lips of cracks that have moved apart to SheetContact. Whether there were any.
    bool release_lips();

  private:
    void add_vertices(const SheetInput& input, Index body, Index first_vertex);
    /// Tells the lips which vertices of one sheet lie at the same place from the beginning.
    void add_coincident_vertices();
    void add_triangles(const std::vector<SheetInput>& inputs, const std::vector<Vector3d>& axes);
    void add_hinges(const std::vector<SheetInput>& inputs, const std::vector<Vector3d>& axes);
    void add_strengths(const std::vector<SheetInput>& inputs);
    void add_footprints();
    void set_rigid_motion(const SheetInput& input, Index first_vertex);
    std::array<Index, 4> hinge_vertices(Edge edge) const;
    void renumber(std::span<const Face> faces);
    void share_masses(const TopologyChange& change);

    CrackMesh crack_mesh;
    Sheet sheet;
    Lips lips;
    std::vector<Measure> measures;  ///< of each input
    std::vector<double> crack_tip_factors;
};

}  // namespace sherd
