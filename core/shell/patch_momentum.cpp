// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/shell/patch_momentum.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace sherd {
namespace {

/// Momentum of some vertices: sums about a reference point, and the angular momentum about their centre of
/// mass.
struct Momentum {
    double mass = 0;                                                 ///< kg
    Vector3d moment = Vector3d::Zero();                              ///< kg m, first moment of mass
    Vector3d linear = Vector3d::Zero(), angular = Vector3d::Zero();  ///< kg m/s; kg m^2/s

    void add(double of_vertex, const Vector3d& arm, const Vector3d& velocity) {
        mass += of_vertex;
        moment += of_vertex * arm;
        linear += of_vertex * velocity;
        angular += of_vertex * arm.cross(velocity);
    }
    Vector3d centre() const { return moment / mass; }
    Vector3d spin() const { return angular - centre().cross(linear); }  ///< kg m^2/s, about the centre
};

/// Angular velocity of a body of this inertia and angular momentum, rad/s; zero about axes without inertia.
Vector3d spin_of(const Matrix3d& inertia, const Vector3d& angular) {
    constexpr double none = 1e-12;  // share of the largest principal moment
    Eigen::SelfAdjointEigenSolver<Matrix3d> principal(inertia);
    Vector3d spin = principal.eigenvectors().transpose() * angular;
    for (int i = 0; i < 3; ++i) {
        const double moment = principal.eigenvalues()[i];
        spin[i] = moment > none * principal.eigenvalues()[2] ? spin[i] / moment : 0;
    }
    return principal.eigenvectors() * spin;
}

/// The rigid motion with which a patch has the momentum `linear`, and `angular` about its centre of mass
/// `middle`.
struct RigidMotion {
    Vector3d middle, velocity, spin;

    RigidMotion(const Shell& shell, std::span<const Index> patch, const Positions& position,
                const Vector3d& middle, const Vector3d& linear, const Vector3d& angular)
        : middle(middle) {
        double mass = 0;
        Matrix3d inertia = Matrix3d::Zero();
        for (const Index v : patch) {
            const Matrix3d arm = cross_matrix(position.col(v) - middle);
            mass += shell.mass[v];
            inertia -= shell.mass[v] * arm * arm;
        }
        velocity = linear / mass;
        spin = spin_of(inertia, angular);
    }
    Vector3d at(const Vector3d& place) const { return velocity + spin.cross(place - middle); }
};

Vector3d centre_of(const Shell& shell, std::span<const Index> vertices, const Positions& position) {
    Vector3d sum = Vector3d::Zero();
    double mass = 0;
    for (const Index v : vertices) {
        sum += shell.mass[v] * position.col(v);
        mass += shell.mass[v];
    }
    return sum / mass;
}

}  // namespace

void follow_in_motion(const Shell& shell, const ShellChange& change, Positions& position,
                      Positions& velocity) {
    const Positions place = position, before = velocity;
    follow(position, change);
    follow(velocity, change);
    std::vector<Index> patch;
    for (const auto& [vertex, mass] : change.weights) patch.push_back(vertex);
    if (patch.empty()) return;
    for (const IndexWithParents& inserted : change.vertices) patch.push_back(inserted.element);
    const Vector3d middle = centre_of(shell, patch, position);
    Momentum then, now;  // sums about `middle`
    for (const auto& [vertex, mass] : change.weights)
        then.add(mass, place.col(vertex) - middle, before.col(vertex));
    for (const Index v : patch) now.add(shell.mass[v], position.col(v) - middle, velocity.col(v));
    const Vector3d linear = then.linear - now.linear;
    const Vector3d angular = then.spin() - now.spin() + now.centre().cross(linear);
    const RigidMotion lacking(shell, patch, position, middle, linear, angular);
    for (const Index v : patch)
        if (shell.fixed[v] == 0 && shell.guide[v] == 0) velocity.col(v) += lacking.at(position.col(v));
}

}  // namespace sherd
