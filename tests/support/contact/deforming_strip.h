// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "tests/support/contact/obstacles.h"

namespace sherd::test {

/// Points of a rectangle in the plane z = 0 about the origin, divided into `count` x 2 smaller rectangles.
/// length, width: m.
inline Positions strip_points(double length, double width, int count) {
    Positions points(3, 3 * (count + 1));
    for (int i = 0; i <= count; ++i)
        for (int j = 0; j < 3; ++j)
            points.col(3 * i + j) = Vector3d(length * (1.0 * i / count - 0.5), width * (0.5 * j - 0.5), 0);
    return points;
}

inline std::vector<std::array<Index, 3>> strip_triangles(int count) {
    std::vector<std::array<Index, 3>> triangles;
    for (Index i = 0; i < count; ++i)
        for (Index j = 0; j < 2; ++j) {
            const Index a = 3 * i + j;
            triangles.push_back({a, a + 3, a + 4});
            triangles.push_back({a, a + 4, a + 1});
        }
    return triangles;
}

/// Obstacle with an open surface that deforms. samples: [3, P] m, positions of its points at times from 0 on,
/// `interval` s apart. smooth: as in Deformation.
inline Obstacle deforming(const std::vector<Positions>& samples,
                          const std::vector<std::array<Index, 3>>& triangles, double interval,
                          bool smooth = false) {
    Obstacle obstacle = test::obstacle(OpenSurface{});
    obstacle.surface = std::make_shared<ColliderSurface>(collider_surface(samples[0], triangles, true));
    Deformation deformation;
    for (const Positions& sample : samples) {
        deformation.times.push_back(interval * static_cast<double>(deformation.times.size()));
        deformation.samples.push_back(sample.cast<float>());
    }
    deformation.smooth = smooth;
    obstacle.deformation = std::make_shared<Deformation>(deformation);
    return obstacle;
}

/// Belt that moves along x at `speed`, m/s, and is stretched meanwhile, to `stretch` times its length in 1 s.
inline Obstacle belt(double speed, double stretch, double friction) {
    std::vector<Positions> samples;
    for (int s = 0; s <= 40; ++s) {
        Positions sample = strip_points(0.6, 0.3, 12);
        const double time = s / 40.0;
        sample.row(0) *= 1 + (stretch - 1) * time;
        sample.row(0).array() += speed * time;
        samples.push_back(sample);
    }
    Obstacle obstacle = deforming(samples, strip_triangles(12), 1.0 / 40);
    obstacle.friction = friction;
    return obstacle;
}

}  // namespace sherd::test
