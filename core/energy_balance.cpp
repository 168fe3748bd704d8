// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/energy_balance.h"

#include "core/vector.h"

namespace sherd {

EnergyBalance& EnergyBalance::operator+=(const EnergyBalance& other) {
    for (const auto part : balance_parts) this->*part += other.*part;
    return *this;
}

void EnergyBalance::take(double EnergyBalance::*part, double against) {
    const bool loses = part == &EnergyBalance::lost_to_friction || part == &EnergyBalance::lost_to_damping ||
                       part == &EnergyBalance::lost_to_cracks || part == &EnergyBalance::lost_to_remeshing ||
                       part == &EnergyBalance::lost_to_yield || part == &EnergyBalance::lost_to_scheme;
    this->*part += loses ? against : -against;
}

double work(const Reaction& forces, const Eigen::Isometry3d& from, const Eigen::Isometry3d& to) {
    const Eigen::Isometry3d back = from * to.inverse();
    const Matrix3d turn = back.linear().transpose() - back.linear();
    const Vector3d rotation = 0.5 * Vector3d(turn(2, 1), turn(0, 2), turn(1, 0));
    return forces.moment.dot(rotation) - forces.force.dot(back.translation());
}

}  // namespace sherd
