// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <ostream>
#include <vector>

#include "meshops/mesh.h"
#include "tests/support/shell/random_shapes.h"

namespace sherd::test {

/// Parameters of random_edges(). Smaller numbers choose fewer edges, so that a failing case can be shrunk.
struct EdgeRecipe {
    int pattern = 0;    ///< pattern of random_edges(), below pattern_count
    int amount = 0;     ///< 0 to 100: percentage of edges, or (patterns 1 and 2) length of the path or loop
    unsigned seed = 0;  ///< seed of the choice
};

inline constexpr int pattern_count = 7;

inline std::ostream& operator<<(std::ostream& out, const EdgeRecipe& r) {
    return out << "pattern " << r.pattern << ", amount " << r.amount << ", seed " << r.seed;
}

/// Chooses interior edges of a mesh.
class EdgeChoice {
  public:
    EdgeChoice(const Mesh& mesh, unsigned seed)
        : mesh(mesh), random(seed), is_chosen(mesh.number_of_edges(), false) {}

    std::vector<Edge> edges() const {
        std::vector<Edge> chosen;
        for (const Edge edge : mesh.edges())
            if (is_chosen[edge] && !mesh.is_border(edge)) chosen.push_back(edge);
        return chosen;
    }

    void one() { is_chosen[random.below(mesh.number_of_edges())] = true; }
    void percent(int amount) {
        for (const Edge edge : mesh.edges())
            if (random.uniform(0, 100) < amount) is_chosen[edge] = true;
    }
    /// Adds a path of steps + 1 edges that turns at random and may meet or cross itself.
    void line(int steps) {
        Halfedge h(random.below(mesh.number_of_halfedges()));
        for (; steps >= 0; --steps) {
            is_chosen[mesh.edge(h)] = true;
            h = mesh.next(h);
            for (unsigned turns = random.below(3); turns > 0; --turns) h = mesh.next(mesh.opposite(h));
        }
    }
    /// Adds the outline of a patch of faces: closed loops, or lines from boundary to boundary.
    void loop(int steps) {
        std::vector<char> is_inside(mesh.number_of_faces(), false);
        Face face(random.below(mesh.number_of_faces()));
        for (; steps >= 0; --steps) {
            is_inside[face] = true;
            Halfedge h = mesh.halfedge(face);
            for (unsigned turns = random.below(3); turns > 0; --turns) h = mesh.next(h);
            if (!mesh.is_border(mesh.opposite(h))) face = mesh.face(mesh.opposite(h));
        }
        for (const Edge edge : mesh.edges()) {
            if (mesh.is_border(edge)) continue;
            const Face a = mesh.face(mesh.halfedge(edge, 0)), b = mesh.face(mesh.halfedge(edge, 1));
            if (is_inside[a] != is_inside[b]) is_chosen[edge] = true;
        }
    }
    /// Adds `amount` percent of the edges with a vertex on the boundary.
    void along_boundary(int amount) {
        for (const Edge edge : mesh.edges())
            if ((mesh.is_border(mesh.vertex(edge, 0)) || mesh.is_border(mesh.vertex(edge, 1))) &&
                random.uniform(0, 100) < amount)
                is_chosen[edge] = true;
    }
    /// Adds `amount` percent of the edges around one vertex.
    void star(int amount) {
        const Vertex centre(random.below(mesh.number_of_vertices()));
        for (const Halfedge h : mesh.halfedges_around_target(mesh.halfedge(centre)))
            if (random.uniform(0, 100) < amount) is_chosen[mesh.edge(h)] = true;
    }

  private:
    const Mesh& mesh;
    Random random;
    std::vector<char> is_chosen;
};

/// Interior edges of the mesh that the recipe chooses, ascending; there may be none.
inline std::vector<Edge> random_edges(const Mesh& mesh, const EdgeRecipe& recipe) {
    EdgeChoice choice(mesh, recipe.seed);
    switch (recipe.pattern) {
        case 1:
            choice.line(recipe.amount / 8);
            break;
        case 2:
            choice.loop(recipe.amount / 4);
            break;
        case 3:
            choice.along_boundary(recipe.amount);
            break;
        case 4:
            choice.star(recipe.amount);
            choice.star(recipe.amount);
            break;
        case 5:
            choice.percent(recipe.amount);
            break;
        case 6:
            choice.percent(100);
            break;
        default:
            choice.one();
    }
    return choice.edges();
}

}  // namespace sherd::test
