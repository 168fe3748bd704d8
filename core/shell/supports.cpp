// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shell/supports.h"

namespace sherd {

void constrain(const Sheet& sheet, Positions& displacement) {
    for (std::size_t v = 0; v < sheet.fixed.size(); ++v) {
        if (sheet.fixed[v])
            displacement.col(v).setZero();
        else if (sheet.guide[v] != 0)
            displacement.col(v) = sheet.guides[sheet.guide[v] - 1] * displacement.col(v).eval();
    }
}

void place_carried(const Sheet& sheet, double time, Positions& x) {
    std::vector<Eigen::Isometry3d> poses;
    for (const Motion& motion : sheet.motions) poses.push_back(motion.at(time));
    for (std::size_t v = 0; v < sheet.carrier.size(); ++v)
        if (sheet.carrier[v] != 0) x.col(v) = poses[sheet.carrier[v] - 1] * Vector3d(sheet.rest.col(v));
}

Positions carried_part(const Sheet& sheet, const Positions& displacement) {
    Positions carried = displacement;
    for (std::size_t v = 0; v < sheet.carrier.size(); ++v)
        if (sheet.carrier[v] == 0) carried.col(v).setZero();
    return carried;
}

}  // namespace sherd
