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
    std::optional<std::pair<Vector3d, Vector3d>> box;  ///< m, lower and upper corner of a box around placed
                                                       ///< vertices
    bool boundary = false;                             ///< all boundary vertices
    std::string group;                                 ///< group of faces whose vertices are selected
    std::string where;                                 ///< "FILE:LINE: dotted.key", for errors
};

/// `[[sheet.NAME.pin]]` or `[[sheet.NAME.clamp]]`: vertices that are held.
struct PinSpec {
    Selection on;
    Motion motion = {};                   ///< at rest if it has no keys; moving_pins() sets its pivot
    std::optional<Vector3d> centre = {};  ///< m, centre of rotation; none: centre of the vertices' bounding
                                          ///< box
    std::array<bool, 3> free = {};        ///< whether the vertices are free to move along x, y and z; never
                                          ///< in all three

    bool holds_all_directions() const { return free == std::array<bool, 3>{}; }
};

/// A symmetry plane, behind which the sheet continues as its mirror image.
struct SymmetrySpec {
    Vector3d point = Vector3d::Zero();
    Vector3d normal = Vector3d::UnitX();
    std::string where;  ///< "FILE:LINE: dotted.key", for errors
};

/// A load: `[[force.load]]`.
struct LoadSpec {
    std::string kind;                   ///< point, line, area, pressure, moment
    Vector3d force = Vector3d::Zero();  ///< N for a point load, N/m for a line load, N/m^2 for an area load
    double pressure = 0;                ///< Pa, for a pressure load
    double moment = 0;                  ///< N m/m, for a moment load
    double ramp = 0;                    ///< s, time in which the load grows to its full size
    std::string sheet;                  ///< name; empty: all sheets
    Selection on;                       ///< without box, boundary and group: all vertices
    std::string where;                  ///< "FILE:LINE: dotted.key", for errors
};

/// `[[gauge]]`: a point at which something is measured.
struct GaugeSpec {
    std::string name;                ///< letters, digits, _ and -
    std::string sheet;               ///< name; empty: the nearest sheet
    Vector3d at = Vector3d::Zero();  ///< m, place at most an edge length from the placed sheet
    bool displacement = true;        ///< whether the displacement is recorded
    FaceFieldChoice fields = {};     ///< fields that are recorded for the gauge's face
    std::string where;               ///< "FILE:LINE: dotted.key", for errors
};

/// Gusts of a wind: `gust = { ... }`.
struct GustSpec {
    double amplitude = 0;         ///< m/s, root mean square of the gusts' magnitude
    double time = 0, length = 0;  ///< duration, s, and size, m, of a typical gust
};

/// A wind: `[[force.wind]]`.
struct WindSpec {
    Wind wind;  ///< without its gusts and triangles, which add_winds() sets
    std::optional<GustSpec> gust;
    std::string sheet;  ///< name; empty: all sheets
    std::string where;  ///< "FILE:LINE: dotted.key", for errors
};

struct MaterialPreset;

/// Fracture data of a sheet: `[sheet.NAME.fracture]`.
struct FractureSpec {
    const MaterialPreset* material = nullptr;  ///< preset of the sheet's material; null: none
    bool has_preset = false;                   ///< whether fracture data are taken from the preset
    Strength strength;                         ///< without the factors of edges
    /// Toughness (Pa m^0.5) and fracture energy (J/m^2), at most one of which is given; 0: not given.
    double toughness = 0, fracture_energy = 0;
    std::optional<double> toughness_across = {};  ///< Pa m^0.5, for tension across the material axis; none:
                                                  ///< as along it
    double speed_limit = 0;                       ///< m/s, largest speed of crack tips; 0:
                                                  ///< usual_speed_limit()
    CrackPath path = CrackPath::cut;
    double weibull_modulus = 0, weibull_area = 0;  ///< modulus, 0: no scatter; reference area, m^2, 0: each
                                                   ///< hinge's area
    std::vector<StrengthMap> maps;                 ///< none: strength and toughness do not vary
    std::vector<Score> scores;
    std::vector<Score> cracks;  ///< initial cracks; their factors have no meaning
    ArtDirection art_direction;

    bool has_toughness() const { return toughness > 0 || fracture_energy > 0; }
};

/// `bend`: a sheet that is flat at rest starts rolled up.
struct BendSpec {
    double curvature = 0;                ///< 1/m, positive if the sheet bends towards its normals
    Vector3d along = Vector3d::UnitX();  ///< direction in the frame of the mesh before it is placed
    Vector3d from = Vector3d::Zero();    ///< m, in the same frame: the line across `along` through this point
                                         ///< stays in place
    std::string where;                   ///< "FILE:LINE: dotted.key", for errors
};

struct SheetSpec {
    std::string name;
    std::variant<GeneratedMesh, MeshFile, GivenMeshName> mesh;
    Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
    std::optional<BendSpec> bend;            ///< none: the sheet starts in its rest shape
    Vector3d velocity = Vector3d::Zero();    ///< m/s, initial velocity
    Vector3d spin = Vector3d::Zero();        ///< rad/s, initial angular velocity, about the centre of mass
    const MaterialPreset* preset = nullptr;  ///< preset of the material; null: none
    Material material;                       ///< without its thickness if `thickness` is given
    std::optional<ThicknessMap> thickness;   ///< map of the thickness; none: the material's thickness
                                             ///< everywhere
    MaterialAxis axis;                       ///< first material axis; meaningless if nothing depends on the
                                             ///< direction
    std::optional<FractureSpec> fracture;    ///< none: the sheet does not break
    std::vector<PinSpec> pins, clamps;
    std::vector<SymmetrySpec> symmetries;
    std::string where;  ///< "FILE:LINE: dotted.key" of its mesh, for errors

    bool is_supported() const { return !pins.empty() || !clamps.empty() || !symmetries.empty(); }
};

/// A scene file, read and checked: every value is in SI units and in its allowed range.
struct Scene {
    std::filesystem::path file;
    std::string variant;  ///< name; empty: none
    std::string text;     ///< text of the file, with variant and overrides in comments at its end
    double duration = 0;  ///< s; in statics, the last load factor, or with arc_length longest_path
    std::int64_t seed = 1;
    std::vector<SheetSpec> sheets;
    GivenMeshes given_meshes = {};        ///< meshes from a program, which sheets may name
    std::vector<ObstacleSpec> obstacles;  ///< obstacles at rest or with prescribed motion
    std::vector<ObstacleSpec> bodies;     ///< free obstacles
    std::vector<LoadSpec> loads;
    std::vector<WindSpec> winds;
    std::vector<GaugeSpec> gauges;
    bool exempts_overlaps = true;  ///< whether overlaps at the start are exempt from contact; if not, they
                                   ///< are errors
    /// Options, except those that refer to meshes, which build_scene() adds.
    SimulationOptions simulation = {};
    double longest_path = 20;                     ///< length of the path of equilibria, in load factors, at
                                                  ///< which statics with arc_length end
    double frame_interval = 0;                    ///< s, output.every: time between frames, at least a step
    double checkpoint_interval = 600;             ///< s of wall time, output.checkpoint; 0: only at the start
                                                  ///< and the end
    std::map<std::string, std::string> settings;  ///< settings_of() the file, after variant and overrides
                                                  ///< have been applied

    bool is_static() const { return simulation.stepper.scheme == Scheme::statics; }
    /// Returns the unit of times: "s"; in statics "load", or "path" with arc_length.
    std::string time_unit() const {
        return !is_static() ? "s" : simulation.stepper.arc_length ? "path" : "load";
    }
};

/// Returns the mesh files of the sheets of a scene, and the mesh files and point caches of its obstacles.
/// Files of free bodies are not included.
std::vector<std::filesystem::path> input_files(const Scene& scene);

/// Returns the number of steps that cover the duration. If the duration is no multiple of the step, its rest
/// counts as a whole step, unless the rest is round-off.
std::int64_t step_count(const Scene& scene);

/// Whether a run records a frame at the end of a step. step: number of the step, from 1.
bool has_frame(const Scene& scene, std::int64_t step);

/// Returns the number of frames of a whole run, including those at its start and at its end.
std::int64_t frame_count(const Scene& scene);

}  // namespace sherd
