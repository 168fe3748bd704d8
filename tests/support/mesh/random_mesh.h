// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <ostream>

#include "tests/support/mesh/mesh_shapes.h"
#include "tests/support/shell/random_shapes.h"

namespace sherd::test {

/// Parameters of random_mesh(). Smaller numbers make smaller and plainer meshes, so that a failing case can
/// be shrunk.
struct MeshRecipe {
    int shape = 0;              ///< shape of base_mesh(), below shape_count
    int columns = 1, rows = 1;  ///< numbers of squares; more are used where the shape needs them
    int centres = 0;            ///< number of faces to split in three, which makes low and high degrees
    int flips = 0;              ///< number of edges to flip: degrees vary as in a Delaunay mesh
    int holes = 0;              ///< number of faces to remove
    unsigned seed = 0;          ///< seed by which these faces and edges are chosen
};

inline std::ostream& operator<<(std::ostream& out, const MeshRecipe& r) {
    return out << "shape " << r.shape << ", " << r.columns << " x " << r.rows << ", centres " << r.centres
               << ", flips " << r.flips << ", holes " << r.holes << ", seed " << r.seed;
}

/// Triangles between a rim of `count` vertices and a hub. If closed, a second hub on the other side closes
/// the surface.
inline Mesh wheel(int count, bool is_closed) {
    Mesh mesh;
    std::vector<Vertex> rim;
    for (int i = 0; i < count; ++i) rim.push_back(mesh.add_vertex(Point(i, 1, 0)));
    const Vertex hub = mesh.add_vertex(Point(0, 0, 1));
    for (int i = 0; i < count; ++i) mesh.add_face(rim[i], rim[(i + 1) % count], hub);
    if (!is_closed) return mesh;
    const Vertex other = mesh.add_vertex(Point(0, 0, -1));
    for (int i = 0; i < count; ++i) mesh.add_face(rim[(i + 1) % count], rim[i], other);
    return mesh;
}

/// Both surfaces, each without its first face, glued along the outlines of these two faces.
inline Mesh connected_sum(const Mesh& first, const Mesh& second) {
    const auto faces = triangles_of(first), others = triangles_of(second);
    Mesh mesh;
    std::vector<Vertex> vertices;
    for (const Vertex vertex : first.vertices()) vertices.push_back(mesh.add_vertex(first.point(vertex)));
    std::vector<Vertex> number(second.number_of_vertices());
    for (const int i : {0, 1, 2}) number[others[0][i]] = vertices[faces[0][2 - i]];
    for (const Vertex vertex : second.vertices())
        if (!number[vertex].is_valid()) number[vertex] = mesh.add_vertex(second.point(vertex));
    for (std::size_t f = 1; f < faces.size(); ++f)
        mesh.add_face(vertices[faces[f][0]], vertices[faces[f][1]], vertices[faces[f][2]]);
    for (std::size_t f = 1; f < others.size(); ++f)
        mesh.add_face(number[others[f][0]], number[others[f][1]], number[others[f][2]]);
    return mesh;
}

inline constexpr int shape_count = 8;

inline Mesh base_mesh(const MeshRecipe& recipe) {
    const int columns = std::max(recipe.columns, 3), rows = std::max(recipe.rows, 3);
    switch (recipe.shape) {
        case 1:
            return wheel(columns + rows, false);
        case 2:
            return wheel(columns + recipe.rows - 1, true);  // at least two tetrahedra, base on base
        case 3:
            return grid(columns, recipe.rows, true);  // tube
        case 4:
            return grid(columns, rows, true, true);  // torus
        case 5:
            return connected_sum(grid(columns, 3, true, true), grid(3, rows, true, true));  // genus two
        case 6:
            return connected_sum(grid(columns, 3, true, true), grid(3, 3));  // torus with a hole
        case 7: {                                                            // several components
            Mesh mesh = wheel(columns, true);
            mesh.join(grid(1, recipe.rows));
            mesh.join(grid(3, 3, true, recipe.columns > 2));
            return mesh;
        }
        default:
            return grid(recipe.columns, recipe.rows);
    }
}

/// Flips the edge, unless that makes a second edge between the same vertices.
inline void flip(Mesh& mesh, Edge edge) {
    const Halfedge h = mesh.halfedge(edge);
    if (mesh.is_border(edge)) return;
    const Vertex a = mesh.target(mesh.next(h)), b = mesh.target(mesh.next(mesh.opposite(h)));
    if (a != b && !mesh.halfedge(a, b).is_valid()) CGAL::Euler::flip_edge(h, mesh);
}

/// Removes the face, if the remaining mesh is a manifold and not empty.
inline void remove(Mesh& mesh, Face face) {
    int border_edges = 0, border_corners = 0;
    for (const Halfedge h : mesh.halfedges_around_face(mesh.halfedge(face))) {
        border_edges += mesh.is_border(mesh.opposite(h));
        border_corners += mesh.is_border(mesh.target(h));
    }
    if (border_corners == 0 || border_edges == 2 || (border_edges == 1 && border_corners == 2))
        CGAL::Euler::remove_face(mesh.halfedge(face), mesh);
}

/// Random mesh of the topology that the recipe chooses. Each vertex has a position of its own, by which tests
/// can identify vertices and corners.
inline Mesh random_mesh(const MeshRecipe& recipe) {
    Mesh mesh = base_mesh(recipe);
    Random random(recipe.seed);
    for (int i = 0; i < recipe.centres; ++i)
        CGAL::Euler::add_center_vertex(mesh.halfedge(Face(random.below(mesh.number_of_faces()))), mesh);
    for (int i = 0; i < recipe.flips; ++i) flip(mesh, Edge(random.below(mesh.number_of_edges())));
    for (int i = 0; i < recipe.holes; ++i) {
        remove(mesh, Face(random.below(mesh.number_of_faces())));
        if (mesh.has_garbage()) mesh.collect_garbage();
    }
    for (const Vertex vertex : mesh.vertices()) mesh.point(vertex) = Point(vertex.idx(), recipe.seed, 0.5);
    return mesh;
}

}  // namespace sherd::test
