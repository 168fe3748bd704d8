// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/material/material.h"
#include "core/motion.h"
#include "fracture/shell/strength.h"
#include "fracture/shell/toughness.h"
#include "meshops/mesh.h"

namespace sherd {

/// Limits on the fracture of a sheet, whatever its load, for the sake of a picture.
struct ArtDirection {
    double after = 0;     ///< s; no edge of the sheet fails before this time
    double smallest = 0;  ///< m; square root of the area of the smallest piece that may separate; 0: any
};

/// Pinned vertices with one scripted motion, relative to their rest positions.
struct MovingPin {
    std::vector<Index> vertices;
    Motion motion;
};

/// The input of a simulation for one sheet.
struct SheetInput {
    Mesh mesh;                      ///< m, the rest shape, placed where the sheet starts
    Positions start;                ///< [3, V] m, start positions; without columns: the rest shape
    Material material;              ///< with the mean thickness if the sheet is uneven
    std::vector<double> thickness;  ///< [V] m, linear in each face; empty: the material's everywhere
    /// [F] first material axis, in the face's plane; may be empty if no property of the sheet depends on the
    /// direction.
    std::vector<Vector3d> axes;
    Strength strength;                     ///< by default the sheet cannot fail
    Toughness toughness;                   ///< by default cracks propagate by strength, too
    ArtDirection art_direction;            ///< by default without limits
    Vector3d velocity = Vector3d::Zero();  ///< m/s
    Vector3d spin = Vector3d::Zero();      ///< rad/s, about the centre of mass
    std::vector<Index> pinned;             ///< vertices that are fixed or scripted
    std::vector<MovingPin> moving_pins;    ///< motions of pinned vertices, at most one for a vertex

    Vector3d starts_at(Vertex vertex) const;    ///< m
    double thickness_at(Vertex vertex) const {  ///< m
        return thickness.empty() ? material.thickness : thickness[vertex.idx()];
    }
    double thinnest() const;  ///< m
    double thickest() const;  ///< m
};

/// Throws Error, with the number `sheet`, unless input.thickness has a positive number for each vertex or is
/// empty.
void require_thickness(const SheetInput& input, std::size_t sheet);

}  // namespace sherd
