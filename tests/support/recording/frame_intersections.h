// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "app/recording/recording.h"
#include "meshops/intersect/self_intersections.h"
#include "meshops/intersect/surface_crossings.h"

namespace sherd::test {

/// Mesh of the frame, rebuilt from its faces, without faces that do not fit into a 2-manifold.
inline Mesh frame_mesh(const Snapshot& frame) {
    Mesh mesh;
    for (Eigen::Index v = 0; v < frame.position.cols(); ++v)
        mesh.add_vertex(Point(frame.position(0, v), frame.position(1, v), frame.position(2, v)));
    for (const auto& face : frame.faces) mesh.add_face(Vertex(face[0]), Vertex(face[1]), Vertex(face[2]));
    return mesh;
}

/// Pairs of faces of a frame that intersect not only in the vertices and edges that they share.
struct FrameIntersections {
    std::vector<std::array<Face, 2>> passing;  ///< pairs that pass through each other: must be empty
    std::size_t crack_faces =
        0;  ///< number of pairs at a split vertex, where crack faces (lips) coincide until they separate
};

/// Finds the intersections by exact predicates.
inline FrameIntersections frame_intersections(const Snapshot& frame) {
    FrameIntersections found;
    for (const auto& pair : self_intersections(frame_mesh(frame))) {
        bool split = false;
        for (const Index p : frame.faces[pair[0]])
            for (const Index q : frame.faces[pair[1]]) split |= frame.original[p] == frame.original[q];
        if (split)
            ++found.crack_faces;
        else
            found.passing.push_back(pair);
    }
    return found;
}

/// Number of faces of a frame that intersect a recorded obstacle, for all obstacles in their poses of this
/// frame.
inline std::size_t faces_in_obstacles(const Snapshot& frame, const std::vector<RecordedObstacle>& obstacles,
                                      const std::vector<Eigen::Isometry3d>& poses) {
    const Mesh mesh = frame_mesh(frame);
    std::size_t count = 0;
    for (std::size_t i = 0; i < obstacles.size(); ++i) {
        std::vector<Eigen::Vector3d> points = obstacles[i].surface.points;
        for (Eigen::Vector3d& point : points) point = poses[i] * point;
        count += surface_crossings(mesh, points, obstacles[i].surface.triangles).size();
    }
    return count;
}

}  // namespace sherd::test
