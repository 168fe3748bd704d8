// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "meshops/generate/surface.h"

namespace sherd {

/// The surface that a polyline of (r, z) points, the profile, sweeps about the z axis. Its parameters are the
/// arc length s along the profile (m) and the angle about the axis (rad). Its chart has the polar coordinates
/// exp u, with du = ds / r, and the angle, and is conformal. If the first point of the profile is on the
/// axis, it is the origin of the chart; if the last point is, it is at infinity.
class Revolution final : public Surface {
  public:
    /// reach: m; largest distance along the profile, from the parameters `near`, at which project() finds
    /// points.
    Revolution(std::span<const Eigen::Vector2d> profile, double reach);

    Eigen::Vector3d position(const Eigen::Vector2d& parameter) const override;
    Eigen::Vector2d chart(const Eigen::Vector2d& parameter) const override;
    Eigen::Vector2d project(const Eigen::Vector3d& point, const Eigen::Vector2d& near) const override;

    double length() const { return distance.back(); }
    double radius(double along) const { return at(along).x(); }
    bool starts_on_axis() const { return profile.front().x() == 0; }
    bool ends_on_axis() const { return profile.back().x() == 0; }
    /// Returns the area between two arc lengths, m^2.
    double area(double from, double to) const;
    /// Returns the arc lengths (m) of inner points of the profile where it turns by more than `degrees`.
    std::vector<double> corners(double degrees) const;
    /// Returns u at an arc length (m) that is not on the axis.
    double chart_radius(double along) const;
    /// Returns the difference of u between the ends of the profile, without parts that reach the axis.
    double chart_range() const;

  private:
    std::size_t segment(double along) const;
    Eigen::Vector2d at(double along) const;

    std::vector<Eigen::Vector2d> profile;
    std::vector<double> distance;    ///< m, arc length of each profile point
    std::vector<double> log_radius;  ///< u of each profile point; unused for points on the axis
    double reach;
};

/// The part of a surface of revolution, which does not reach the axis, between two angles. Its chart is (u,
/// angle), so that the two sides of the part are straight in the chart.
class RevolutionSector final : public Surface {
  public:
    /// whole: must outlive this object.
    explicit RevolutionSector(const Revolution& whole) : whole(whole) {}

    Eigen::Vector3d position(const Eigen::Vector2d& parameter) const override {
        return whole.position(parameter);
    }
    Eigen::Vector2d chart(const Eigen::Vector2d& parameter) const override;
    Eigen::Vector2d project(const Eigen::Vector3d& point, const Eigen::Vector2d& near) const override;

  private:
    const Revolution& whole;
};

}  // namespace sherd
