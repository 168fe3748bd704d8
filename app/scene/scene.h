// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "app/scene/material_axis.h"
#include "app/scene/mesh_spec.h"
#include "app/scene/obstacle_spec.h"
#include "app/scene/scene_choice.h"
#include "app/scene/strength_map.h"
#include "core/forces/wind.h"
#include "core/material/material.h"
#include "core/shell/face_fields.h"
#include "fracture/shell/sheet_input.h"
#include "fracture/step/simulation.h"

namespace sherd {

/// Vertices that a support holds or a load acts on.
struct Selection {
    std::optional<std::pair<Vector3d, Vector3d>> box;  ///< lower and upper corner, placed positions
    bool boundary = false;                             ///< all boundary vertices
    std::string group;                                 ///< group of faces whose vertices are selected
    std::string where;                                 ///< "FILE:LINE: dotted.key", for errors
};

/// `[[sheet.NAME.pin]]` and `clamp`: vertices that are held.
struct PinSpec {
    Selection on;
    Motion motion = {};                   ///< none without keys; the pivot is set later
    std::optional<Vector3d> centre = {};  ///< m, centre of rotation; none: centre of the vertices' box
    std::array<bool, 3> free = {};        ///< directions (x, y, z) in which the vertices are free, not all

    bool holds_all_directions() const { return free == std::array<bool, 3>{}; }
};

/// A symmetry plane, behind which the sheet continues as its mirror image.
struct SymmetrySpec {
    Vector3d point = Vector3d::Zero();
    Vector3d normal = Vector3d::UnitX();
    std::string where;  ///< "FILE:LINE: dotted.key", for errors
};

/// `[[force.load]]`.
struct LoadSpec {
    std::string kind;                   ///< point, line, area, pressure, moment
    Vector3d force = Vector3d::Zero();  ///< N, N/m or N/m^2, of a point, line or area load
    double pressure = 0;                ///< Pa
    double moment = 0;                  ///< N m/m
    double ramp = 0;                    ///< s
    std::string sheet;                  ///< name; empty: all sheets
    Selection on;                       ///< without box, boundary and group: everything
    std::string where;                  ///< "FILE:LINE: dotted.key", for errors
};

/// `[[gauge]]`: a point at which something is measured.
struct GaugeSpec {
    std::string name;                ///< letters, digits, _ and -
    std::string sheet;               ///< name; empty: the nearest sheet
    Vector3d at = Vector3d::Zero();  ///< m, placed
    bool displacement = true;        ///< whether the displacement is recorded
    FaceFieldChoice fields = {};     ///< recorded fields of its face
    std::string where;               ///< "FILE:LINE: dotted.key", for errors
};

/// `gust` of a wind.
struct GustSpec {
    double amplitude = 0;         ///< m/s, root mean square
    double time = 0, length = 0;  ///< s, m, of a typical gust
};

/// `[[force.wind]]`.
struct WindSpec {
    Wind wind;  ///< without gusts and triangles
    std::optional<GustSpec> gust;
    std::string sheet;  ///< name; empty: all sheets
    std::string where;  ///< "FILE:LINE: dotted.key", for errors
};

struct MaterialPreset;

/// `[sheet.NAME.fracture]`.
struct FractureSpec {
    const MaterialPreset* material = nullptr;  ///< preset of the sheet's material; null: none
    bool has_preset = false;                   ///< whether the fracture data are those of the preset
    Strength strength;                         ///< without factors
    /// Pa m^0.5 and J/m^2, of which one may be given; 0: none
    double toughness = 0, fracture_energy = 0;
    std::optional<double> toughness_across = {};  ///< for tension across the axis; none: as along it
    double speed_limit = 0;                       ///< m/s; 0: by the material
    CrackPath path = CrackPath::cut;
    double weibull_modulus = 0, weibull_area = 0;  ///< 0: no scatter; m^2, 0: area of each hinge
    std::vector<StrengthMap> maps;                 ///< none: the same strength everywhere
    std::vector<Score> scores;
    std::vector<Score> cracks;  ///< cracks at the start; their factors have no meaning
    ArtDirection art_direction;

    bool has_toughness() const { return toughness > 0 || fracture_energy > 0; }
};

/// `bend`: a sheet that is flat at rest starts rolled up.
struct BendSpec {
    double curvature = 0;                ///< 1/m, positive towards its normals
    Vector3d along = Vector3d::UnitX();  ///< direction in the mesh before it is placed
    Vector3d from = Vector3d::Zero();    ///< m, point of the line across `along` that stays in place
    std::string where;                   ///< "FILE:LINE: dotted.key", for errors
};

struct SheetSpec {
    std::string name;
    std::variant<GeneratedMesh, MeshFile, GivenMeshName> mesh;
    Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
    std::optional<BendSpec> bend;            ///< none: it starts in its rest shape
    Vector3d velocity = Vector3d::Zero();    ///< m/s
    Vector3d spin = Vector3d::Zero();        ///< rad/s, about the centre of mass
    const MaterialPreset* preset = nullptr;  ///< preset of the material; null: none
    Material material;                       ///< without thickness if there is a map of it
    std::optional<ThicknessMap> thickness;   ///< none: the material's everywhere
    MaterialAxis axis;                       ///< first material axis, if anything depends on the direction
    std::optional<FractureSpec> fracture;    ///< none: it does not break
    std::vector<PinSpec> pins, clamps;
    std::vector<SymmetrySpec> symmetries;
    std::string where;  ///< "FILE:LINE: dotted.key" of its mesh, for errors

    bool is_supported() const { return !pins.empty() || !clamps.empty() || !symmetries.empty(); }
};

/// A scene file, read and checked: every value is in SI units and in its allowed range.
struct Scene {
    std::filesystem::path file;
    std::string variant;  ///< name; empty: none
    std::string text;     ///< as read, with variant and overrides in comments at its end
    double duration = 0;  ///< s; in statics, the last load factor, or the longest path
    std::int64_t seed = 1;
    std::vector<SheetSpec> sheets;
    GivenMeshes given_meshes = {};        ///< meshes from a program, which sheets may name
    std::vector<ObstacleSpec> obstacles;  ///< obstacles at rest or with prescribed motion
    std::vector<ObstacleSpec> bodies;     ///< free obstacles
    std::vector<LoadSpec> loads;
    std::vector<WindSpec> winds;
    std::vector<GaugeSpec> gauges;
    bool exempts_overlaps = true;  ///< whether overlaps at the start are exempt; otherwise they are errors
    /// Options without those that refer to meshes.
    SimulationOptions simulation = {};
    double longest_path = 20;                     ///< length of path at which statics with arc_length end
    double frame_interval = 0;                    ///< s, output.every; at least a step
    double checkpoint_interval = 600;             ///< s of wall time, output.checkpoint; 0: only at the end
    std::map<std::string, std::string> settings;  ///< settings_of() the file with variant and overrides

    bool is_static() const { return simulation.stepper.scheme == Scheme::statics; }
    /// Unit of times: "s", or "load" or "path" in statics.
    std::string time_unit() const {
        return !is_static() ? "s" : simulation.stepper.arc_length ? "path" : "load";
    }
};

/// Returns the mesh files and point caches of the sheets of a scene and of its obstacles, except free ones.
std::vector<std::filesystem::path> input_files(const Scene& scene);

/// Returns the number of steps that cover the duration. A remainder is a whole step, but one due to round-off
/// is not.
std::int64_t step_count(const Scene& scene);

/// Whether a run records a frame at the end of a step, numbered from 1.
bool has_frame(const Scene& scene, std::int64_t step);

/// Returns the number of frames of a whole run, the one at the start and the one at the end included.
std::int64_t frame_count(const Scene& scene);

}  // namespace sherd
