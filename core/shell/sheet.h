// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/contact/lips/lip.h"
#include "core/elements/hinge.h"
#include "core/elements/membrane.h"
#include "core/material/material.h"
#include "core/motion.h"

namespace sherd {

/// The vertices of a triangle and its membrane.
struct TriangleStencil {
    std::array<Index, 3> vertices;
    MembraneTriangle membrane;
};

/// The vertices of a hinge and its rest shape; what the bending models need beside these is theirs.
struct HingeStencil {
    std::array<Index, 4> vertices;
    RestHinge rest;
    double stiffness;  ///< lambda, N m
};

/// The mechanics of all sheets of a simulation, as arrays and index stencils. Vertices and triangles are only
/// ever appended or renumbered by whoever holds the topology; nothing here knows of a mesh.
struct Sheet {
    Positions rest;           ///< [3, V] m
    Positions position;       ///< [3, V] m
    Positions velocity;       ///< [3, V] m/s
    VectorXd mass;            ///< [V] kg, lumped
    VectorXd thickness;       ///< [V] m
    VectorXd young;           ///< [V] Pa
    VectorXd footprint;       ///< [V] m^2, area by which the vertex touches an obstacle: see
                              ///< contact/penalty/obstacle_contact.h
    std::vector<char> fixed;  ///< [V] 1 where a pin holds the vertex
    std::vector<Index>
        carrier;              ///< [V] 0, or the number, from 1, of the motion that carries the fixed vertex
    std::vector<char> guide;  ///< [V] 0, or the number, from 1, of the guide that the vertex slides along
    std::vector<Index> body;  ///< [V] number of the sheet that the vertex is of, whatever broke off it since
    /// Vertices that lie on each other because a crack between them has only just opened: elements that have
    /// one each do not see each other in SheetContact.
    std::vector<std::array<Index, 2>> twins;
    std::vector<LipStencil> lips;  ///< of these cracks
    std::vector<Matrix3d> guides;  ///< projections to the directions that are free: a plane, or a line
    std::vector<Motion> motions;   ///< of carried vertices, from where they are at rest
    std::vector<TriangleStencil> triangles;
    std::vector<HingeStencil> hinges;
};

/// Gives the arrays `count` vertices; new ones are zero.
void resize_vertices(Sheet& sheet, Index count);

/// Copies all data of a vertex to another one.
void copy_vertex(Sheet& sheet, Index from, Index to);

/// The stencil of the hinge whose edge runs from vertices[0] to vertices[1]; see HingePositions for the
/// order.
/// stiffness: lambda, N m.
HingeStencil hinge_stencil(const Sheet& sheet, const std::array<Index, 4>& vertices, double stiffness);

/// Kinetic energy, J.
double kinetic_energy(const Sheet& sheet);
/// kg m/s.
Vector3d linear_momentum(const Sheet& sheet);
/// About the origin, kg m^2/s.
Vector3d angular_momentum(const Sheet& sheet);

}  // namespace sherd
