// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/bodies/surface_pairs.h"

#include <Eigen/Eigenvalues>

#include "core/contact/bodies/point_contacts.h"

namespace sherd {
namespace {

/// How far inside a body the surface is that makes pairs: of its smallest extent, and of a ball's radius.
constexpr double inset_of_extent = 0.01, inset_of_radius = 0.5;
/// Of the inset, where pairs become active: a ball's are far from where its surface touches.
constexpr double range_of_inset = 1, range_of_ball = 0.25;
constexpr double largest_inset = 3;  // times the inset, of the point of a needle
/// A sheet meets a collider's surface at a quarter of its thickness (ContactSurface).
constexpr double thickness_of_range = 4;

/// The displacements of points that move all triangles inward by one: exactly where three planes or fewer
/// meet, else as nearly as may be.
Positions inward(const ColliderSurface& surface) {
    std::vector<Matrix3d> squares(surface.size(), Matrix3d::Zero());
    Positions sums = Positions::Zero(3, surface.size());
    for (const auto& [a, b, c] : surface.triangles) {
        const Vector3d p = surface.points.col(a), q = surface.points.col(b), r = surface.points.col(c);
        const Vector3d normal = (q - p).cross(r - p).normalized();
        if (!normal.allFinite()) continue;
        for (const Index v : {a, b, c}) {
            squares[v] += normal * normal.transpose();
            sums.col(v) -= normal;
        }
    }
    for (Index v = 0; v < surface.size(); ++v) {
        const Eigen::SelfAdjointEigenSolver<Matrix3d> planes(squares[v]);
        Vector3d moved = Vector3d::Zero();
        for (int i = 0; i < 3; ++i) {
            const Vector3d along = planes.eigenvectors().col(i);
            if (planes.eigenvalues()[i] > 1e-2 * planes.eigenvalues()[2])
                moved += along * along.dot(sums.col(v)) / planes.eigenvalues()[i];
        }
        sums.col(v) = moved * std::min(1.0, largest_inset / moved.norm());
    }
    return sums;
}

std::unique_ptr<Shell> core_of(const RigidBody& body, double inset, double range) {
    const ColliderSurface& surface = *body.surface;
    auto core = std::make_unique<Shell>();
    resize_vertices(*core, surface.size());
    core->rest = surface.points + inset * inward(surface);
    core->position = core->rest;
    core->thickness.setConstant(thickness_of_range * range);
    core->young.setConstant(body.young);
    core->footprint = surface.footprint;
    for (const auto& triangle : surface.triangles) {
        const Vector3d a = surface.points.col(triangle[0]), b = surface.points.col(triangle[1]),
                       c = surface.points.col(triangle[2]);
        core->triangles.emplace_back().vertices = triangle;
        core->triangles.back().membrane.area = 0.5 * (b - a).cross(c - a).norm();
    }
    return core;
}

double extent_of(const RigidBody& body) {
    return body.shape->bounds().sizes().minCoeff();
}

std::unique_ptr<Shell> core_of(const RigidBody& body) {
    const double inset =
        is_ball(body) ? inset_of_radius * body.contact_radius : inset_of_extent * extent_of(body);
    return core_of(body, inset, (is_ball(body) ? range_of_ball : range_of_inset) * inset);
}

}  // namespace

SurfacePairs::SurfacePairs(std::size_t body, const RigidBody& one, std::size_t other, const Collider& two,
                           bool springs)
    : body(body),
      other(other),
      stiffness(one.point_stiffness(two)),
      friction(friction_between(one, two)),
      of_body(extent_of(one)),
      second(two.surface),
      core(core_of(one)),
      near(ContactSurface(*core, {{second.get(), two.young, 0, {}, 0}}, false, springs)) {}

Positions SurfacePairs::seen(const Eigen::Isometry3d& here, const Eigen::Isometry3d& there) const {
    Positions all(3, second->size() + core->rest.cols());
    all << second->points, (there.inverse() * here) * core->rest;
    return all;
}

PairPositions SurfacePairs::in_space(const std::array<Index, 4>& vertices, const Eigen::Isometry3d& here,
                                     const Eigen::Isometry3d& there) const {
    PairPositions at;
    for (int i = 0; i < 4; ++i)
        at.col(i) = vertices[i] < first() ? there * Vector3d(second->points.col(vertices[i]))
                                          : here * Vector3d(core->rest.col(vertices[i] - first()));
    return at;
}

double SurfacePairs::free_way(const Eigen::Isometry3d& here, const Eigen::Isometry3d& there,
                              const Eigen::Isometry3d& here_then, const Eigen::Isometry3d& there_then) const {
    const Eigen::Isometry3d before = there.inverse() * here, after = there_then.inverse() * here_then;
    if (before.matrix() == after.matrix()) return 1;
    const double angle = Eigen::AngleAxisd(before.linear().transpose() * after.linear()).angle();
    if (angle > largest_turn) return 0.5 * largest_turn / angle;
    const Positions start = seen(here, there);
    return near.safe_fraction(start, seen(here_then, there_then) - start);
}

bool SurfacePairs::has_straight_way(const Eigen::Isometry3d& here, const Eigen::Isometry3d& there,
                                    const Eigen::Isometry3d& here_then, const Eigen::Isometry3d& there_then,
                                    double widths) const {
    const Eigen::Isometry3d before = there.inverse() * here, after = there_then.inverse() * here_then;
    const double way = (after.translation() - before.translation()).norm();
    const double width = widths * of_body;
    if (way <= width) return true;
    Eigen::Isometry3d end = before;
    end.translation() = after.translation();
    const Positions start = seen(before, Eigen::Isometry3d::Identity());
    const Positions motion = seen(end, Eigen::Isometry3d::Identity()) - start;
    return (1 - near.safe_fraction(start, motion)) * way <= width;
}

bool SurfacePairs::apart(const Eigen::Isometry3d& here, const Eigen::Isometry3d& there) const {
    const Positions all = seen(here, there);
    for (const ContactPair& pair : near.active_pairs(all))
        if (!(distance(pair, columns(all, pair.vertices)) > pair.minimum())) return false;
    return true;
}

void SurfacePairs::begin(const Eigen::Isometry3d& here, const Eigen::Isometry3d& there, double length) {
    here_before = here;
    there_before = there;
    sliding_pairs.clear();
    if (friction == 0) return;
    each_active(here, there, [&](const ContactPair& pair, const PairPositions& at) {
        sliding_pairs.push_back(
            sliding_pair(pair, at, friction, length, held.of({pair.kind, pair.vertices})));
    });
}

void SurfacePairs::finish(const Eigen::Isometry3d& here, const Eigen::Isometry3d& there) {
    held.clear();
    for (const SlidingPair& pair : sliding_pairs)
        held.keep(pair.key(), pair.held_after(moved(pair, here, there)));
    held.sort();
}

std::vector<std::unique_ptr<SurfacePairs>> surface_pairs(const std::vector<RigidBody>& bodies,
                                                         const std::vector<Obstacle>& obstacles,
                                                         bool springs) {
    std::vector<std::unique_ptr<SurfacePairs>> all;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (!bodies[b].surface) continue;
        for (std::size_t other = b + 1; other < bodies.size(); ++other) {
            if (!bodies[other].surface) continue;
            const bool swapped = is_ball(bodies[other]) && !is_ball(bodies[b]);
            const std::size_t one = swapped ? other : b, two = swapped ? b : other;
            all.push_back(std::make_unique<SurfacePairs>(one, bodies[one], two, bodies[two], springs));
        }
        for (std::size_t o = 0; o < obstacles.size(); ++o)
            if (obstacles[o].surface && obstacles[o].deformation == nullptr)
                all.push_back(
                    std::make_unique<SurfacePairs>(b, bodies[b], bodies.size() + o, obstacles[o], springs));
    }
    return all;
}

}  // namespace sherd
