// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "app/export/export.h"
#include "app/export/export_obstacles.h"
#include "app/playback/playback.h"
#include "app/recording/recording.h"
#include "meshops/read_write/write_mesh.h"

namespace sherd {

/// A file to be written. `content` returns its content. If a library needs a path instead, `write` is set,
/// and writes the content to the temporary file whose path it is given.
struct ExportJob {
    std::filesystem::path file;
    std::function<std::string()> content;
    std::function<void(const std::filesystem::path&)> write = nullptr;
};

/// Recording to be exported: the chosen frames as surfaces, and the names of their files.
class ExportSource {
  public:
    /// Opens the recording. extension: extension of a file in options.output; all_frames: whether all frames
    /// are selected by default, instead of the last one. Throws Error (input) on a bad recording, selection
    /// of frames or output.
    ExportSource(const ExportOptions& options, const std::string& extension, bool all_frames);

    const std::vector<std::size_t>& frames() const { return chosen; }  ///< ascending, at least one
    std::vector<double> times() const;                                 ///< s, of frames()
    Pace pace() const;                                                 ///< speed at which frames() are shown
    /// Returns a frame, and keeps it until another frame is requested. Throws Error (run) on interrupted().
    const Snapshot& frame(std::size_t number);
    /// Returns the thickness of each face of a frame, m. Throws Error (input) if neither the recording nor
    /// the options have one.
    std::vector<double> thickness(const Snapshot& frame) const;

    /// Returns the sheets in a frame as they are to be written, as solids if the options ask for it; groups
    /// are fragments. Keeps the result until another frame is requested. Adds a warning for each fragment
    /// whose body is not closed or intersects itself.
    const TriangleSheet& sheet(std::size_t number);

    /// Whether the sheets have materials: their own or, if solids have texture coordinates, a material of the
    /// crack faces.
    bool has_materials() const { return with_materials; }

    /// Returns the obstacles and free bodies that are to be written; none with ExportOptions::sheets_only.
    const std::vector<ExportObstacle>& obstacles() const { return solids; }
    /// Returns, for each of obstacles(), the motion from its own coordinates to space, at a moment or in a
    /// frame. Throws Error (run) on interrupted().
    std::vector<Eigen::Isometry3d> poses(const PlaybackTime& moment) const;
    std::vector<Eigen::Isometry3d> poses(std::size_t frame) const;
    /// Returns the points in space of each obstacle that deforms, in a frame.
    ObstacleShapes shapes(std::size_t frame) const;
    /// Returns the i-th of obstacles() in its place in space, in a frame or at a moment.
    TriangleSheet obstacle(std::size_t i, std::size_t frame) const;
    TriangleSheet obstacle(std::size_t i, const PlaybackTime& moment) const;
    /// Returns the end of the names of an obstacle's files: "_obstacle_ram.ply".
    std::string obstacle_suffix(std::size_t i, const std::string& extension) const;

    /// Returns NAME followed by the extension, for a file of all frames.
    std::filesystem::path clip_file(const std::string& extension) const;
    /// Returns the name of a file of one frame: numbered_file(), as NAME_000007.ply, but clip_file() if there
    /// is a single frame and options.output is the name of a file.
    std::filesystem::path frame_file(std::size_t frame, const std::string& extension) const;
    std::filesystem::path numbered_file(std::size_t frame, const std::string& extension) const;

    const ExportOptions options;
    std::vector<std::string> warnings;  ///< messages for the user at the end
    std::string pace_text;              ///< speed at which the run is shown; may be empty

  private:
    void check_bodies(std::size_t number);

    Recording recording;
    std::vector<std::size_t> chosen;
    std::vector<ExportObstacle> solids;
    ObstaclePlayback playback;
    std::filesystem::path stem;  ///< path of the files without number and extension
    bool single = false, with_materials = false;
    std::optional<std::size_t> loaded, made;  ///< number of the frame in `current`, and in `current_sheet`
    Snapshot current;
    TriangleSheet current_sheet;
};

}  // namespace sherd
