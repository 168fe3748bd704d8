// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/overlay.h"

#include <algorithm>

#include "meshops/plane.h"

namespace sherd {
namespace {

using Eigen::Vector2d;

/// The part of a convex polygon to the left of the line from a to b.
std::vector<Vector2d> left_part(const std::vector<Vector2d>& polygon, const Vector2d& a, const Vector2d& b) {
    std::vector<Vector2d> part;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vector2d &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const double at_p = cross(b - a, p - a), at_q = cross(b - a, q - a);
        if (at_p >= 0) part.push_back(p);
        if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0))
            part.emplace_back(p + at_p / (at_p - at_q) * (q - p));
    }
    return part;
}

}  // namespace

double common_area(const PlaneTriangle& a, const PlaneTriangle& b) {
    std::vector<Vector2d> part(a.begin(), a.end());
    for (int i = 0; i < 3 && !part.empty(); ++i) part = left_part(part, b[i], b[(i + 1) % 3]);
    double doubled = 0;
    for (std::size_t i = 2; i < part.size(); ++i) doubled += cross(part[i - 1] - part[0], part[i] - part[0]);
    return std::max(doubled, 0.0) / 2;
}

Eigen::MatrixXd covered_fractions(std::span<const PlaneTriangle> now, std::span<const PlaneTriangle> old) {
    constexpr double round_off = 1e-15;
    Eigen::MatrixXd fractions(now.size(), old.size());
    for (std::size_t j = 0; j < old.size(); ++j) {
        for (std::size_t i = 0; i < now.size(); ++i) fractions(i, j) = common_area(now[i], old[j]);
        auto column = fractions.col(static_cast<Eigen::Index>(j));
        column = (column.array() < round_off * column.sum()).select(0, column);
        const double sum = column.sum();
        if (sum > 0)
            column /= sum;
        else
            column.setConstant(1.0 / static_cast<double>(now.size()));
    }
    return fractions;
}

}  // namespace sherd
