// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/generate/revolution.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace sherd {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Returns the integral of ds / r along a straight segment of `length` (m) from radius `from` to radius `to`
/// (m).
double chart_length(double from, double to, double length) {
    const double ratio = (to - from) / from;
    return std::abs(ratio) < 1e-9 ? length / from : length / (to - from) * std::log1p(ratio);
}

}  // namespace

Revolution::Revolution(std::span<const Vector2d> profile, double reach)
    : profile(profile.begin(), profile.end()), distance(1, 0.0), log_radius(1, 0.0), reach(reach) {
    for (std::size_t i = 1; i < profile.size(); ++i) {
        const double piece = (profile[i] - profile[i - 1]).norm();
        const bool is_on_axis = profile[i].x() == 0 || profile[i - 1].x() == 0;
        distance.push_back(distance.back() + piece);
        const double du = is_on_axis ? 0 : chart_length(profile[i - 1].x(), profile[i].x(), piece);
        log_radius.push_back(log_radius.back() + du);
    }
    // With u = 0 in the middle of the profile, the coordinates exp u do not overflow.
    const double middle = log_radius.back() / 2;
    for (double& u : log_radius) u -= middle;
}

std::size_t Revolution::segment(double along) const {
    const auto next = std::upper_bound(distance.begin() + 1, distance.end() - 1, along);
    return static_cast<std::size_t>(next - distance.begin()) - 1;
}

Vector2d Revolution::at(double along) const {
    const std::size_t i = segment(along);
    if (along == distance[i + 1]) return profile[i + 1];
    const double part = (along - distance[i]) / (distance[i + 1] - distance[i]);
    return profile[i] + part * (profile[i + 1] - profile[i]);
}

Vector3d Revolution::position(const Vector2d& parameter) const {
    const Vector2d place = at(parameter.x());
    return {place.x() * std::cos(parameter.y()), place.x() * std::sin(parameter.y()), place.y()};
}

double Revolution::chart_radius(double along) const {
    const std::size_t i = segment(along);
    const double r = at(along).x();
    if (profile[i].x() > 0) return log_radius[i] + chart_length(profile[i].x(), r, along - distance[i]);
    return log_radius[i + 1] - chart_length(r, profile[i + 1].x(), distance[i + 1] - along);
}

Vector2d Revolution::chart(const Vector2d& parameter) const {
    if (at(parameter.x()).x() == 0) return Vector2d::Zero();
    return std::exp(chart_radius(parameter.x())) * Vector2d(std::cos(parameter.y()), std::sin(parameter.y()));
}

Vector2d RevolutionSector::chart(const Vector2d& parameter) const {
    return {whole.chart_radius(parameter.x()), parameter.y()};
}

Vector2d RevolutionSector::project(const Vector3d& point, const Vector2d& near) const {
    Vector2d found = whole.project(point, near);
    found.y() += 2 * std::numbers::pi * std::round((near.y() - found.y()) / (2 * std::numbers::pi));
    return found;
}

Vector2d Revolution::project(const Vector3d& point, const Vector2d& near) const {
    const Vector2d place(std::hypot(point.x(), point.y()), point.z());
    double least = std::numeric_limits<double>::infinity(), nearest = near.x();
    const std::size_t last = segment(near.x() + reach);
    for (std::size_t i = segment(near.x() - reach); i <= last; ++i) {
        const Vector2d side = profile[i + 1] - profile[i];
        const double part = std::clamp((place - profile[i]).dot(side) / side.squaredNorm(), 0.0, 1.0);
        const double gap = (profile[i] + part * side - place).squaredNorm();
        if (gap >= least) continue;
        least = gap;
        nearest = distance[i] + part * (distance[i + 1] - distance[i]);
    }
    return {nearest, std::atan2(point.y(), point.x())};
}

double Revolution::area(double from, double to) const {
    double result = 0;
    for (std::size_t i = segment(from); i <= segment(to); ++i) {
        const double begin = std::max(from, distance[i]), end = std::min(to, distance[i + 1]);
        result += std::numbers::pi * (radius(begin) + radius(end)) * (end - begin);
    }
    return result;
}

std::vector<double> Revolution::corners(double degrees) const {
    std::vector<double> result;
    const double limit = std::cos(degrees * std::numbers::pi / 180);
    for (std::size_t i = 1; i + 1 < profile.size(); ++i) {
        const Vector2d before = (profile[i] - profile[i - 1]).normalized();
        const Vector2d after = (profile[i + 1] - profile[i]).normalized();
        if (before.dot(after) < limit) result.push_back(distance[i]);
    }
    return result;
}

double Revolution::chart_range() const {
    return log_radius.back() - log_radius.front();
}

}  // namespace sherd
