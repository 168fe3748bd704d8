// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <type_traits>

#include "app/recording/hdf5.h"
#include "app/recording/recording.h"
#include "fracture/record/events.h"
#include "fracture/record/snapshot.h"
#include "fracture/step/step_report.h"

/// Layout of a recording: the name and the unit of each member of a snapshot, a step report and a crack
/// event. Writer and reader share these lists, so they cannot disagree.
namespace sherd::recording_format {

inline constexpr const char* format = "sherd recording";
/// Suffix that makes the name of a field the name of its principal values.
inline constexpr const char* principal_suffix = "_principal";
inline constexpr std::int64_t version = 4;
/// Oldest version that can be read. In version 2 all frames have the same mesh at rest; version 3 lacks crack
/// tips.
inline constexpr std::int64_t oldest_version = 2;

inline hdf5::Meaning meaning_of(const SnapshotArray& array) {
    return {array.unit, array.meaning};
}

/// Calls visit(dataset name, meaning, array, whether the third component is twice the component 01) for every
/// field of faces, including fields that a frame does not have.
template <class F, class Visit>
void visit_field_arrays(F& fields, Visit visit) {
    visit_fields(fields, [&](const char* name, auto& values, const FieldMeaning& meaning) {
        visit(std::string("face/") + name, {meaning.unit, meaning.description}, values, meaning.twice);
    });
}

/// Dataset of RecordingHeader::rest_axis in the group of the unfractured mesh; absent if the list is empty.
inline constexpr const char* material_axis = "axis";

/// Calls visit(attribute) for each attribute of SurfaceLook that is recorded. Each attribute is a dataset in
/// the group of a mesh at rest, unless its list is empty. A list of pointers to shared values is stored as
/// numbers of rows; datasets beside it hold the names, and for materials the definitions, of these rows.
template <class Visit>
void visit_recorded_attributes(const Visit& visit) {
    visit_surface_attributes([&](const auto& attribute) {
        if (*attribute.recorded != 0) visit(attribute);
    });
}

inline std::string names_of(const std::string& attribute) {
    return attribute + "_names";
}
inline std::string definitions_of(const std::string& attribute) {
    return attribute + "_definitions";
}

/// Layout of a table with a row for each object of type `Row`. `group` is its group in the file; `since` is
/// the first version of the format that has the table; visit() calls visit(column name, meaning, member) for
/// every column.
template <class Row>
struct Table;

template <>
struct Table<StepReport> {
    static constexpr const char* group = "steps";
    static constexpr std::int64_t since = 2;
    /// Whether recordings of older versions may lack the column `name`.
    static constexpr bool may_lack(std::string_view name) {
        return name == "load" || name == "residual" || name == "unexplained" || name == "exempt_pairs" ||
               name == "is_explicit" || name == "urgency" || name == "peak_yield" ||
               name.starts_with("work_of_") || name.starts_with("lost_to_");
    }
    template <class Visit>
    static void visit(Visit visit) {
        using R = StepReport;
        visit("step", {"1", "number of the step, from 1"}, &R::step);
        visit("time", {"s", "at the end of the step"}, &R::time);
        visit("step_size", {"s"}, &R::step_size);
        visit("load", {"1", "factor of all loads; 1 except in statics"}, &R::load);
        visit("kinetic", {"J"}, &R::kinetic);
        visit("bending", {"J"}, &R::bending);
        visit("membrane", {"J"}, &R::membrane);
        visit("gravity", {"J", "potential energy, zero at the origin"}, &R::gravity);
        visit("contact", {"J"}, &R::contact);
        visit("residual", {"J", "energy of the residual stress of tempered sheets"}, &R::residual);
        // Sums since the start of the run.
        const auto since_start = [&](const char* name, const char* meaning, double R::*part) {
            visit(name, hdf5::Meaning{"J", meaning}, part);
        };
        since_start("work_of_loads", "since the start, on sheets; in statics weight is a load",
                    &R::work_of_loads);
        since_start("work_of_wind", "since the start, on sheets", &R::work_of_wind);
        since_start("work_of_supports", "since the start, of pins and clamps by prescribed motion",
                    &R::work_of_supports);
        since_start("work_of_obstacles", "since the start, of obstacles by prescribed motion",
                    &R::work_of_obstacles);
        since_start("lost_to_friction", "since the start, all friction of contact", &R::lost_to_friction);
        since_start("lost_to_damping", "since the start", &R::lost_to_damping);
        since_start("lost_to_cracks",
                    "since the start: elastic energy released when edges failed, and energy taken by edges "
                    "as they opened",
                    &R::lost_to_cracks);
        since_start("lost_to_remeshing", "since the start: by changes of the triangles",
                    &R::lost_to_remeshing);
        since_start("lost_to_yield", "since the start: by bending beyond yield", &R::lost_to_yield);
        since_start("lost_to_scheme",
                    "since the start: numerical dissipation of the time scheme, by its formula",
                    &R::lost_to_scheme);
        since_start("unexplained", "since the start: change of all energies, less work, plus losses",
                    &R::unexplained);
        visit("linear_momentum", {"kg m/s"}, &R::linear_momentum);
        visit("angular_momentum", {"kg m^2/s", "about the origin"}, &R::angular_momentum);
        visit("newton_iterations", {"1", "over all stages; in explicit steps the number of substeps"},
              &R::newton_iterations);
        visit("halvings", {"1", "halvings of this step, because longer steps could not be solved"},
              &R::halvings);
        visit("stages", {"1", "number of stages"}, &R::stages);
        visit("stage_cap_reached", {"1", "0 no, 1 yes"}, &R::stage_cap_reached);
        visit("is_explicit", {"1", "whether the step was made of substeps, 0 no, 1 yes"}, &R::is_explicit);
        visit("urgency",
              {"1",
               "why explicit steps begin: 1 an impact, 2 stress, 3 a crack, 4 an unsolved step, 6 surfaces "
               "that would cross; why implicit ones begin: 5 explicit ones have failed; else 0"},
              &R::urgency);
        visit("contacts", {"1", "vertices in contact"}, &R::contacts);
        visit("obstacle_overlap", {"m", "largest depth of a sheet's surface in an obstacle"},
              &R::obstacle_overlap);
        visit("lip_overlap", {"m", "largest overlap of crack faces that have not separated yet"},
              &R::crack_face_overlap);
        visit("exempt_pairs", {"1", "pairs of vertices whose faces have overlapped since the start"},
              &R::exempt_pairs);
        visit("fragments", {"1", "number of fragments"}, &R::fragments);
        visit("peak_strain",
              {"1/m",
               "surface strain over half the thickness; like all peaks, the largest of an unbroken hinge "
               "before the failures of the step"},
              &R::peak_strain);
        visit("peak_stress", {"Pa", "surface stress"}, &R::peak_stress);
        visit("peak_bending_strain", {"1/m", "bending strain, the paper's measure"}, &R::peak_bending_strain);
        visit("peak_overload", {"1", "measure over strength; 0 where nothing can break"}, &R::peak_overload);
        visit("peak_yield",
              {"1", "von Mises stress over yield stress, largest of a face; 0 where nothing yields"},
              &R::peak_yield);
    }
};

/// Table of a support, with a row for each row of Table<StepReport>.
template <>
struct Table<Reaction> {
    template <class Visit>
    static void visit(Visit visit) {
        using R = Reaction;
        visit("force",
              {"N", "on the sheets and bodies that are held or stopped, at the end of each step of /steps"},
              &R::force);
        visit("moment", {"N m", "of the same forces, about the origin"}, &R::moment);
    }
};

/// Table of a gauge, with a row for each row of Table<StepReport>.
template <>
struct Table<GaugeReading> {
    /// Any column may be missing: is_recorded() says which are not recorded.
    static constexpr bool may_lack(std::string_view) { return true; }
    template <class Visit>
    static void visit(Visit visit) {
        using R = GaugeReading;
        visit("displacement", {"m", "from where the sheet was placed, at the end of each step of /steps"},
              &R::displacement);
        visit("curvature", {"1/m", "change of curvature of its face in `axes`, 00, 11 and 2 * 01"},
              &R::curvature);
        visit("membrane_strain",
              {"1", "Green strain of the middle surface of its face in `axes`, 00, 11 and 2 * 01"},
              &R::membrane_strain);
        visit("stress_top",
              {"Pa",
               "second Piola-Kirchhoff stress in `axes`, 00, 11 and 01, at the surface to which its face's "
               "normal points"},
              &R::stress_top);
        visit("stress_bottom", {"Pa", "second Piola-Kirchhoff stress in `axes` at the opposite surface"},
              &R::stress_bottom);
    }
};

/// Whether the recording has this column of a gauge.
bool is_recorded(const RecordedGauge& gauge, std::string_view column);

template <>
struct Table<EdgeFailure> {
    static constexpr const char* group = "events/failure";
    static constexpr std::int64_t since = 2;
    template <class Visit>
    static void visit(Visit visit) {
        using R = EdgeFailure;
        visit("time", {"s", "end of the step in which the hinge failed"}, &R::time);
        visit("step", {"1"}, &R::step);
        visit("stage", {"1", "stage of the step, from 0"}, &R::stage);
        visit("edge", {"1", "row of edge/* of the frames"}, &R::edge);
        visit("vertices", {"1", "end points, rows of vertex/* of the frames"}, &R::vertices);
        visit("boundary_vertices", {"1", "0, 1, 2: B0, B1, B2"}, &R::boundary_vertices);
        visit("strain", {"1/m", "surface strain over half the thickness"}, &R::strain);
        visit("stress", {"Pa", "surface stress"}, &R::stress);
        visit("overload", {"1", "measure of the hinge over its strength"}, &R::overload);
    }
};

template <>
struct Table<EdgeOpening> {
    static constexpr const char* group = "events/opening";
    static constexpr std::int64_t since = 2;
    template <class Visit>
    static void visit(Visit visit) {
        using R = EdgeOpening;
        visit("time", {"s"}, &R::time);
        visit("step", {"1"}, &R::step);
        visit("edge", {"1", "the edge that opened, which stays with one face"}, &R::edge);
        visit("created", {"1", "the new edge of the other face"}, &R::created);
    }
};

template <>
struct Table<VertexSplit> {
    static constexpr const char* group = "events/split";
    static constexpr std::int64_t since = 2;
    template <class Visit>
    static void visit(Visit visit) {
        using R = VertexSplit;
        visit("time", {"s"}, &R::time);
        visit("step", {"1"}, &R::step);
        visit("vertex", {"1", "the vertex that was split"}, &R::vertex);
        visit("created", {"1", "the copy of the vertex"}, &R::created);
    }
};

template <>
struct Table<FragmentSplit> {
    static constexpr const char* group = "events/fragment";
    static constexpr std::int64_t since = 2;
    template <class Visit>
    static void visit(Visit visit) {
        using R = FragmentSplit;
        visit("time", {"s"}, &R::time);
        visit("step", {"1"}, &R::step);
        visit("fragment", {"1", "number of the new fragment"}, &R::fragment);
        visit("parent", {"1", "fragment of which it was a part; its largest part keeps the number"},
              &R::parent);
    }
};

template <>
struct Table<VertexInsertion> {
    static constexpr const char* group = "events/vertex_birth";
    static constexpr std::int64_t since = 3;
    template <class Visit>
    static void visit(Visit visit) {
        using R = VertexInsertion;
        visit("time", {"s"}, &R::time);
        visit("step", {"1"}, &R::step);
        visit("created", {"1", "the inserted vertex, a row of vertex/* of the frames"}, &R::created);
        visit("parents", {"1", "vertices between which it was inserted, rows of vertex/* of the frames"},
              &R::parents);
        visit("weights", {"1", "their shares at rest, which sum to 1; inside an edge the last is 0"},
              &R::weights);
    }
};

template <>
struct Table<FaceInsertion> {
    static constexpr const char* group = "events/face_birth";
    static constexpr std::int64_t since = 3;
    template <class Visit>
    static void visit(Visit visit) {
        using R = FaceInsertion;
        visit("time", {"s"}, &R::time);
        visit("step", {"1"}, &R::step);
        visit("created", {"1", "the inserted face, a row of face/* of the frames"}, &R::created);
        visit("parent", {"1", "the face that was split, a part of which keeps the number"}, &R::parent);
    }
};

template <>
struct Table<TipRecord> {
    static constexpr const char* group = "tips";
    static constexpr std::int64_t since = 4;
    template <class Visit>
    static void visit(Visit visit) {
        using R = TipRecord;
        visit("time", {"s", "end of the step"}, &R::time);
        visit("step", {"1"}, &R::step);
        visit("tip", {"1", "number of the tip, which it keeps"}, &R::tip);
        visit("vertex", {"1", "row of vertex/* of the frames"}, &R::vertex);
        visit("position", {"m"}, &R::position);
        visit("direction", {"1", "unit vector along the path so far, in the sheet's current position"},
              &R::direction);
        visit("speed", {"m/s", "along the previous edge; less if the next one takes longer; 0 in statics"},
              &R::speed);
        visit("G", {"J/m^2", "release rate, last evaluated in the step"}, &R::released);
        visit("G_c", {"J/m^2", "fracture energy, above which the tip propagates"}, &R::toughness);
        visit("by_energy",
              {"1", "1: G is a configurational force; 0: G follows from the stress ahead of the tip"},
              &R::by_energy);
        visit("K_I", {"Pa m^0.5", "stress intensity of the membrane: opening"}, &R::opening);
        visit("K_II", {"Pa m^0.5", "stress intensity of the membrane: shear"}, &R::shear);
        visit("k_1", {"Pa m^0.5", "stress intensity of bending"}, &R::bending);
        visit("k_2", {"Pa m^0.5", "stress intensity of twist"}, &R::twist);
    }
};

/// Groups of the tables of supports and of gauges.
inline constexpr const char *reaction_group = "steps/reaction", *gauge_group = "gauges";

/// Group of natural modes, in recordings of modes.
inline constexpr const char* mode_group = "modes";

/// Calls visit(member of StepReport, group) for each member that is a list of rows. Entry i of the list is a
/// row of the i-th table of the group; numbered_groups() orders these tables.
template <class Visit>
void visit_lists(Visit visit) {
    visit(&StepReport::reactions, reaction_group);
    visit(&StepReport::gauges, gauge_group);
}

/// Calls visit(std::type_identity<Row>) for every table of a recording, except for the tables of
/// visit_lists().
template <class Visit>
void visit_tables(Visit visit) {
    visit(std::type_identity<StepReport>{});
    visit_kinds([&]<class Event>(std::vector<Event> CrackEvents::*) { visit(std::type_identity<Event>{}); });
}

/// Returns the paths of the members of a group, which are groups, in the order of their attribute `number`;
/// none if the group does not exist.
std::vector<std::string> numbered_groups(hid_t file, const std::string& group);

/// Returns a name that a member of a group may have: without slashes.
std::string member_name(std::string name);

/// Returns the name of the group of a frame.
std::string frame_group(std::size_t number);

/// Dataset of RecordedObstacle::plane, which older recordings lack.
inline constexpr const char* obstacle_planes = "obstacles/plane";
/// Dataset of RecordedObstacle::deforms; absent if no obstacle deforms.
inline constexpr const char* obstacle_deforms = "obstacles/deforms";

/// Returns the name of the group of an obstacle's surface.
std::string obstacle_group(std::size_t number);
/// Returns the path of an obstacle's points or triangles. number: number of the obstacle.
std::string obstacle_points(std::size_t number);
std::string obstacle_points(std::size_t frame,
                            std::size_t number);  ///< points in a frame, if the obstacle has moved or deforms
std::string obstacle_faces(std::size_t number);

/// An obstacle's pose as it is stored: the rows of the matrix (rotation | translation in m).
using StoredPose = std::array<double, 12>;

/// Returns the unfractured mesh of a header.
RestMesh unfractured_mesh(const RecordingHeader& header);

/// Returns a message on the first fault of a snapshot's arrays, or "" if there is none. unfractured_vertices:
/// number of vertices of the run's unfractured mesh.
std::string inconsistency(const Snapshot& snapshot, std::size_t unfractured_vertices);
/// Returns a message on the first fault of the mesh at rest, or "" if there is none.
std::string inconsistency(const RecordingHeader& header);
/// Returns a message on the first fault of an obstacle's surface, or "" if there is none.
std::string inconsistency(const RecordedObstacle& obstacle);

}  // namespace sherd::recording_format
