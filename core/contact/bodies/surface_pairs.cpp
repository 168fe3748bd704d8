// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/bodies/surface_pairs.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/contact/bodies/point_contacts.h"

namespace sherd {
namespace {

/// How far inside a body the surface is that makes pairs: of its smallest extent, and of a ball's radius.
constexpr double inset_of_extent = 0.01, inset_of_radius = 0.5;
/// Of the inset, where pairs become active: a ball's are far from where its surface touches.
constexpr double range_of_inset = 1, range_of_ball = 0.25;
constexpr double largest_inset = 3;  // times the inset, of the point of a needle
/// Of the range of pairs, by which surfaces that come to see each other may press: what is stored in them
/// then comes from nowhere.
constexpr double still_apart = 1e-3;
/// The same where another time scheme had them see each other: a barrier that is pressed by less stores less
/// than a spring that is pressed as far; springs give way by all of it.
constexpr double barrier_takes_over = 2.0 / 3, springs_take_over = 1;
/// Pairs are forgotten when the ball around a body, so many times larger, has left the other one.
constexpr double times_of_kept = 3;
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

std::shared_ptr<const Shell> core_of(const RigidBody& body, double inset, double range) {
    const ColliderSurface& surface = *body.surface;
    auto core = std::make_shared<Shell>();
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

/// The surface of a body, moved inward.
std::shared_ptr<const Shell> core_of(const RigidBody& body) {
    const double inset =
        is_ball(body) ? inset_of_radius * body.contact_radius : inset_of_extent * extent_of(body);
    return core_of(body, inset, (is_ball(body) ? range_of_ball : range_of_inset) * inset);
}

/// Whether the edge from p to q cuts the triangle a b c.
bool cuts(const Vector3d& p, const Vector3d& q, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    const auto volume = [](const Vector3d& from, const Vector3d& one, const Vector3d& two,
                           const Vector3d& to) { return (one - from).cross(two - from).dot(to - from); };
    if (volume(a, b, c, p) * volume(a, b, c, q) > 0) return false;
    const double u = volume(p, q, a, b), v = volume(p, q, b, c), w = volume(p, q, c, a);
    return (u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0);
}

std::vector<Box> boxes_of(const Positions& points) {
    std::vector<Box> boxes(points.cols());
    for (Eigen::Index i = 0; i < points.cols(); ++i) boxes[i].lower = boxes[i].upper = points.col(i);
    return boxes;
}

bool any_cuts(const Positions& all, const std::vector<std::array<Index, 2>>& edges,
              const std::vector<std::array<Index, 3>>& triangles) {
    const std::vector<Box> boxes = boxes_of(all);
    bool any = false;
    BoxTree(element_boxes(boxes, edges))
        .meet(BoxTree(element_boxes(boxes, triangles)), [&](Index edge, Index triangle) {
            const auto& [p, q] = edges[edge];
            const auto& [a, b, c] = triangles[triangle];
            any |= cuts(all.col(p), all.col(q), all.col(a), all.col(b), all.col(c));
        });
    return any;
}

}  // namespace

SurfacePairs::SurfacePairs(std::size_t body, const RigidBody& one, std::shared_ptr<const Shell> of_one,
                           std::size_t other, const Collider& two, std::array<bool, 2> found_corners,
                           bool are_springs)
    : body(body),
      other(other),
      stiffness(one.point_stiffness(two)),
      friction(friction_between(one, two)),
      of_body(extent_of(one)),
      second_young(two.young),
      second(two.surface),
      core(std::move(of_one)),
      corners(found_corners),
      springs(are_springs) {
    for (const Box& point : boxes_of(second->points)) bounds.include(point);
    radius = std::sqrt(core->rest.colwise().squaredNorm().maxCoeff()) +
             ContactCandidates::nearness * core->thickness[0] / thickness_of_range;
}

const NearPairs& SurfacePairs::near() const {
    if (!pairs)
        pairs = std::make_unique<NearPairs>(
            ContactSurface(*core, {{second.get(), second_young, 0, {}, 0}}, false, springs));
    return *pairs;
}

bool SurfacePairs::balls_meet(const Eigen::Isometry3d& before, const Eigen::Isometry3d& after,
                              double times) const {
    Box ball;
    const Eigen::Array3d start = before.translation(), end = after.translation();
    ball.lower = start.min(end) - times * radius;
    ball.upper = start.max(end) + times * radius;
    return ball.meets(bounds);
}

bool SurfacePairs::may_meet(const Eigen::Isometry3d& here, const Eigen::Isometry3d& there,
                            const Eigen::Isometry3d& here_then, const Eigen::Isometry3d& there_then) const {
    return !crossed && balls_meet(there.inverse() * here, there_then.inverse() * here_then);
}

bool SurfacePairs::cross(const Positions& all) const {
    const ContactSurface& surface = near().surface();
    return any_cuts(all, surface.collider_edges(), surface.triangles()) ||
           any_cuts(all, surface.edges(), surface.collider_triangles());
}

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
    if (before.matrix() == after.matrix() || !may_meet(here, there, here_then, there_then)) return 1;
    const double angle = Eigen::AngleAxisd(before.linear().transpose() * after.linear()).angle();
    if (angle > largest_turn) return 0.5 * largest_turn / angle;
    const Positions start = seen(here, there);
    return near().safe_fraction(start, seen(here_then, there_then) - start);
}

bool SurfacePairs::has_straight_way(const Eigen::Isometry3d& here, const Eigen::Isometry3d& there,
                                    const Eigen::Isometry3d& here_then, const Eigen::Isometry3d& there_then,
                                    double widths) const {
    const Eigen::Isometry3d before = there.inverse() * here, after = there_then.inverse() * here_then;
    const double way = (after.translation() - before.translation()).norm();
    const double width = widths * of_body;
    if (way <= width || !may_meet(here, there, here_then, there_then)) return true;
    Eigen::Isometry3d end = before;
    end.translation() = after.translation();
    const Positions start = seen(before, Eigen::Isometry3d::Identity());
    const Positions motion = seen(end, Eigen::Isometry3d::Identity()) - start;
    return (1 - near().safe_fraction(start, motion)) * way <= width;
}

bool SurfacePairs::apart(const Eigen::Isometry3d& here, const Eigen::Isometry3d& there,
                         double pressed) const {
    const Eigen::Isometry3d at = there.inverse() * here;
    if (!balls_meet(at, at)) return true;
    const Positions all = seen(here, there);
    return !cross(all) && std::ranges::all_of(near().active_pairs(all), [&](const ContactPair& pair) {
        const double depth = pair.activation_distance - distance(pair, columns(all, pair.vertices));
        return is_of_points(pair) || depth < pressed * pair.barrier().range;
    });
}

int SurfacePairs::count_active(const Eigen::Isometry3d& here, const Eigen::Isometry3d& there) const {
    int count = 0;
    each_active(here, there, [&](const ContactPair&, const PairPositions&) { ++count; });
    return count;
}

void SurfacePairs::look(const Eigen::Isometry3d& here, const Eigen::Isometry3d& there) {
    if (!crossed) return;
    const double pressed = !seen_before ? still_apart : springs ? springs_take_over : barrier_takes_over;
    crossed = !apart(here, there, pressed);
    seen_before = false;
}

void SurfacePairs::place(const Eigen::Isometry3d& here, const Eigen::Isometry3d& there) {
    here_before = here;
    there_before = there;
    const Eigen::Isometry3d at = there.inverse() * here;
    if (!balls_meet(at, at, times_of_kept)) pairs.reset();
}

bool SurfacePairs::passes(const Eigen::Isometry3d& here, const Eigen::Isometry3d& there) {
    const Eigen::Isometry3d before = std::exchange(here_before, here),
                            there_then = std::exchange(there_before, there);
    if (!may_meet(before, there_then, here, there)) return false;
    // What has nothing within reach where it comes from must move by the whole range to get through.
    const Eigen::Isometry3d from = there_then.inverse() * before, to = there.inverse() * here;
    const double turn = Eigen::AngleAxisd(from.linear().transpose() * to.linear()).angle();
    const double way = (to.translation() - from.translation()).norm() + turn * radius;
    if (way < core->thickness[0] / thickness_of_range && near().active_pairs(seen(here, there)).empty())
        return false;
    crossed = free_way(before, there_then, here, there) < 1;
    return crossed;
}

double SurfacePairs::stiffness_within_reach(const Eigen::Isometry3d& here, const Eigen::Isometry3d& there,
                                            const Positions& motion) const {
    const Positions start = seen(here, there);
    Positions moved = Positions::Zero(3, start.cols());
    moved.rightCols(motion.cols()) = motion;
    double sum = 0;
    for (const ContactPair& pair : near().pairs_within_reach(start, moved))
        if (!is_of_points(pair)) sum += stiffness;
    return sum;
}

void SurfacePairs::begin(const Eigen::Isometry3d& here, const Eigen::Isometry3d& there, double length) {
    sliding_pairs.clear();
    look(here, there);
    place(here, there);
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
                                                         std::span<const char> crossed, bool springs) {
    std::vector<std::shared_ptr<const Shell>> cores;
    for (const RigidBody& body : bodies) cores.push_back(body.surface ? core_of(body) : nullptr);
    std::vector<std::unique_ptr<SurfacePairs>> all;
    const auto add = [&](std::size_t one, std::size_t two, const Collider& second) {
        const bool is_of_ball = is_ball(bodies[one]);
        all.push_back(std::make_unique<SurfacePairs>(
            one, bodies[one], cores[one], two, second,
            std::array{!is_of_ball, !is_of_ball && two < bodies.size()}, springs));
        if (!crossed.empty()) all.back()->go_on(crossed[all.size() - 1]);
    };
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (!bodies[b].surface) continue;
        for (std::size_t other = b + 1; other < bodies.size(); ++other) {
            if (!bodies[other].surface) continue;
            const bool swapped = is_ball(bodies[other]) && !is_ball(bodies[b]);
            add(swapped ? other : b, swapped ? b : other, bodies[swapped ? b : other]);
        }
        for (std::size_t o = 0; o < obstacles.size(); ++o)
            if (obstacles[o].surface && obstacles[o].deformation == nullptr)
                add(b, bodies.size() + o, obstacles[o]);
    }
    return all;
}

std::vector<char> crossed_surfaces(std::span<const std::unique_ptr<SurfacePairs>> all) {
    std::vector<char> crossed;
    for (const auto& two : all) crossed.push_back(two->is_crossed());
    return crossed;
}

}  // namespace sherd
