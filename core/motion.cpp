// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/motion.h"

#include <algorithm>

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

}  // namespace

Eigen::Isometry3d Motion::at(double time) const {
    if (keys.empty()) return place;
    const auto later = [](double moment, const MotionKey& key) { return moment < key.time; };
    const auto next = std::upper_bound(keys.begin(), keys.end(), time, later);
    const MotionKey& a = next == keys.begin() ? keys.front() : *(next - 1);
    const MotionKey& b = next == keys.end() ? keys.back() : *next;
    double s = b.time > a.time ? (time - a.time) / (b.time - a.time) : 0;
    if (smooth) s *= s * (3 - 2 * s);
    Eigen::Isometry3d moved = Eigen::Isometry3d::Identity();
    moved.linear() = rotation(a, b, s).toRotationMatrix();
    moved.translation() =
        pivot - moved.linear() * pivot + a.translation + s * (b.translation - a.translation);
    return moved * place;
}

}  // namespace sherd
