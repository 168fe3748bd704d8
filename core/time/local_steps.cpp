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
Vector3d angular_acceleration(const Vector3d& torque, const Matrix3d& inertia) {
    const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(inertia);
    Vector3d along = axes.eigenvectors().transpose() * torque;
    for (int i = 0; i < 3; ++i) {
        const double moment = axes.eigenvalues()[i];
        along[i] = moment > thinnest * axes.eigenvalues()[2] ? along[i] / moment : 0;
    }
    return axes.eigenvectors() * along;
}

}  // namespace

/// Data of a search for forces that its levels share.
struct LocalSteps::Search {
    double length;  ///< s, of the substep
    const Positions& others;
    Positions& elastic;
};

bool LocalSteps::set_levels(std::vector<Level> levels) {
    if (levels == of_vertices) return false;
    of_vertices = std::move(levels);
    restore();
    return true;
}

void LocalSteps::restore() {
    gradient.set_levels(of_vertices);
    vertices = LevelOrder(of_vertices);
    means.resize(highest());
    places.resize(highest());
    groups.reset();
}

void LocalSteps::find(const Positions& x, double length, const Positions& others, Positions& elastic) {
    gradient.find(x);
    gradient.put_forces(elastic);
    if (highest() == 0) return;
    if (!groups) find_groups();
    plain = elastic;
    average(0, {length, others, elastic});
    correct_torques(x, elastic);
}

void LocalSteps::average(int level, const Search& search) {
    if (level == highest()) return;
    const int finer = level + 1;
    average(finer, search);
    const std::span<const Index> moving = vertices.of_level(finer), affected = gradient.affected(finer);
    Positions &mean = means[level], &place = places[level];
    mean.resize(3, static_cast<Eigen::Index>(affected.size()));
    for (std::size_t i = 0; i < affected.size(); ++i) mean.col(i) = search.elastic.col(affected[i]);
    place.resize(3, static_cast<Eigen::Index>(moving.size()));
    const double of_finer = search.length / (1 << finer);
    const double factor = 0.5 * (1 + stabilization) * of_finer * of_finer;
    for (std::size_t i = 0; i < moving.size(); ++i) {
        const Index v = moving[i];
        place.col(i) = gradient.position(v);
        const Vector3d force = search.elastic.col(v) + search.others.col(v);
        gradient.move(v, place.col(i) + constrained(shell, v, factor / shell.mass[v] * force));
    }
    gradient.find_again(finer);
    gradient.put_forces_again(finer, search.elastic);
    average(finer, search);
    for (std::size_t i = 0; i < affected.size(); ++i) {
        auto force = search.elastic.col(affected[i]);
        force = 0.5 * (mean.col(i) + force);
    }
    for (std::size_t i = 0; i < moving.size(); ++i) gradient.move(moving[i], place.col(i));
}

void LocalSteps::find_groups() {
    groups.emplace();
    std::vector<char> is_affected(shell.mass.size(), 0);
    for (const Index v : gradient.affected(1)) is_affected[v] = 1;
    const std::vector<Index> group_of = groups_among(shell, is_affected).of_vertex;
    std::map<Index, std::vector<Index>> by_number;
    for (Index v = 0; v < static_cast<Index>(group_of.size()); ++v)
        if (group_of[v] >= 0) by_number[group_of[v]].push_back(v);
    const auto is_held = [this](Index v) { return shell.fixed[v] != 0 || shell.guide[v] != 0; };
    for (const auto& [number, group] : by_number)
        if (std::ranges::none_of(group, is_held)) groups->push_back(group);
}

void LocalSteps::correct_torques(const Positions& x, Positions& elastic) const {
    for (const std::vector<Index>& group : *groups) {
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
        const Vector3d turn = angular_acceleration(torque, inertia);
        for (const Index v : group) elastic.col(v) -= shell.mass[v] * turn.cross(Vector3d(x.col(v) - centre));
    }
}

}  // namespace sherd
