// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "meshops/mesh.h"

namespace sherd {

/// Extent of the repairs with which read_mesh() makes a mesh of the polygons of a file. Basic repairs are:
/// where fans of faces meet in a single point, each fan gets a point of its own; faces are turned over until
/// neighbours have the same orientation; vertices that no face uses are dropped.
enum class Repair {
    none,   ///< no repairs: a fault that needs one is an error
    least,  ///< basic repairs
    all,    ///< all unambiguous repairs: see ReadMeshOptions
};

struct ReadMeshOptions {
    bool join_duplicate_points = false;  ///< join points at exactly the same place to one vertex
    /// Repair::all adds these repairs to the basic ones: triangles of zero area are removed without leaving a
    /// slit; faces with fewer than three corners, and repeated faces, are dropped; sheets that meet in an
    /// edge of more than two faces are separated; closed parts that are inside out are turned over; and if no
    /// two faces of the file share a point, points at the same place are joined.
    Repair repair = Repair::least;
    /// Words with which the user can request a repair, for messages; empty if that is impossible.
    std::string_view repair_advice = "`repair = true` on the mesh";
    /// Words with which the user can join points, for messages; empty: no warnings about seams.
    std::string_view join_advice = "`join = true` on the mesh";
    /// If positive, points on the boundary within this distance of each other (in units of the file) are
    /// joined, and then edges on the boundary are divided at points within this distance of them.
    double join_distance = 0;
    double unit = 1;  ///< m per unit of the file, for messages
};

/// Reads a triangle mesh from an .obj, .ply, .off or .stl file, text or binary if the format has both. Points
/// of .stl files at the same place are always joined, since the format repeats points for every triangle.
/// Polygons are triangulated. Faces keep the order of the file (the triangles of a polygon follow each other)
/// and the order of their corners; where a face is turned over, its first corner stays the first. The mesh
/// gets the attributes (attributes.h) that the file has: texture coordinates, groups and materials of OBJ,
/// colours and numbers of PLY; every mesh gets attribute::file_vertex. `warnings` gets a sentence, starting
/// with the name of the file, for each kind of change and for each kind of seam: edges that lie on other
/// edges without being joined to them; edges that lie within a thousandth of their length from other edges;
/// and vertices that lie on edges without dividing them. Throws Error naming the file (and line, vertex or
/// face, numbered from 0) if the file is missing, unreadable, damaged or of unknown extension; if it has no
/// faces, NaN or infinite coordinates, an index out of range, a polygon that crosses itself or a surface with
/// only one side; and if it has faults that may not be repaired according to `options`.
Mesh read_mesh(const std::filesystem::path& file, const ReadMeshOptions& options,
               std::vector<std::string>& warnings);

/// Reads the property `name` of the vertices of a .ply file, which may be a number of any type. Returns its
/// value for each vertex, by the number of the vertex in the file (attribute::file_vertex). Components of a
/// colour are returned as numbers from 0 to 1, whatever their type. Throws Error naming the file if it is
/// missing, damaged or no PLY file, or has no such property.
std::vector<double> read_vertex_property(const std::filesystem::path& file, const std::string& name);

}  // namespace sherd
