// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/scene/material_axis.h"
#include "core/material/material.h"
#include "core/shell/face_fields.h"
#include "meshops/mesh.h"

namespace sherd {

/// Contents of a material file, without a scene.
struct MaterialFile {
    Material material;
    MaterialAxis axis;                        ///< axis of a directional material
    std::optional<double> bending_stiffness;  ///< N m, lambda of all hinges; none: that of the material
};

/// Reads the keys of a scene's [material] table at the top level of a TOML file, and `bending_stiffness`.
/// Throws Error as read_scene does, with a line for each mistake.
MaterialFile read_material_file(const std::filesystem::path& file);

/// Two shapes of one sheet. The deformed shape is given by positions of vertices only, so it may be distorted
/// arbitrarily.
struct ProbeShapes {
    Mesh rest;
    std::vector<Index> file_vertex;  ///< number in the file of each vertex of `rest`, from 0
    Positions deformed;              ///< [3, V] m, for the V vertices of the rest shape's file
};

/// Reads the two shapes (.obj, .ply, .off, .stl). Throws Error like read_mesh(), and if the lists of faces of
/// the two files differ, naming the first face that differs.
ProbeShapes read_probe_shapes(const std::filesystem::path& rest, const std::filesystem::path& deformed,
                              std::vector<std::string>& warnings);

struct ProbedEnergy {
    std::string name;
    double energy = 0;  ///< J
    Positions force;    ///< [3, V] N, -dE/dx; zero at vertices that no face uses
};

/// A hinge; see core/elements/hinge.h for the order of its vertices, the angles and the strain.
struct ProbedHinge {
    std::array<Index, 4> vertices;
    double angle = 0, rest_angle = 0;  ///< rad
    double strain = 0;                 ///< 1/m
    double stiffness = 0;              ///< N m, lambda
};

struct ProbedFace {
    std::array<Index, 3> vertices;
    double strain = 0;  ///< principal Green strain of largest magnitude
};

/// Energies, forces and strains of a deformed sheet. All vertices are numbered as in the rest shape's file.
struct Probe {
    std::vector<ProbedEnergy> energies;
    std::vector<ProbedHinge> hinges;
    std::vector<ProbedFace> faces;
    FaceFields fields;  ///< with curvature of coupled hinges, and stress by the constants of the material
};

/// Evaluates all models. Throws Error (input) like material_axes(), and if an energy or force is not a finite
/// number, naming the vertices of the hinge or face.
Probe probe(const ProbeShapes& shapes, const MaterialFile& material, std::vector<std::string>& warnings);

/// JSON object with the keys of docs/commands.md.
std::string probe_json(const Probe& probe);

/// The results as text.
std::string probe_text(const Probe& probe);

/// Writes forces, hinges and fields of faces to an HDF5 file with the datasets of docs/commands.md. Throws
/// Error (input) if `file` exists and not `force`, (run) if it cannot be written.
void write_probe(const Probe& probe, const std::filesystem::path& file, bool force);

}  // namespace sherd
