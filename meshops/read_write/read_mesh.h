// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "meshops/mesh.h"

namespace sherd {

/// Extent of the repairs with which read_mesh() makes a mesh of a file's polygons. Basic repairs: fans of
/// faces that meet in a single point get a point each, faces are turned over until neighbours agree, and
/// vertices that no face uses are dropped.
enum class Repair {
    none,   ///< no repairs: whatever needs one is an error
    least,  ///< basic repairs
    all,    ///< all unambiguous repairs: see ReadMeshOptions
};

struct ReadMeshOptions {
    bool join_duplicate_points = false;  ///< join points at exactly the same place to one vertex
    /// With Repair::all triangles of zero area are removed without leaving a slit, faces of fewer than three
    /// corners and repeated ones are dropped, sheets that meet in an edge of more than two faces are
    /// separated, closed parts that are inside out are turned, and points at one place are joined where no
    /// two faces share any.
    Repair repair = Repair::least;
    /// Text with which the user can request a repair, for messages; empty if that is impossible.
    std::string_view repair_advice = "`repair = true` on the mesh";
    /// Text with which the user can join points, for messages; empty: no warnings about seams.
    std::string_view join_advice = "`join = true` on the mesh";
    /// If positive, points on the boundary within this distance of each other (in units of the file) are
    /// joined, too, and edges on the boundary are divided at points within this distance.
    double join_distance = 0;
    double unit = 1;  ///< m per unit of the file, for messages
};

/// Reads a triangle mesh from an .obj, .ply, .off or .stl file, text or binary if the format has both. Points
/// of .stl are always joined, since the format repeats them for every triangle. Polygons are triangulated.
/// Faces keep the order of the file (a polygon's triangles follow each other) and the order of their corners;
/// where faces are turned over, the first corner stays the first. The mesh gets the attributes (attributes.h)
/// that the file has: texture coordinates, groups and materials of OBJ, colours and numbers of PLY; every
/// mesh gets attribute::file_vertex. `warnings` gets a sentence, starting with the file's name, for each kind
/// of change, and for seams: edges that lie on others, or within a thousandth of their length, without being
/// joined to them, and vertices on edges that they do not divide. Throws Error naming the file (and line,
/// vertex or face, numbered from 0) if the file is missing, unreadable, damaged or of unknown extension, on
/// no faces, NaN or infinite coordinates, an index out of range, a polygon that crosses itself, a surface
/// with only one side and on faults that `repair` does not allow to mend.
Mesh read_mesh(const std::filesystem::path& file, const ReadMeshOptions& options,
               std::vector<std::string>& warnings);

/// Reads a property of the vertices of a .ply file: a number of any type for each, by its number in the file
/// (attribute::file_vertex). The parts of a colour are from 0 to 1 whatever their type. Throws Error naming
/// the file if it is missing, damaged or no PLY file, or has no such property.
std::vector<double> read_vertex_property(const std::filesystem::path& file, const std::string& name);

}  // namespace sherd
