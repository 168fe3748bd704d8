// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/bodies/surface_pairs.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/contact/bodies/point_contacts.h"

namespace sherd {
namespace {

/// Inset of the core (the surface that forms pairs): as a share of the body's smallest extent, and for a ball
/// as a share of its radius.
constexpr double inset_of_extent = 0.01, inset_of_radius = 0.5;
/// Activation distance of pairs, as a share of the inset: for bodies in general, and for a ball, whose pairs
/// act far inside its surface.
constexpr double range_of_inset = 1, range_of_ball = 0.25;
/// Limit on the displacement of a point, in multiples of the inset; it acts at sharp tips.
constexpr double largest_inset = 3;
/// Share of their range by which pairs may be compressed when an exemption ends. The share is small because
/// no work has supplied the energy of the compressed pairs.
constexpr double still_apart = 1e-3;
/// The corresponding shares for barriers and for springs that replace the pairs of another time scheme. Up to
/// this compression a barrier stores less energy than a spring with the same compression; springs may be
/// compressed by their whole range.
constexpr double barrier_takes_over = 2.0 / 3, springs_take_over = 1;
/// Pairs are discarded when the ball around a body, enlarged by this factor, does not touch the other
/// collider's bounding box.
constexpr double times_of_kept = 3;
/// Ratio of a sheet's thickness to the activation distance of its pairs with a collider (see ContactSurface).
constexpr double thickness_of_range = 4;

/// Returns the displacements of the points, [3, P], that move the planes of all triangles inward by a unit
/// length: exactly at points where at most three different planes meet, and by least squares at other points.
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

/// The core of a body, whose pairs have the activation distance `range`; inset, range: m.
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

/// The core of a body that collides by its facets.
std::shared_ptr<const Shell> core_with_facets(const RigidBody& body) {
    const double inset = inset_of_extent * extent_of(body);
    return core_of(body, inset, range_of_inset * inset);
}

/// The core of a body. A ball's core lies deep, since the contact point at the ball's centre acts before the
/// core is reached.
std::shared_ptr<const Shell> core_of(const RigidBody& body) {
    if (!is_ball(body)) return core_with_facets(body);
    const double inset = inset_of_radius * body.contact_radius;
    return core_of(body, inset, range_of_ball * inset);
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

OtherSurface::OtherSurface(const Collider& collider) : of(collider.surface) {
    for (const auto& point : of->points.colwise()) around.include({point, point});
}

OtherSurface::OtherSurface(const Obstacle& obstacle) : OtherSurface(static_cast<const Collider&>(obstacle)) {
    deformation = obstacle.deformation;
    if (deforms()) before = now = of->points;
}

void OtherSurface::move_to(double time) {
    if (!deforms()) return;
    before = std::exchange(now, deformation->at(time));
    around = {};
    for (const Positions* shape : {&before, &now})
        for (const auto& point : shape->colwise()) around.include({point, point});
}

Positions OtherSurface::displacement_to(double time) const {
    return deforms() ? Positions(deformation->at(time) - now) : Positions(3, 0);
}

double OtherSurface::largest_displacement() const {
    return deforms() ? std::sqrt((now - before).colwise().squaredNorm().maxCoeff()) : 0;
}

SurfacePairs::SurfacePairs(std::size_t body, const RigidBody& one, std::shared_ptr<const Shell> of_one,
                           std::size_t other, const Collider& two, OtherSurface surface,
                           std::array<bool, 2> found_corners, bool are_springs)
    : body(body),
      other(other),
      stiffness(one.point_stiffness(two)),
      friction(friction_between(one, two)),
      of_body(extent_of(one)),
      second_young(two.young),
      second(std::move(surface)),
      core(std::move(of_one)),
      corners(found_corners),
      springs(are_springs) {
    radius = std::sqrt(core->rest.colwise().squaredNorm().maxCoeff()) +
             ContactCandidates::nearness * core->thickness[0] / thickness_of_range;
}

const NearPairs& SurfacePairs::near() const {
    if (!pairs)
        pairs = std::make_unique<NearPairs>(
            ContactSurface(*core, {{&second.surface(), second_young, 0, {}, 0}}, false, springs));
    return *pairs;
}

bool SurfacePairs::balls_meet(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to,
                              double times) const {
    Box ball;
    const Eigen::Array3d start = from.translation(), end = to.translation();
    ball.lower = start.min(end) - times * radius;
    ball.upper = start.max(end) + times * radius;
    return ball.meets(second.bounds());
}

bool SurfacePairs::may_meet(const PairPlaces& from, const PairPlaces& to) const {
    return !crossed && balls_meet(from.there.inverse() * from.here, to.there.inverse() * to.here);
}

bool SurfacePairs::cross(const Positions& all) const {
    const ContactSurface& surface = near().surface();
    return any_cuts(all, surface.collider_edges(), surface.triangles()) ||
           any_cuts(all, surface.edges(), surface.collider_triangles());
}

Positions SurfacePairs::in_body_frame(const PairPlaces& places) const {
    Positions all(3, first() + core->rest.cols());
    all << second.points(places.at_start), (places.there.inverse() * places.here) * core->rest;
    return all;
}

PairPositions SurfacePairs::in_space(const std::array<Index, 4>& vertices, const PairPlaces& places) const {
    const Positions& points = second.points(places.at_start);
    PairPositions at;
    for (int i = 0; i < 4; ++i)
        at.col(i) = vertices[i] < first() ? places.there * Vector3d(points.col(vertices[i]))
                                          : places.here * Vector3d(core->rest.col(vertices[i] - first()));
    return at;
}

double SurfacePairs::free_fraction(const PairPlaces& from, const PairPlaces& to) const {
    const Eigen::Isometry3d start = from.there.inverse() * from.here, end = to.there.inverse() * to.here;
    const bool rests = start.matrix() == end.matrix() && (!second.deforms() || from.at_start == to.at_start);
    if (rests || !may_meet(from, to)) return 1;
    const double angle = Eigen::AngleAxisd(start.linear().transpose() * end.linear()).angle();
    if (angle > largest_turn) return 0.5 * largest_turn / angle;
    const Positions all = in_body_frame(from);
    return near().safe_fraction(all, in_body_frame(to) - all);
}

bool SurfacePairs::has_straight_path(const PairPlaces& from, const PairPlaces& to, double widths) const {
    const Eigen::Isometry3d start = from.there.inverse() * from.here, end = to.there.inverse() * to.here;
    const double way = (end.translation() - start.translation()).norm() +
                       (from.at_start == to.at_start ? 0 : second.largest_displacement());
    const double width = widths * of_body;
    if (way <= width || !may_meet(from, to)) return true;
    PairPlaces moved{start, Eigen::Isometry3d::Identity(), to.at_start};
    moved.here.translation() = end.translation();
    const Positions all = in_body_frame({start, Eigen::Isometry3d::Identity(), from.at_start});
    return (1 - near().safe_fraction(all, in_body_frame(moved) - all)) * way <= width;
}

bool SurfacePairs::pass_between(const PairPlaces& from, const PairPlaces& to) const {
    if (!may_meet(from, to)) return false;
    const Positions all = in_body_frame(from);
    return near().passes(all, in_body_frame(to) - all);
}

Vector3d SurfacePairs::push_displacement(const PairPlaces& from, const PairPlaces& to) const {
    Vector3d most = Vector3d::Zero();
    if (!may_meet(from, to)) return most;
    const Positions all = in_body_frame(from), way = in_body_frame({from.here, to.there, to.at_start}) - all;
    near().each_nearby(all, way, [&](const ContactPair& pair) {
        const PairPositions moved = in_space(pair.vertices, to) - in_space(pair.vertices, from);
        for (int i = 0; i < 4; ++i)
            if (pair.vertices[i] < first() && moved.col(i).squaredNorm() > most.squaredNorm())
                most = moved.col(i);
    });
    return most;
}

bool SurfacePairs::apart(const PairPlaces& places, double pressed) const {
    const Eigen::Isometry3d at = places.there.inverse() * places.here;
    if (!balls_meet(at, at)) return true;
    const Positions all = in_body_frame(places);
    return !cross(all) && std::ranges::all_of(near().active_pairs(all), [&](const ContactPair& pair) {
        const double depth = pair.activation_distance - distance(pair, columns(all, pair.vertices));
        return is_of_points(pair) || depth < pressed * pair.barrier().range;
    });
}

int SurfacePairs::count_active(const PairPlaces& places) const {
    int count = 0;
    each_active(places, [&](const ContactPair&, const PairPositions&) { ++count; });
    return count;
}

void SurfacePairs::update_exemption(const PairPlaces& places) {
    if (!crossed) return;
    const double pressed = !was_not_exempt ? still_apart : springs ? springs_take_over : barrier_takes_over;
    crossed = !apart(places, pressed);
    was_not_exempt = false;
}

void SurfacePairs::place(const PairPlaces& places) {
    before = places;
    before.at_start = true;
    const Eigen::Isometry3d at = places.there.inverse() * places.here;
    if (!balls_meet(at, at, times_of_kept)) pairs.reset();
}

bool SurfacePairs::passes(const PairPlaces& places) {
    if (!may_meet(before, places)) return false;
    // Two surfaces without an active pair at the end of a motion that is shorter than the activation distance
    // have not passed through each other.
    const Eigen::Isometry3d from = before.there.inverse() * before.here,
                            to = places.there.inverse() * places.here;
    const double turn = Eigen::AngleAxisd(from.linear().transpose() * to.linear()).angle();
    const double way =
        (to.translation() - from.translation()).norm() + turn * radius + second.largest_displacement();
    if (way < core->thickness[0] / thickness_of_range && near().active_pairs(in_body_frame(places)).empty())
        return false;
    crossed = free_fraction(before, places) < 1;
    return crossed;
}

double SurfacePairs::stiffness_along_motion(const PairPlaces& places, const Positions& of_other,
                                            const Positions& motion) const {
    const Positions start = in_body_frame(places);
    Positions moved = Positions::Zero(3, start.cols());
    if (of_other.cols() > 0) moved.leftCols(of_other.cols()) = of_other;
    moved.rightCols(motion.cols()) = motion;
    double sum = 0;
    for (const ContactPair& pair : near().pairs_within_reach(start, moved))
        if (!is_of_points(pair)) sum += stiffness;
    return sum;
}

void SurfacePairs::begin(const PairPlaces& places, double length) {
    sliding_pairs.clear();
    update_exemption(places);
    place(places);
    if (friction == 0) return;
    each_active(places, [&](const ContactPair& pair, const PairPositions& at) {
        sliding_pairs.push_back(
            sliding_pair(pair, at, friction, length, elastic_slip.slip_of({pair.kind, pair.vertices})));
    });
}

void SurfacePairs::finish(const PairPlaces& places) {
    elastic_slip.clear();
    for (const SlidingPair& pair : sliding_pairs)
        elastic_slip.keep(pair.key(), pair.elastic_slip_after(moved(pair.vertices, places)));
    elastic_slip.sort();
}

std::vector<std::unique_ptr<SurfacePairs>> surface_pairs(const std::vector<RigidBody>& bodies,
                                                         const std::vector<Obstacle>& obstacles,
                                                         std::span<const char> crossed, bool springs) {
    std::vector<std::shared_ptr<const Shell>> cores, with_facets;
    for (const RigidBody& body : bodies) {
        cores.push_back(body.surface ? core_of(body) : nullptr);
        with_facets.push_back(body.surface && is_ball(body) ? core_with_facets(body) : cores.back());
    }
    std::vector<std::unique_ptr<SurfacePairs>> all;
    const auto add = [&](std::size_t one, std::size_t two, const Collider& second,
                         const OtherSurface& surface) {
        const bool found = !is_ball(bodies[one]) && !surface.deforms();
        all.push_back(std::make_unique<SurfacePairs>(
            one, bodies[one], surface.deforms() ? with_facets[one] : cores[one], two, second, surface,
            std::array{found, found && two < bodies.size()}, springs));
        if (!crossed.empty()) all.back()->resume(crossed[all.size() - 1]);
    };
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (!bodies[b].surface) continue;
        for (std::size_t other = b + 1; other < bodies.size(); ++other) {
            if (!bodies[other].surface) continue;
            const bool swapped = is_ball(bodies[other]) && !is_ball(bodies[b]);
            const RigidBody& second = bodies[swapped ? b : other];
            add(swapped ? other : b, swapped ? b : other, second, OtherSurface(second));
        }
        for (std::size_t o = 0; o < obstacles.size(); ++o)
            if (obstacles[o].surface) add(b, bodies.size() + o, obstacles[o], OtherSurface(obstacles[o]));
    }
    return all;
}

std::vector<char> crossed_surfaces(std::span<const std::unique_ptr<SurfacePairs>> all) {
    std::vector<char> crossed;
    for (const auto& two : all) crossed.push_back(two->is_crossed());
    return crossed;
}

}  // namespace sherd
