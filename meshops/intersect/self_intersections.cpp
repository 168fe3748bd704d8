// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/intersect/self_intersections.h"

#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <algorithm>

#include "meshops/mesh_measures.h"

namespace sherd {
namespace {

constexpr std::size_t faces_in_a_strip = 20000;

/// An interval of the coordinate y, m.
struct Extent {
    double lower = std::numeric_limits<double>::infinity(), upper = -lower;
    double length() const { return upper - lower; }
};

Extent extent_of(const Mesh& mesh, Face face) {
    Extent extent;
    for (const Vertex v : vertices_around_face(mesh.halfedge(face), mesh)) {
        extent.lower = std::min(extent.lower, mesh.point(v).y());
        extent.upper = std::max(extent.upper, mesh.point(v).y());
    }
    return extent;
}

/// Returns lists of the faces of a mesh, one for each of several equal intervals of y; a face is in the lists
/// of all intervals that it reaches. For a whole mesh that is flat in z, CGAL would compare each face with
/// all faces in a row across the mesh, and its time would grow with the power 1.5 of the number of faces.
/// With lists of limited length, the time is proportional to this number.
std::vector<std::vector<Face>> strips(const Mesh& mesh) {
    std::vector<Extent> extents(mesh.num_faces());  // removed faces have an entry, too
    Extent all;
    double lengths = 0;
    for (const Face face : mesh.faces()) {
        const Extent& one = extents[face] = extent_of(mesh, face);
        all = {std::min(all.lower, one.lower), std::max(all.upper, one.upper)};
        lengths += one.length();
    }
    const auto faces = static_cast<double>(mesh.number_of_faces());
    // With more intervals than this, a face would be in more than two of them on average.
    const double most = lengths > 0 ? all.length() * faces / lengths : 1;
    const double count = std::floor(std::clamp(faces / faces_in_a_strip, 1.0, std::max(most, 1.0)));
    const auto strip_at = [&](double y) {
        return static_cast<std::size_t>(std::min(count * (y - all.lower) / all.length(), count - 1));
    };
    std::vector<std::vector<Face>> found(static_cast<std::size_t>(count));
    for (const Face face : mesh.faces()) {
        const Extent& one = extents[face];
        const std::size_t last = count > 1 ? strip_at(one.upper) : 0;
        for (std::size_t strip = count > 1 ? strip_at(one.lower) : 0; strip <= last; ++strip)
            found[strip].push_back(face);
    }
    return found;
}

}  // namespace

std::vector<std::array<Face, 2>> self_intersections(const Mesh& mesh) {
    std::vector<std::pair<Face, Face>> found;
    for (const std::vector<Face>& strip : strips(mesh))
        CGAL::Polygon_mesh_processing::self_intersections<CGAL::Sequential_tag>(strip, mesh,
                                                                                std::back_inserter(found));
    std::vector<std::array<Face, 2>> pairs;
    for (const auto& [a, b] : found) pairs.push_back({std::min(a, b), std::max(a, b)});
    std::ranges::sort(pairs);
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

}  // namespace sherd
