// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/playback/tip_history.h"
#include "app/recording/recording.h"
#include "app/render/legend/colour_bar.h"
#include "app/render/legend/render_colour.h"
#include "app/render/render_solid.h"
#include "app/render/surface_paint.h"
#include "app/render/trace/camera.h"
#include "app/render/trace/render_scene.h"
#include "app/scene/scene.h"

namespace sherd {

struct StageOptions {
    RenderColour colour = RenderColour::fragment;
    std::optional<std::pair<double, double>> range;  ///< range of the colours; none: the recording's
    CameraChoice camera;
    bool ground = true;  ///< whether the scene's planes are drawn, or, without any, one below everything
    double aspect = 16.0 / 9;
};

/// Properties that all pictures of a recording share: camera, ground and the range of the colours, which all
/// follow from the whole recording, so that pictures of single frames fit together.
class RenderStage {
  public:
    /// Reads every frame. Throws Error (input) on a recording without frames or finite positions, and if it
    /// is to show axes that the scene lacks, or crack tips that the recording lacks.
    RenderStage(const Recording& recording, const StageOptions& options, std::vector<std::string>& warnings);

    /// poses, shapes: of the recording's obstacles in that frame.
    RenderScene scene(const Snapshot& frame, std::span<const Eigen::Isometry3d> poses,
                      const ObstacleShapes& shapes) const;
    Vector3d centre() const { return focus.center(); }  ///< m, of the region in focus; origin of positions
    const Camera& camera() const { return placed; }
    /// Planes, in poses of the recording's obstacles; one below everything if the scene has none.
    std::vector<RenderPlane> ground(std::span<const Eigen::Isometry3d> poses) const;
    const Vector3d& upward() const { return up; }
    const Eigen::AlignedBox3d& everything() const { return box; }  ///< m, of the sheets, outliers included
    double radius() const;                                         ///< m, of the region in focus
    RenderColour colour() const { return options.colour; }
    double largest() const { return range.second; }  ///< value of the brightest colour
    /// Text on the colours; "" without one.
    std::string legend() const;
    /// Colour bar, if the colours show a scalar.
    std::optional<ColourBar> colour_bar() const;
    const std::string& time_unit() const { return header.time_unit; }
    std::string caption(const Snapshot& frame) const;  ///< time and step, or the mode of vibration

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
    std::vector<std::string> modes;           ///< text on each mode, if the frames show modes of vibration
    std::optional<Scene> scene_spec;          ///< none: cannot be read any more
    std::optional<double> guessed_thickness;  ///< m; none: the recording has it
    std::vector<Eigen::AlignedBox3d> boxes;   ///< m, in the picture: each frame's focus_box(), and obstacles
    Eigen::AlignedBox3d focus;                ///< m, around focus_box() of all frames
    Eigen::AlignedBox3d box;                  ///< m, of the sheets in all frames
    Vector3d up = Vector3d::UnitZ();
    double lowest = 0;                                    ///< m, lowest coordinate along `up`
    double end = 0;                                       ///< s, time of the last frame
    std::pair<double, double> range{0, 0}, extent{0, 0};  ///< ranges of the colours, and of the values
    std::string scalar_name, scalar_unit;
    std::optional<TipHistory> tips;       ///< crack tips, if they are drawn
    std::optional<SurfacePaint> surface;  ///< paint of the sheets' files, if it is drawn
    Eigen::Matrix3Xd stripes;             ///< [3, F0] of material axes, at corners of the unfractured mesh
    std::vector<RenderPlane> planes;      ///< planes that are no recorded obstacles
    Camera placed;
};

/// Parses the scene of a recording, from the text in it. Throws Error like read_scene.
Scene recorded_scene(const RecordingHeader& header);

}  // namespace sherd
