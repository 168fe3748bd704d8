// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time/local_steps.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <map>

#include "core/shell/pieces.h"
#include "core/shell/supports.h"

namespace sherd {
namespace {

/// Smallest principal moment of inertia, over the largest, about which a group can be turned.
constexpr double thinnest = 1e-9;

/// The angular acceleration, 1/s^2, that a torque (N m) gives to points with this inertia tensor (kg m^2).
Vector3d turned_by(const Vector3d& torque, const Matrix3d& inertia) {
    const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(inertia);
    Vector3d along = axes.eigenvectors().transpose() * torque;
    for (int i = 0; i < 3; ++i) {
        const double moment = axes.eigenvalues()[i];
        along[i] = moment > thinnest * axes.eigenvalues()[2] ? along[i] / moment : 0;
    }
    return axes.eigenvectors() * along;
}

}  // namespace

/// The data of a search for forces.
struct LocalSteps::Part {
    double length;  ///< s, of the substep
    const Positions& x;
    const Positions& others;
    Positions& elastic;
};

void LocalSteps::set_levels(const std::vector<Level>& levels) {
    gradient.set_levels(levels);
    vertices = LevelOrder(levels);
    highest_level = levels.empty() ? Level{0} : *std::ranges::max_element(levels);
    means.resize(highest_level);
    places.resize(highest_level);
    has_groups = false;
}

void LocalSteps::find(const Positions& x, double length, const Positions& others, Positions& elastic) {
    gradient.find(x);
    elastic.resize(3, x.cols());
    gradient.put_forces(0, static_cast<Index>(x.cols()), elastic);
    if (highest_level == 0) return;
    if (!has_groups) find_groups();
    plain = elastic;
    average(0, {length, x, others, elastic});
    correct_torques(x, elastic);
}

void LocalSteps::average(int level, const Part& part) {
    if (level == highest_level) return;
    const int finer = level + 1;
    average(finer, part);
    const std::span<const Index> moving = vertices.of_level(finer), affected = gradient.affected(finer);
    Positions &mean = means[level], &place = places[level];
    mean.resize(3, static_cast<Eigen::Index>(affected.size()));
    for (std::size_t i = 0; i < affected.size(); ++i) mean.col(i) = part.elastic.col(affected[i]);
    place.resize(3, static_cast<Eigen::Index>(moving.size()));
    const double of_finer = part.length / (1 << finer);
    const double factor = 0.5 * (1 + stabilization) * of_finer * of_finer;
    for (std::size_t i = 0; i < moving.size(); ++i) {
        const Index v = moving[i];
        place.col(i) = gradient.position(v);
        const Vector3d force = part.elastic.col(v) + part.others.col(v);
        gradient.move(v, place.col(i) + constrained(shell, v, factor / shell.mass[v] * force));
    }
    gradient.find_again(finer);
    gradient.put_forces_again(finer, part.elastic);
    average(finer, part);
    for (std::size_t i = 0; i < affected.size(); ++i) {
        auto force = part.elastic.col(affected[i]);
        force = 0.5 * (mean.col(i) + force);
    }
    for (std::size_t i = 0; i < moving.size(); ++i) gradient.move(moving[i], place.col(i));
}

void LocalSteps::find_groups() {
    has_groups = true;
    groups.clear();
    std::vector<char> is_affected(shell.mass.size(), 0);
    for (const Index v : gradient.affected(1)) is_affected[v] = 1;
    const std::vector<Index> group_of = groups_among(shell, is_affected).of_vertex;
    std::map<Index, std::vector<Index>> by_number;
    for (Index v = 0; v < static_cast<Index>(group_of.size()); ++v)
        if (group_of[v] >= 0) by_number[group_of[v]].push_back(v);
    const auto is_held = [this](Index v) { return shell.fixed[v] != 0 || shell.guide[v] != 0; };
    for (const auto& [number, group] : by_number)
        if (std::ranges::none_of(group, is_held)) groups.push_back(group);
}

void LocalSteps::correct_torques(const Positions& x, Positions& elastic) const {
    for (const std::vector<Index>& group : groups) {
        double mass = 0;
        Vector3d centre = Vector3d::Zero(), torque = Vector3d::Zero();
        for (const Index v : group) {
            mass += shell.mass[v];
            centre += shell.mass[v] * x.col(v);
        }
        centre /= mass;
        Matrix3d inertia = Matrix3d::Zero();
        for (const Index v : group) {
            const Vector3d arm = x.col(v) - centre;
            torque += arm.cross(Vector3d(elastic.col(v) - plain.col(v)));
            inertia += shell.mass[v] * (arm.squaredNorm() * Matrix3d::Identity() - arm * arm.transpose());
        }
        const Vector3d turn = turned_by(torque, inertia);
        for (const Index v : group) elastic.col(v) -= shell.mass[v] * turn.cross(Vector3d(x.col(v) - centre));
    }
}

}  // namespace sherd
