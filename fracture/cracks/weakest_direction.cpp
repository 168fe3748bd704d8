// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/cracks/weakest_direction.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "fracture/cracks/tip_stress.h"

namespace sherd {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr int farthest_kink = 75;  // degrees; beyond it the first-order release is wrong by a fifth or more

}  // namespace

void turn_to_weakest(const BreakableShell& shell, const GrowingTip& tip, TipLoad& load) {
    const Vector3d normal = rest_normal_at(shell, Vertex(tip.vertex));
    const bool is_held_straight = !load.by_energy && tip.stride > 0;
    const double least_along = is_held_straight ? std::cos(largest_tip_turn(shell, tip)) : -1;
    double best_ratio = 0, share = 1;
    Vector3d best = load.direction;
    for (int i = -farthest_kink; i <= farthest_kink; ++i) {
        const double kink = i * degree, half = std::cos(0.5 * kink);
        const Vector3d direction = Eigen::AngleAxisd(kink, normal) * load.direction;
        if (i != 0 && direction.dot(tip.direction) < least_along) continue;
        const double ratio = half * half / shell.toughness_towards(Vertex(tip.vertex), direction);
        if (ratio <= best_ratio) continue;
        best_ratio = ratio;
        share = half * half;
        best = direction;
    }
    load.direction = best;
    load.intensity *= share;
}

}  // namespace sherd
