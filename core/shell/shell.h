// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <vector>

#include "core/contact/crack_faces/crack_face.h"
#include "core/elements/hinge.h"
#include "core/elements/membrane.h"
#include "core/material/material.h"
#include "core/motion.h"
#include "core/shell/inheritance.h"
#include "core/state_visitor.h"

namespace sherd {

/// The vertices of a triangle and its membrane.
struct TriangleStencil {
    std::array<Index, 3> vertices;
    MembraneTriangle membrane;
};

/// The vertices of a hinge and its rest shape. Bending models keep any further data themselves.
struct HingeStencil {
    std::array<Index, 4> vertices;
    RestHinge rest;
    double stiffness;  ///< lambda, N m
};

/// The directions in which a support holds a vertex, without the directions in which an earlier support holds
/// it.
struct SupportDirections {
    Index support;        ///< number of a pin, clamp or symmetry plane
    Matrix3d directions;  ///< projection on these directions

    bool operator==(const SupportDirections&) const = default;
};

/// Two vertices whose elements repel each other only below a distance.
struct NearVertices {
    std::array<Index, 2> vertices;  ///< ascending
    double reach;                   ///< m, this distance

    auto operator<=>(const NearVertices&) const = default;
};

/// Overlap of the sheets with one collider since the start.
struct StartDepth {
    VectorXd depth;  ///< [V] m, overlap beyond which the collider exerts forces; it never grows
    /// [V] whether elements with this vertex do not meet the collider's surface.
    std::vector<char> surface_exempt;

    void visit_state(StateVisitor& visit) {
        auto& [depth, surface_exempt] = *this;
        visit(depth, surface_exempt);
    }
};

/// The mechanics of the shell (all sheets of a simulation), as arrays and index stencils. The owner of the
/// topology appends or renumbers vertices, edges and faces; nothing here refers to a mesh. Each attribute of
/// vertices, edges and faces is also listed in visit_vertices(), visit_edges() or visit_faces(), and nowhere
/// else.
struct Shell {
    Positions rest;             ///< [3, V] m
    Positions position;         ///< [3, V] m
    Positions velocity;         ///< [3, V] m/s
    VectorXd mass;              ///< [V] kg, lumped
    VectorXd thickness;         ///< [V] m
    VectorXd young;             ///< [V] Pa
    VectorXd footprint;         ///< [V] m^2, contact area of the vertex: see
                                ///< contact/penalty/vertex_contact.h
    std::vector<char> fixed;    ///< [V] 1 where a pin holds the vertex
    std::vector<Index> script;  ///< [V] 0, or the number, from 1, of the vertex's prescribed motion
    std::vector<char> guide;    ///< [V] 0, or the number, from 1, of the guide that the vertex slides along
    /// [V] 0, or the number, from 1, of the vertex's entry in `support_sets`.
    std::vector<Index> support_set;
    /// [V] number of the sheet that the vertex belongs to, also after breaking.
    std::vector<Index> vertex_sheet;
    /// [V] 1 where remeshing must not move the vertex; held vertices and vertices of cracks stay in any case.
    std::vector<char> kept;

    std::vector<TriangleStencil> triangles;  ///< [F]
    std::vector<double> face_mass;           ///< [F] kg
    std::vector<Index> face_sheet;           ///< [F] number of the sheet that the face belongs to
    /// [F] first material axis at rest, in the face's plane; zero where no property depends on the direction.
    std::vector<Vector3d> face_axis;

    std::vector<Index> edge_hinge;       ///< [E] number of the edge's hinge, -1 when it has none
    std::vector<double> edge_strength;   ///< [E] measure at which the hinge fails; infinite: never
    std::vector<double> edge_toughness;  ///< [E] Pa m^0.5, toughness along the edge; 0: none
    /// [E] factors on strength and toughness; infinite: the edge cannot fail.
    std::vector<double> edge_strength_factor, edge_toughness_factor;
    std::vector<char> edge_kept;  ///< [E] 1 where remeshing must keep the edge as a line

    std::vector<HingeStencil> hinges;  ///< [H]
    std::vector<Index> hinge_edge;     ///< [H] edge of each hinge

    /// Exempt pairs of vertices, ascending. Two elements that each contain one vertex of a pair do not
    /// collide in SheetContact, since the vertices coincide at a crack that has just opened, or faces at the
    /// vertices have crossed since the start.
    std::vector<std::array<Index, 2>> exempt_pairs;
    /// Vertex pairs of faces that have been nearer to each other since the start than other faces may come;
    /// ascending.
    std::vector<NearVertices> near;
    /// Overlaps with each obstacle, then with each free body; empty: there are none.
    std::vector<StartDepth> start_depths;
    std::vector<CrackFaceStencil> crack_faces;  ///< crack faces that have just opened
    std::vector<Matrix3d> guides;               ///< projections on the free directions: a plane, or a line
    std::vector<Motion> motions;                ///< prescribed motions of vertices, from their rest positions
    /// Sets of supports that together hold a vertex, for reactions.
    std::vector<std::vector<SupportDirections>> support_sets;
    bool uneven = false;  ///< whether the thickness of a sheet differs from place to place

    /// Supports are given at the start, and are not part of the state.
    void visit_state(StateVisitor& visit);
};

/// Calls visit(attribute) for every array, and visit(attribute, rule, missing) for every list, that has an
/// entry for each vertex. An attribute that is listed here follows every change of the mesh.
template <class S, class Visit>
void visit_vertices(S& shell, Visit visit) {
    visit(shell.rest);
    visit(shell.position);
    visit(shell.velocity);
    visit(shell.mass);
    visit(shell.thickness);
    visit(shell.young);
    visit(shell.footprint);
    visit(shell.fixed, Inheritance::common, char(0));
    visit(shell.script, Inheritance::common, Index(0));
    visit(shell.guide, Inheritance::common, char(0));
    visit(shell.support_set, Inheritance::common, Index(0));
    visit(shell.vertex_sheet, Inheritance::first, Index(0));
    visit(shell.kept, Inheritance::copies, char(0));
    for (auto& start : shell.start_depths) {
        visit(start.depth);
        visit(start.surface_exempt, Inheritance::first, char(0));
    }
}

/// Visits the attributes of edges in the same way.
template <class S, class Visit>
void visit_edges(S& shell, Visit visit) {
    visit(shell.edge_hinge, Inheritance::none, Index(-1));
    visit(shell.edge_strength, Inheritance::first, std::numeric_limits<double>::infinity());
    visit(shell.edge_toughness, Inheritance::first, 0.0);
    visit(shell.edge_strength_factor, Inheritance::around, std::numeric_limits<double>::infinity());
    visit(shell.edge_toughness_factor, Inheritance::around, std::numeric_limits<double>::infinity());
    visit(shell.edge_kept, Inheritance::copies, char(0));
}

/// Visits the attributes of faces in the same way. The code that makes the change sets their corners and
/// shape.
template <class S, class Visit>
void visit_faces(S& shell, Visit visit) {
    visit(shell.triangles, Inheritance::first, TriangleStencil());
    visit(shell.face_mass, Inheritance::none, 0.0);
    visit(shell.face_sheet, Inheritance::first, Index(0));
    visit(shell.face_axis, Inheritance::none, Vector3d(Vector3d::Zero()));
}

/// Gives the vertices' arrays `count` entries; new ones are zero.
void resize_vertices(Shell& shell, Index count);

/// Applies a change to all attributes of elements. Moved vertices get their parents' rest position, position
/// and velocity, and an uneven thickness. The code that makes the change sets masses, footprints and the
/// shape of elements that are new or changed or have lost a part, and appends hinges.
void follow(Shell& shell, const ShellChange& change);

/// Removes the hinge of an edge. The last hinge takes its number, which is returned.
Index remove_hinge_of(Shell& shell, Index edge);

/// The stencil of the hinge whose edge runs from vertices[0] to vertices[1], in the order of HingePositions.
/// stiffness: lambda, N m.
HingeStencil hinge_stencil(const Shell& shell, const std::array<Index, 4>& vertices, double stiffness);

/// Kinetic energy, J. mass: [V] kg; velocity: [3, V] m/s.
inline double kinetic_energy(const VectorXd& mass, const Positions& velocity) {
    return 0.5 * velocity.colwise().squaredNorm().dot(mass);
}
inline double kinetic_energy(const Shell& shell) {
    return kinetic_energy(shell.mass, shell.velocity);
}
/// Linear momentum, kg m/s.
Vector3d linear_momentum(const Shell& shell);
/// Angular momentum about the origin, kg m^2/s.
Vector3d angular_momentum(const Shell& shell);

}  // namespace sherd
