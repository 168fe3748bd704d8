// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/solid/body_check.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/boost/graph/helpers.h>

#include "meshops/intersect/self_intersections.h"
#include "meshops/mesh_measures.h"

namespace sherd {

namespace {

/// Adds the points and triangles of `body` to an empty mesh. Returns false if the triangles do not form a
/// manifold.
bool fill(Mesh& mesh, const TriangleSheet& body) {
    for (const auto& p : body.points) mesh.add_vertex(point_at(p));
    for (const auto& [a, b, c] : body.triangles)
        if (mesh.add_face(Vertex(a), Vertex(b), Vertex(c)) == Mesh::null_face()) return false;
    return CGAL::is_valid_polygon_mesh(mesh);
}

}  // namespace

BodyCheck check_body(const TriangleSheet& body) {
    namespace processing = CGAL::Polygon_mesh_processing;
    BodyCheck check;
    Mesh mesh;
    if (!(check.manifold = fill(mesh, body))) return check;
    for (const auto& [a, b] : self_intersections(mesh))
        check.intersections.push_back({static_cast<std::size_t>(a), static_cast<std::size_t>(b)});
    if (!(check.closed = CGAL::is_closed(mesh))) return check;
    check.volume = processing::volume(mesh);
    // A body that intersects itself bounds no volume in the strict sense, so that only the sign of its volume
    // counts.
    check.outward = check.intersections.empty() ? processing::does_bound_a_volume(mesh) && check.volume > 0
                                                : check.volume > 0;
    return check;
}

}  // namespace sherd
