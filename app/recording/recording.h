// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <Eigen/Geometry>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/files/disk/journaled_file.h"
#include "app/files/disk/output_lock.h"
#include "app/recording/xdmf.h"
#include "core/state_visitor.h"
#include "core/vector.h"
#include "fracture/record/events.h"
#include "fracture/record/snapshot.h"
#include "fracture/step/step_report.h"
#include "meshops/level_set/signed_distance_grid.h"

namespace sherd {

class PendingFile;

/// An obstacle that can be drawn.
struct RecordedObstacle {
    std::string name;
    GridSurface surface;  ///< m, in the obstacle's own frame of reference
    bool plane = false;   ///< whether it is an infinite plane; `surface` is then a square that faces the
                          ///< sheets
    /// Whether the obstacle deforms. Each frame then has its points (ObstacleShapes), and its pose is the
    /// identity.
    bool deforms = false;
};

/// For each obstacle that deforms, its points in space at a moment, m; empty for other obstacles.
using ObstacleShapes = std::vector<std::vector<Vector3d>>;

/// Returns the surface with other points, or unchanged if `points` is empty.
inline GridSurface reshaped(const GridSurface& surface, const std::vector<Vector3d>& points) {
    return points.empty() ? surface : GridSurface{points, surface.triangles};
}

/// Places of the obstacles in a frame of a recording.
struct ObstaclePlaces {
    std::vector<Eigen::Isometry3d> poses;  ///< from each obstacle's own frame of reference to space
    std::vector<std::string> points;       ///< path of the dataset with each obstacle's points in space

    void visit_state(StateVisitor& visit) {
        auto& [poses, points] = *this;
        visit(poses, points);
    }
};

/// A support or an obstacle whose reaction is recorded.
struct RecordedSupport {
    std::string name;  ///< "sheet.plate.pin", "obstacle.floor"
    std::string kind;  ///< "pin", "clamp", "symmetry" or "obstacle"
};

/// A gauge whose readings are recorded.
struct RecordedGauge {
    std::string name;
    std::string sheet;
    Vector3d place = Vector3d::Zero();  ///< m, on the sheet at rest
    bool displacement = true;           ///< whether the displacement is recorded
    FaceFieldChoice fields = {};        ///< fields of its face that are recorded
    /// Axes (frame_axes()) of the gauge's face at rest, to which the components of `fields` refer; zero
    /// without fields.
    Eigen::Matrix<double, 3, 2> axes = Eigen::Matrix<double, 3, 2>::Zero();
};

/// Header of a recording: data of the run that do not change.
struct RecordingHeader {
    std::string scene_file;  ///< path as given by the user
    /// TOML, as read; variant and overrides of the command line are appended as comments.
    std::string scene_text;
    std::int64_t seed = 0;
    std::string time_unit = "s";                   ///< unit of all times; "load" or "path" in statics
    std::vector<std::string> sheet_names;          ///< names by Snapshot::face_sheet
    Positions rest_position;                       ///< [3, V0] m, positions of the unfractured mesh
    std::vector<std::array<Index, 3>> rest_faces;  ///< [F0] vertices of each face of the unfractured mesh
    std::vector<double> rest_area;                 ///< [F0] m^2, area of each face
    std::vector<double> rest_thickness;            ///< [F0] m, thickness of each face; empty in old
                                                   ///< recordings
    SurfaceLook rest_look = {};                    ///< look of the unfractured mesh
    /// [F0] first material axis of each face, a unit vector in the face's plane; zero where it does not
    /// matter. Empty if zero everywhere, or in a recording of an older version.
    std::vector<Vector3d> rest_axis = {};
    std::vector<RecordedSupport> supports = {};  ///< in the order of StepReport::reactions
    std::vector<RecordedGauge> gauges = {};      ///< in the order of StepReport::gauges
};

/// A natural mode of vibration of the sheets.
struct RecordedMode {
    double frequency = 0;  ///< Hz; 0: the mode is unstable
    double growth = 0;     ///< 1/s, rate at which an unstable mode grows; 0: it is stable
    Positions shape;       ///< [3, V] 1/sqrt(kg), displacements u; the sum of m |u|^2 is 1

    /// Returns as text the frequency ("12.345 Hz") of a stable mode, or the growth of an unstable one.
    std::string words() const;
};

/// Files of a recording and of its index, locked for this program during the lifetime of this object.
struct RecordingOutput {
    /// Locks the files. Throws Error (input) if another program writes one of them, if one of them exists and
    /// `force` is false, or if the folder cannot be written; then leaves no files behind. permission: what
    /// sets `force`, for the message.
    RecordingOutput(const std::filesystem::path& file, bool force, std::string_view permission = "--force");

    OutputLock recording, index;
    bool force;  ///< whether existing files are replaced
};

/// Writes a run to an .h5 file and the .xdmf index beside it. Each append changes the .h5 file completely or
/// not at all (JournaledFile), and the .xdmf file is replaced atomically, so that both files can be read
/// during the run. The .xdmf file is always written as a whole: after each of the first two hundred frames,
/// then whenever the number of frames has grown by a hundredth, and after the last frame. The mesh at rest of
/// a frame is written only if it differs from that of the previous frame. The layout of the .h5 file is in
/// docs/recording.md. The program must ignore SIGXFSZ, so that a file size limit is an error like a full
/// disk.
class RecordingWriter {
  public:
    /// Creates the file. If `resumes` is true, opens the existing file instead; visit_state() and resume()
    /// must then restore its state. Throws Error (input) if the file cannot be created; then leaves no files
    /// behind.
    RecordingWriter(RecordingOutput output, const RecordingHeader& header,
                    std::span<const RecordedObstacle> obstacles = {}, bool resumes = false);
    RecordingWriter(const std::filesystem::path& file, const RecordingHeader& header, bool force,
                    std::span<const RecordedObstacle> obstacles = {});

    /// Adds a frame, with the steps and events since the previous frame. poses: motion of each obstacle from
    /// its own frame of reference to space; shapes: points of obstacles that deform. Throws Error (run) if
    /// the disk is full or the file cannot be written; the file is then unchanged.
    void append(const Snapshot& snapshot, std::span<const StepReport> steps, const CrackEvents& events,
                std::span<const Eigen::Isometry3d> poses = {}, const ObstacleShapes& shapes = {});

    /// Adds the natural modes that the frames of this recording show. Times of such frames are not physical;
    /// `times` says what they mean. Frames of the first mode have the step number 1, and so on. Throws Error
    /// (run) as append() does.
    void add_modes(std::span<const RecordedMode> modes, const std::string& times);

    /// Stores the wall time of the run, s, and `end`: whether the run was complete, interrupted or failed.
    void finish(double wall_seconds, const std::string& end);

    /// Visits the state of the recording: its frames, and the lengths of its tables.
    void visit_state(StateVisitor& visit);
    /// Resumes the recording: truncates the file to the restored state. scene_text: text of the resumed run's
    /// scene. Throws Error (run) if the file holds less than the restored state.
    void resume(const std::string& scene_text);
    const OutputLock& lock() const { return output.recording; }

  private:
    const std::filesystem::path& file() const { return output.recording.output(); }
    /// Writes the last of `frames`, with its steps, events and obstacles.
    void record(const Snapshot& snapshot, std::span<const StepReport> steps, const CrackEvents& events,
                ObstaclePlaces next, const ObstacleShapes& shapes);
    void write_index(PendingFile& index) const;

    RecordingOutput output;
    std::vector<std::size_t> rows;  ///< number of rows of each table
    JournaledFile recording;
    std::vector<XdmfFrame> frames;
    std::size_t indexed = 0;  ///< number of frames in the index
    std::vector<RecordedObstacle> obstacles;
    ObstaclePlaces places;                 ///< in the last frame; without frames, first_places()
    std::size_t supports = 0, gauges = 0;  ///< numbers of supports and gauges
    RestMesh rest;                         ///< mesh at rest of the last frame, at first the unfractured one
    std::string rest_path = "/rest";       ///< path of `rest` in the file
    std::size_t unfractured_vertices = 0;
    std::string time_unit;  ///< RecordingHeader::time_unit
};

/// Reads a recording, also during its run: each call reads the last committed state. Every member throws
/// Error (input) if the data are damaged, or if another file has replaced the file that the constructor
/// opened.
class Recording {
  public:
    /// Opens the recording, and repairs it if its writer was killed. Throws Error if the file is missing, not
    /// HDF5, not a recording, or of a version that cannot be read.
    explicit Recording(const std::filesystem::path& file);

    /// Description of the repair, for users; "" if there was none.
    const std::string& recovery() const { return recovery_message; }

    RecordingHeader header() const;
    std::size_t frame_count() const;
    Snapshot frame(std::size_t number) const;         ///< requires number < frame_count()
    FaceFields fields(std::size_t number) const;      ///< fields of a frame, without its other data
    double time(std::size_t number) const;            ///< s, time of a frame
    std::vector<RecordedObstacle> obstacles() const;  ///< empty in recordings of earlier versions
    std::vector<Eigen::Isometry3d> poses(std::size_t number) const;  ///< poses of obstacles() in a frame
    ObstacleShapes shapes(std::size_t number) const;                 ///< shapes of obstacles() in a frame
    std::vector<StepReport> steps() const;  ///< reactions and gauges in the order of header()
    bool has_balance() const;  ///< whether steps() have an energy balance; older recordings lack it
    CrackEvents events() const;
    std::vector<RecordedMode> modes() const;  ///< empty in the recording of a run
    double wall_seconds() const;              ///< s; 0 during the run
    std::string end() const;                  ///< "running", "complete", "interrupted" or "failed: ..."

  private:
    /// Opens the file and returns read(opened); errors name the file.
    template <class Read>
    auto read_with(Read read) const;

    std::filesystem::path file;
    std::string recovery_message;
    std::int64_t version = 0;
    std::pair<dev_t, ino_t> identity;  ///< device and inode of the file, which reveal its replacement
};

}  // namespace sherd
