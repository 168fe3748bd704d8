// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <Eigen/Geometry>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/files/journaled_file.h"
#include "app/files/output_lock.h"
#include "app/recording/recorded_obstacle.h"
#include "app/recording/xdmf.h"
#include "core/state_visitor.h"
#include "fracture/events.h"
#include "fracture/snapshot.h"
#include "fracture/step_report.h"

namespace sherd {

class PendingFile;

/// A support or an obstacle, whose reaction is recorded.
struct RecordedSupport {
    std::string name;  ///< "sheet.plate.pin", "obstacle.floor"
    std::string kind;  ///< "pin", "clamp", "symmetry" or "obstacle"
};

/// A gauge, what it shows of which is recorded.
struct RecordedGauge {
    std::string name;
    std::string sheet;
    Vector3d place = Vector3d::Zero();  ///< m, on the sheet at rest
    bool displacement = true;           ///< whether it is recorded
    FaceFieldChoice fields = {};        ///< of its face, that are recorded, too
    /// Of its face at rest, in which these are: frame_axes(). Zero without any.
    Eigen::Matrix<double, 3, 2> axes = Eigen::Matrix<double, 3, 2>::Zero();
};

/// What a recording says about its run once, at its head.
struct RecordingHeader {
    std::string scene_file;  ///< as given by the user
    std::string
        scene_text;  ///< TOML, as read, with variant and overrides of the command line appended as comments
    std::int64_t seed = 0;
    std::string time_unit = "s";                   ///< of all its times; "load" or "path" in statics
    std::vector<std::string> sheet_names;          ///< by face_sheet
    Positions rest_position;                       ///< [3, V0] of the unbroken mesh, m
    std::vector<std::array<Index, 3>> rest_faces;  ///< [F]
    std::vector<double> rest_area;                 ///< [F] m^2
    std::vector<double> rest_thickness;            ///< [F] m; empty in recordings of before there was any
    SurfaceLook rest_look = {};                    ///< of it
    /// [F] first material axis of each face, a unit vector in it; zero where none matters; empty: nowhere, or
    /// in recordings of before there was any.
    std::vector<Vector3d> rest_axis = {};
    std::vector<RecordedSupport> supports = {};  ///< in the order of StepReport::reactions
    std::vector<RecordedGauge> gauges = {};      ///< in the order of StepReport::gauges
};

/// A natural mode of vibration of the sheets.
struct RecordedMode {
    double frequency = 0;  ///< Hz; 0: the mode is unstable
    double growth = 0;     ///< 1/s, rate at which an unstable mode grows; 0: it is stable
    Positions shape;       ///< [3, V] 1/sqrt(kg), of which the sum of m |u|^2 is 1

    /// "12.345 Hz", or what an unstable one does.
    std::string words() const;
};

/// Holds the names of a recording and of its index, locked for this program as long as this lives.
struct RecordingOutput {
    /// Throws Error (input) when another program writes one of them, when one exists and not `force`, or when
    /// the folder cannot be written; nothing is left behind then.
    RecordingOutput(const std::filesystem::path& file, bool force);

    OutputLock recording, index;
    bool force;  ///< replace what is there
};

/// Writes a run to an .h5 file and the .xdmf index beside it. Each append is in the .h5 as a whole or not at
/// all (JournaledFile), and the .xdmf is replaced atomically, so both can be read while the run goes on. The
/// .xdmf, which is written as a whole, follows each of the first hundred frames, then each hundredth part
/// more of them, and the last. A mesh at rest is written when it is another one than in the frame before. The
/// layout of the file is in app/README.md. The program must ignore SIGXFSZ, so that a file size limit is an
/// error like a full disk.
class RecordingWriter {
  public:
    /// Creates the file, or, with `resumes`, takes the one that is there, whose state visit_state() and
    /// go_on() then have to put back. Throws Error (input) when it cannot be created; nothing is left behind
    /// then.
    RecordingWriter(RecordingOutput output, const RecordingHeader& header,
                    std::span<const RecordedObstacle> obstacles = {}, bool resumes = false);
    RecordingWriter(const std::filesystem::path& file, const RecordingHeader& header, bool force,
                    std::span<const RecordedObstacle> obstacles = {});

    /// Adds a frame, the steps since the last append, and the events since then. The poses are those of each
    /// obstacle, from its frame to space, the shapes those of obstacles that deform. Throws Error (run) when
    /// the disk is full or the file cannot be written; the file is then as it was before.
    void append(const Snapshot& snapshot, std::span<const StepReport> steps, const CrackEvents& events,
                std::span<const Eigen::Isometry3d> poses = {}, const ObstacleShapes& shapes = {});

    /// Adds the modes that the frames show, whose times then are none of physics: `times` says what they are.
    /// Frames of the first mode have the step 1, and so on. Throws Error (run) as append() does.
    void add_modes(std::span<const RecordedMode> modes, const std::string& times);

    /// Stores how the run ended: its wall time and whether it was complete, interrupted or failed.
    void finish(double wall_seconds, const std::string& end);

    /// What has been recorded so far.
    void visit_state(StateVisitor& visit);
    /// Cuts the file off behind what had been recorded when its state was written down. scene_text: that of
    /// the run that goes on. Throws Error (run) when there is less.
    void go_on(const std::string& scene_text);
    const OutputLock& lock() const { return output.recording; }

  private:
    const std::filesystem::path& file() const { return output.recording.output(); }
    /// Adds the last of `frames`, and what belongs to it.
    void record(const Snapshot& snapshot, std::span<const StepReport> steps, const CrackEvents& events,
                ObstaclePlaces next, const ObstacleShapes& shapes);
    void write_index(PendingFile& index) const;

    RecordingOutput output;
    std::vector<std::size_t> rows;  ///< of each table
    JournaledFile recording;
    std::vector<XdmfFrame> frames;
    std::size_t indexed = 0;  ///< frames in the index
    std::vector<RecordedObstacle> obstacles;
    ObstaclePlaces places;  ///< of the last frame, or their own frames
    std::size_t supports = 0, gauges = 0;
    RestMesh rest;                    ///< of the last frame, or unbroken
    std::string rest_path = "/rest";  ///< where it stands
    std::size_t unbroken_vertices = 0;
};

/// Reads a recording, while it is being written too: each call has it as it was committed last. Every member
/// throws Error (input) when what it reads is damaged, or when the file is not the one any more that was
/// opened at first.
class Recording {
  public:
    /// Opens the recording, and mends it if its writer was killed. Throws Error when the file is missing, not
    /// HDF5, not a recording of ours, or of a version that is not read.
    explicit Recording(const std::filesystem::path& file);

    /// What was mended, for people; "" when it was whole.
    const std::string& mended() const { return mending; }

    RecordingHeader header() const;
    std::size_t frame_count() const;
    Snapshot frame(std::size_t number) const;         ///< number < frame_count()
    FaceFields fields(std::size_t number) const;      ///< of a frame, without the rest of it
    double time(std::size_t number) const;            ///< s, of a frame
    std::vector<RecordedObstacle> obstacles() const;  ///< none in recordings of earlier versions
    std::vector<Eigen::Isometry3d> poses(std::size_t number) const;  ///< of obstacles(), in a frame
    ObstacleShapes shapes(std::size_t number) const;                 ///< likewise
    std::vector<StepReport> steps() const;  ///< with reactions and gauges as header() has them
    bool has_balance() const;               ///< whether steps() have a balance: not of before there was one
    CrackEvents events() const;
    std::vector<RecordedMode> modes() const;  ///< none in the recording of a run
    double wall_seconds() const;              ///< 0 while the run goes on
    std::string end() const;                  ///< "running", "complete", "interrupted" or "failed: ..."

  private:
    /// Opens the file and returns read(opened), with errors that name the file.
    template <class Read>
    auto read_with(Read read) const;

    std::filesystem::path file;
    std::string mending;
    std::int64_t version = 0;
    std::pair<dev_t, ino_t> identity;  ///< a run with --force puts another file in its place
};

}  // namespace sherd
