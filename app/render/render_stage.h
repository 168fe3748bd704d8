// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/playback/tip_history.h"
#include "app/recording/recording.h"
#include "app/render/camera.h"
#include "app/render/colour_bar.h"
#include "app/render/render_colour.h"
#include "app/render/render_scene.h"
#include "app/render/render_solid.h"
#include "app/render/surface_paint.h"
#include "app/scene/scene.h"

namespace sherd {

struct StageOptions {
    RenderColour colour = RenderColour::fragment;
    std::optional<std::pair<double, double>> range;  ///< of the scalar's colours; none: that of the recording
    CameraChoice camera;
    bool ground = true;  ///< the scene's planes; without any, one below everything
    double aspect = 16.0 / 9;
};

/// What stays the same in all pictures of a recording: camera, ground and the range of the colours, which all
/// follow from the whole recording, so that pictures of single frames fit together.
class RenderStage {
  public:
    /// Looks at every frame. Throws Error (input) on a recording without frames or finite positions, and when
    /// axes are wanted that the scene has not, or tips of cracks that the recording has not.
    RenderStage(const Recording& recording, const StageOptions& options, std::vector<std::string>& warnings);

    /// poses, shapes: of the recording's obstacles in that frame.
    RenderScene scene(const Snapshot& frame, std::span<const Eigen::Isometry3d> poses,
                      const ObstacleShapes& shapes) const;
    Vector3d centre() const { return focus.center(); }  ///< m, of the action, from which the rest is seen
    const Camera& camera() const { return placed; }
    /// Planes, from poses of the recording's obstacles; one below everything when the scene has none.
    std::vector<RenderPlane> ground(std::span<const Eigen::Isometry3d> poses) const;
    const Vector3d& upward() const { return up; }
    const Eigen::AlignedBox3d& everything() const { return box; }  ///< m, strays of the action, too
    double radius() const;                                         ///< m, of the action
    RenderColour colour() const { return options.colour; }
    double largest() const { return range.second; }  ///< what the brightest colour stands for
    /// What the colours say, in words; empty when there is nothing to say.
    std::string legend() const;
    /// What the colours mean, when they are those of numbers.
    std::optional<ColourBar> colour_bar() const;
    const std::string& time_unit() const { return header.time_unit; }
    std::string caption(const Snapshot& frame) const;  ///< its time and step, or its mode of vibration

  private:
    void read_scene(std::vector<std::string>& warnings);
    void find_thickness(std::vector<std::string>& warnings);
    void measure(const Recording& recording);
    void measure_scalar(RenderScalar scalar);
    void measure_tips(const Recording& recording);
    void measure_obstacles(const Recording& recording);
    void add_ground();
    bool has_planes() const;  ///< whether the recording has the scene's planes, if there are any
    SheetPaint paint(const Snapshot& frame) const;
    std::uint32_t scalar_colour(double value) const;  ///< 0xRRGGBB
    RenderMesh tips_of(const Snapshot& frame) const;
    std::vector<double> thickness_of(const Snapshot& frame) const;  ///< [F] m

    StageOptions options;
    RecordingHeader header;
    std::vector<RecordedObstacle> obstacles;
    std::vector<std::string> modes;           ///< words of each, if the frames show modes of vibration
    std::optional<Scene> scene_spec;          ///< none: it cannot be read any more
    std::optional<double> guessed_thickness;  ///< m; none: the recording says it
    std::vector<Eigen::AlignedBox3d> boxes;   ///< m, that the camera shows: in each frame, and obstacles
    Eigen::AlignedBox3d focus;                ///< m, of the action: of focus_box() in all frames
    Eigen::AlignedBox3d box;                  ///< m, of the sheets in all frames
    Vector3d up = Vector3d::UnitZ();
    double lowest = 0;                                    ///< m, along up
    double end = 0;                                       ///< s, time of the last frame
    std::pair<double, double> range{0, 0}, extent{0, 0};  ///< of the colours, of the values
    std::string scalar_name, scalar_unit;
    std::optional<TipHistory> tips;       ///< that are drawn
    std::optional<SurfacePaint> surface;  ///< that is drawn
    Eigen::Matrix3Xd stripes;             ///< [3, F0] of the material's axes, at corners of the unbroken mesh
    std::vector<RenderPlane> planes;      ///< that are no recorded obstacles
    Camera placed;
};

/// The scene of a recording, from the text that it keeps. Throws Error like read_scene.
Scene recorded_scene(const RecordingHeader& header);

}  // namespace sherd
