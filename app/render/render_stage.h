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
    std::optional<std::pair<double, double>> range;  ///< darkest and brightest value; none: the recording's
    CameraChoice camera;
    bool ground = true;  ///< whether planes are drawn: the scene's, or one below everything if it has none
    double aspect = 16.0 / 9;  ///< width over height of the pictures
};

/// Properties that all pictures of a recording share: camera, ground, and range of the colours. All of them
/// follow from the whole recording, so that pictures of single frames fit together.
class RenderStage {
  public:
    /// Reads every frame. Throws Error (input) if the recording has no frames or no finite positions, if
    /// material axes are to be shown and the scene lacks them, or if crack tips are to be shown and the
    /// recording lacks them.
    RenderStage(const Recording& recording, const StageOptions& options, std::vector<std::string>& warnings);

    /// Returns the content of the picture of a frame. poses, shapes: poses and shapes of the recording's
    /// obstacles in this frame.
    RenderScene scene(const Snapshot& frame, std::span<const Eigen::Isometry3d> poses,
                      const ObstacleShapes& shapes) const;
    /// Centre of the region in focus, m, which is the origin of all positions in scene().
    Vector3d centre() const { return focus.center(); }
    const Camera& camera() const { return placed; }
    /// Returns the planes to be drawn, with the recording's obstacles in these poses; one plane below
    /// everything if the scene has none.
    std::vector<RenderPlane> ground(std::span<const Eigen::Isometry3d> poses) const;
    const Vector3d& upward() const { return up; }
    const Eigen::AlignedBox3d& everything() const { return box; }  ///< m, around the sheets in all frames
    double radius() const;                                         ///< m, half the diagonal of the region in
                                                                   ///< focus
    RenderColour colour() const { return options.colour; }
    double largest() const { return range.second; }  ///< value of the brightest colour
    /// Returns a text that explains the colours; "" if they need no text.
    std::string legend() const;
    /// Returns the colour bar; none unless the colours show a scalar.
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
    bool has_planes() const;  ///< whether there are planes among the recorded obstacles
    SheetPaint paint(const Snapshot& frame) const;
    std::uint32_t scalar_colour(double value) const;  ///< 0xRRGGBB
    RenderMesh tips_of(const Snapshot& frame) const;
    std::vector<double> thickness_of(const Snapshot& frame) const;  ///< [F] m

    StageOptions options;
    RecordingHeader header;
    std::vector<RecordedObstacle> obstacles;
    std::vector<std::string> modes;           ///< text on each mode, if the frames show modes of vibration
    std::optional<Scene> scene_spec;          ///< none: the recorded text cannot be read
    std::optional<double> guessed_thickness;  ///< m; none if the thickness is recorded
    std::vector<Eigen::AlignedBox3d> boxes;   ///< m, boxes to be shown: frames' focus_box(), obstacles
    Eigen::AlignedBox3d focus;                ///< m, around the focus_box() of all frames
    Eigen::AlignedBox3d box;                  ///< m, around the sheets in all frames
    Vector3d up = Vector3d::UnitZ();
    double lowest = 0;                                    ///< m, lowest coordinate along `up`
    double end = 0;                                       ///< s, time of the last frame
    std::pair<double, double> range{0, 0}, extent{0, 0};  ///< range of the colours, range of the values
    std::string scalar_name, scalar_unit;
    std::optional<TipHistory> tips;       ///< crack tips, if they are drawn
    std::optional<SurfacePaint> surface;  ///< paint of the sheets' files, if it is drawn
    Eigen::Matrix3Xd stripes;             ///< [3, F0] axis_stripes() of the material axes
    std::vector<RenderPlane> planes;      ///< planes that are no recorded obstacles
    Camera placed;
};

/// Parses the scene of a recording from the text in its header. Throws Error like read_scene.
Scene recorded_scene(const RecordingHeader& header);

}  // namespace sherd
