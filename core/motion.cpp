// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion.h"

#include <algorithm>
#include <cmath>

namespace sherd {
namespace {

constexpr double same_axis = 1e-12;  // sine of the angle below which two axes count as the same

Eigen::Quaterniond rotation(const MotionKey& key) {
    return Eigen::Quaterniond(Eigen::AngleAxisd(key.angle, key.axis));
}

Eigen::Quaterniond rotation(const MotionKey& a, const MotionKey& b, double s) {
    if (a.angle == 0) return Eigen::Quaterniond(Eigen::AngleAxisd(s * b.angle, b.axis));
    if (b.angle == 0) return Eigen::Quaterniond(Eigen::AngleAxisd((1 - s) * a.angle, a.axis));
    if (a.axis.cross(b.axis).norm() > same_axis) return rotation(a).slerp(s, rotation(b));
    const double end = a.axis.dot(b.axis) < 0 ? -b.angle : b.angle;
    return Eigen::Quaterniond(Eigen::AngleAxisd(a.angle + s * (end - a.angle), a.axis));
}

/// Angle of the rotation between two keys, rad.
double turn(const MotionKey& a, const MotionKey& b) {
    if (a.angle == 0 || b.angle == 0) return std::abs(a.angle + b.angle);
    if (a.axis.cross(b.axis).norm() > same_axis) return rotation(a).angularDistance(rotation(b));
    return std::abs((a.axis.dot(b.axis) < 0 ? -b.angle : b.angle) - a.angle);
}

/// Share of the motion from key `a` to key `b` that is complete at `time` (s).
double share_of_way(const MotionKey& a, const MotionKey& b, double time, bool smooth) {
    const double s = b.time > a.time ? std::clamp((time - a.time) / (b.time - a.time), 0.0, 1.0) : 0;
    return smooth ? s * s * (3 - 2 * s) : s;
}

}  // namespace

double Motion::turn_between(double from, double to) const {
    double sum = 0;
    for (std::size_t k = 1; k < keys.size(); ++k) {
        const MotionKey &a = keys[k - 1], &b = keys[k];
        sum += turn(a, b) * (share_of_way(a, b, to, smooth) - share_of_way(a, b, from, smooth));
    }
    return sum;
}

int straight_parts(double turn) {
    constexpr double turn_of_part = 0.25, most = 4096;
    return static_cast<int>(std::clamp(std::ceil(turn / turn_of_part), 1.0, most));
}

Eigen::Isometry3d Motion::at(double time) const {
    if (keys.empty()) return place;
    const auto later = [](double moment, const MotionKey& key) { return moment < key.time; };
    const auto next = std::upper_bound(keys.begin(), keys.end(), time, later);
    const MotionKey& a = next == keys.begin() ? keys.front() : *(next - 1);
    const MotionKey& b = next == keys.end() ? keys.back() : *next;
    const double s = share_of_way(a, b, time, smooth);
    Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
    moved.linear() = rotation(a, b, s).toRotationMatrix();
    moved.translation() =
        pivot - moved.linear() * pivot + a.translation + s * (b.translation - a.translation);
    return moved * place;
}

}  // namespace sherd
