// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/assemble/check/reach.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/contact/geometry/basic_shapes.h"
#include "meshops/mesh_measures.h"

namespace sherd {
namespace {

using Bounds = Eigen::AlignedBox3d;

constexpr int moments = 400;    // number of intervals into which the duration is divided
constexpr double slack = 0.05;  // share of a sheet's size, added for its deformation in flight
constexpr double throwing = 3;  // ratio of the fastest splinter's speed to the largest speed before
constexpr double any_gap = std::numeric_limits<double>::infinity();

/// A sheet or a free body.
struct Mover {
    Bounds box;  ///< bounding box at the start
    Vector3d velocity;
    double damping;                       ///< 1/s, rate at which the velocity decays
    double met = any_gap;                 ///< s, time from which on it may move in any direction; infinite:
                                          ///< never
    std::optional<Bounds> met_near = {};  ///< bounding box at the time `met`
};

struct Flight {
    Vector3d gravity;
    double top_speed;  ///< m/s, largest speed in the scene
};

Bounds around(const Vector3d& centre, double radius) {
    return {centre - Vector3d::Constant(radius), centre + Vector3d::Constant(radius)};
}

Bounds enlarged(const Bounds& box, double by) {
    return {box.min() - Vector3d::Constant(by), box.max() + Vector3d::Constant(by)};
}

Bounds moved(const Bounds& box, const Eigen::Isometry3d& pose) {
    Bounds result;
    for (int corner = 0; corner < 8; ++corner)
        result.extend(pose * box.corner(static_cast<Bounds::CornerType>(corner)));
    return result;
}

Vector3d flown(const Mover& mover, const Vector3d& gravity, double time) {
    if (mover.damping == 0) return time * mover.velocity + 0.5 * time * time * gravity;
    const Vector3d last = gravity / mover.damping;
    return time * last - std::expm1(-mover.damping * time) / mover.damping * (mover.velocity - last);
}

Bounds reach(const Mover& mover, const Flight& flight, double from, double to) {
    if (mover.met_near) {
        const double speed = throwing * (flight.top_speed + flight.gravity.norm() * to);
        return enlarged(*mover.met_near, speed * (to - mover.met));
    }
    Bounds box = mover.box;
    return Bounds(box.translated(flown(mover, flight.gravity, from)))
        .merged(box.translated(flown(mover, flight.gravity, to)));
}

Bounds box_at(const Obstacle& obstacle, double time) {
    if (obstacle.deformation == nullptr) return moved(obstacle.shape->bounds(), obstacle.motion.at(time));
    const Positions points = obstacle.points_at(time);
    return {points.rowwise().minCoeff(), points.rowwise().maxCoeff()};
}

/// Returns a box that contains an obstacle at the beginning and at the end of a time interval (s).
Bounds swept(const Obstacle& obstacle, double from, double to) {
    return box_at(obstacle, from).merged(box_at(obstacle, to));
}

/// Returns the gap, m, between a box and an obstacle in a time interval (s); at most 0 if they may meet.
/// around: swept() of the obstacle.
double gap(const Bounds& box, const Obstacle& obstacle, const Bounds& around, double from, double to) {
    if (const auto* plane = dynamic_cast<const PlaneShape*>(obstacle.shape.get())) {
        double least = any_gap;
        for (const double time : {from, to}) {
            const Eigen::Isometry3d back = obstacle.motion.at(time).inverse();
            for (int corner = 0; corner < 8; ++corner)
                least = std::min(
                    least,
                    plane->distance(back * box.corner(static_cast<Bounds::CornerType>(corner))).distance);
        }
        return least;
    }
    return box.exteriorDistance(around);
}

/// Returns the largest speed, m/s, of the corners of a box that moves with `motion`. duration: s.
double top_speed(const Motion& motion, const Bounds& box, double duration) {
    if (motion.keys.empty()) return 0;
    double fastest = 0;
    const double interval = duration / moments;
    for (int i = 0; i < moments; ++i)
        for (int corner = 0; corner < 8; ++corner) {
            const Vector3d at = box.corner(static_cast<Bounds::CornerType>(corner));
            const Vector3d way = motion.at((i + 1) * interval) * at - motion.at(i * interval) * at;
            fastest = std::max(fastest, way.norm() / interval);
        }
    return fastest;
}

/// Returns the largest speed, m/s, of the points of a deforming obstacle. duration: s.
double top_speed(const Obstacle& obstacle, double duration) {
    double fastest = 0;
    const double interval = duration / moments;
    Positions before = obstacle.points_at(0);
    for (int i = 1; i <= moments; ++i) {
        const Positions now = obstacle.points_at(i * interval);
        fastest = std::max(fastest, (now - before).colwise().norm().maxCoeff() / interval);
        before = now;
    }
    return fastest;
}

Mover mover_of(const SheetInput& input, const SheetSpec& sheet, const Scene& scene) {
    Bounds box;
    for (const Vertex v : input.mesh.vertices()) box.extend(position(input.mesh, v));
    const double size = box.diagonal().norm();
    if (sheet.spin != Vector3d::Zero()) box = around(box.center(), size);
    Mover mover{enlarged(box, slack * size + 0.5 * input.thickest()), input.velocity,
                scene.simulation.stepper.shell.damping.mass};
    const bool blown = std::any_of(scene.winds.begin(), scene.winds.end(), [&](const WindSpec& wind) {
        return wind.sheet.empty() || wind.sheet == sheet.name;
    });
    if (sheet.is_supported() || blown) {
        mover.met = 0;
        mover.met_near = mover.box;
    }
    return mover;
}

Mover mover_of(const RigidBody& body) {
    return {around(body.centre, 0.5 * body.shape->bounds().diagonal().norm()), body.velocity, 0};
}

double fastest_of(const Scene& scene, const std::vector<SheetInput>& inputs, const SimulationOptions& options,
                  const std::vector<Mover>& movers) {
    double fastest = 0;
    for (const Mover& mover : movers) fastest = std::max(fastest, mover.velocity.norm());
    for (std::size_t s = 0; s < inputs.size(); ++s) {
        const double radius = 0.5 * movers[s].box.diagonal().norm();
        fastest = std::max(fastest, inputs[s].velocity.norm() + inputs[s].spin.norm() * radius);
        for (const MovingPin& pin : inputs[s].moving_pins)
            fastest = std::max(fastest, top_speed(pin.motion, movers[s].box, scene.duration));
    }
    for (const RigidBody& body : options.stepper.contact.bodies)
        fastest = std::max(
            fastest, body.velocity.norm() + body.spin().norm() * body.shape->bounds().diagonal().norm());
    for (const Obstacle& obstacle : options.stepper.contact.obstacles) {
        if (obstacle.deformation != nullptr) {
            fastest = std::max(fastest, top_speed(obstacle, scene.duration));
            continue;
        }
        const Bounds bounds = obstacle.shape->bounds();
        const Bounds box = bounds.diagonal().allFinite() ? bounds : movers.front().box;
        fastest = std::max(fastest, top_speed(obstacle.motion, box, scene.duration));
    }
    for (const WindSpec& wind : scene.winds)
        fastest = std::max(fastest, wind.wind.velocity.norm() + (wind.gust ? 3 * wind.gust->amplitude : 0));
    return fastest;
}

/// Returns, for each obstacle and then for each free body, the least gap (m) to any sheet and any other body.
/// sheets: number of sheets, which are the first movers; duration: s.
std::vector<double> gaps(const std::vector<Obstacle>& obstacles, std::size_t sheets,
                         std::vector<Mover> movers, const Flight& flight, double duration) {
    std::vector<double> of_obstacles(obstacles.size(), any_gap), of_movers(movers.size(), any_gap);
    for (int i = 0; i < moments; ++i) {
        const double from = duration * i / moments, to = duration * (i + 1) / moments;
        std::vector<Bounds> boxes, around;
        for (const Obstacle& obstacle : obstacles) around.push_back(swept(obstacle, from, to));
        for (const Mover& mover : movers) boxes.push_back(reach(mover, flight, from, to));
        std::vector<char> meets(movers.size(), 0);
        for (std::size_t m = 0; m < movers.size(); ++m) {
            for (std::size_t o = 0; o < obstacles.size(); ++o) {
                const double apart = gap(boxes[m], obstacles[o], around[o], from, to);
                of_obstacles[o] = std::min(of_obstacles[o], apart);
                if (apart <= 0) meets[m] = 1;
            }
            for (std::size_t n = 0; n < m; ++n) {
                const double apart = boxes[m].exteriorDistance(boxes[n]);
                of_movers[m] = std::min(of_movers[m], apart);
                of_movers[n] = std::min(of_movers[n], apart);
                if (apart <= 0) meets[m] = meets[n] = 1;
            }
        }
        for (std::size_t m = 0; m < movers.size(); ++m) {
            if (!meets[m] || movers[m].met_near) continue;
            movers[m].met = from;
            movers[m].met_near = boxes[m];
        }
    }
    of_obstacles.insert(of_obstacles.end(), of_movers.begin() + static_cast<std::ptrdiff_t>(sheets),
                        of_movers.end());
    return of_obstacles;
}

}  // namespace

void warn_of_unreachable(const Scene& scene, const std::vector<SheetInput>& inputs,
                         const SimulationOptions& options, std::vector<std::string>& warnings) {
    if (!scene.loads.empty() || scene.is_static()) return;
    std::vector<Mover> movers;
    for (std::size_t s = 0; s < inputs.size(); ++s)
        movers.push_back(mover_of(inputs[s], scene.sheets[s], scene));
    for (const RigidBody& body : options.stepper.contact.bodies) movers.push_back(mover_of(body));
    const Flight flight{scene.simulation.stepper.gravity, fastest_of(scene, inputs, options, movers)};
    const std::vector<double> found =
        gaps(options.stepper.contact.obstacles, inputs.size(), movers, flight, scene.duration);
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (found[i] <= 0) continue;
        const bool fixed = i < scene.obstacles.size();
        const ObstacleSpec& spec = fixed ? scene.obstacles[i] : scene.bodies[i - scene.obstacles.size()];
        warnings.push_back(fmt::format(
            "{}: nothing can reach obstacle.{} in {:g} s: under gravity and with their initial velocities, "
            "sheets and bodies stay {:.3g} m away or more; start nearer or faster, or use a longer duration",
            spec.where, spec.name, scene.duration, found[i]));
    }
}

}  // namespace sherd
