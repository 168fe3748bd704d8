// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/render_solid.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>

namespace sherd {
namespace {

using Eigen::Vector3f;

constexpr double on_edge = 1e-9;  // tolerance of barycentric coordinates

Vector3d face_normal(const Positions& position, const std::array<Index, 3>& face) {
    const Vector3d a = position.col(face[0]);
    const Vector3d normal = (position.col(face[1]) - a).cross(position.col(face[2]) - a);
    const double length = normal.norm();
    return length > 0 ? Vector3d(normal / length) : Vector3d::UnitZ();
}

double corner_angle(const Positions& position, const std::array<Index, 3>& face, int corner) {
    const Vector3d p = position.col(face[corner]);
    const Vector3d a = position.col(face[(corner + 1) % 3]) - p, b = position.col(face[(corner + 2) % 3]) - p;
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Returns unit normals at the vertices, [3, V]: means of the normals of the faces around a vertex, weighted
/// by the faces' angles there.
Positions vertex_normals(const Positions& position, std::span<const std::array<Index, 3>> faces) {
    Positions normals = Positions::Zero(3, position.cols());
    for (const auto& face : faces) {
        const Vector3d normal = face_normal(position, face);
        for (int k = 0; k < 3; ++k) normals.col(face[k]) += corner_angle(position, face, k) * normal;
    }
    for (Eigen::Index v = 0; v < normals.cols(); ++v) normals.col(v).normalize();
    return normals;
}

/// Returns the distance, m, by which each vertex moves to both sides along its normal, [V]. The distance is
/// larger at folds, so that each moved face is half the thickness away from its original place.
VectorXd vertex_offsets(const Positions& normals, const Snapshot& frame, std::span<const double> thickness) {
    constexpr double least_cosine = 0.5;  // avoids spikes on sharp folds
    VectorXd cosine = VectorXd::Ones(normals.cols()), offset = VectorXd::Zero(normals.cols());
    std::vector<int> met(normals.cols(), 0);
    for (std::size_t f = 0; f < frame.faces.size(); ++f) {
        const Vector3d normal = face_normal(frame.position, frame.faces[f]);
        for (const Index v : frame.faces[f]) {
            cosine[v] = std::min(cosine[v], std::max(least_cosine, normal.dot(normals.col(v))));
            offset[v] += (thickness[f] / 2 - offset[v]) / ++met[v];  // mean of the faces around the vertex
        }
    }
    return offset.cwiseQuotient(cosine);
}

class SolidBuilder {
  public:
    SolidBuilder(const Snapshot& frame, std::span<const double> thickness, const SheetPaint& paint,
                 const Vector3d& origin)
        : frame(frame),
          paint(paint),
          origin(origin),
          normals(vertex_normals(frame.position, frame.faces)),
          rest_normals(vertex_normals(frame.rest.position, frame.rest.faces)),
          offsets(vertex_offsets(normals, frame, thickness)),
          open(open_edges(frame.faces)),
          rim(rim_edges(frame.rest)) {}

    RenderMesh build() {
        mesh.striped = paint.stripe.size() > 0;
        mesh.pictures = paint.pictures;
        mesh.striped || !paint.corner_colour.empty() ? add_sides_by_face() : add_sides();
        add_walls();
        return std::move(mesh);
    }

  private:
    /// side: 1 for the side of the normals, -1 for the opposite side.
    RenderVertex vertex(Index v, double side) const;
    RenderVertex corner(std::size_t f, int k, double side) const;
    void add_sides();
    void add_walls();
    void add_sides_by_face();
    void add_triangle(const std::array<std::uint32_t, 3>& corners, std::size_t f, bool broken = false);
    void add_wall(std::size_t f, int k, const std::array<Vector3d, 2>& outward, bool broken);
    Vector3d outward(Index a, Index b) const;

    const Snapshot& frame;
    const SheetPaint& paint;
    Vector3d origin;
    Positions normals, rest_normals;
    VectorXd offsets;
    std::vector<std::array<bool, 3>> open, rim;
    RenderMesh mesh;
};

RenderVertex SolidBuilder::vertex(Index v, double side) const {
    const Index rest = frame.original[v];
    RenderVertex vertex;
    vertex.position = (frame.position.col(v) - origin + side * offsets[v] * normals.col(v)).cast<float>();
    vertex.normal = (side * normals.col(v)).cast<float>();
    vertex.colour = paint.colour[v];
    vertex.material =
        (frame.rest.position.col(rest) + side * offsets[v] * rest_normals.col(rest)).cast<float>();
    return vertex;
}

RenderVertex SolidBuilder::corner(std::size_t f, int k, double side) const {
    RenderVertex corner = vertex(frame.faces[f][k], side);
    if (mesh.striped) corner.stripe = paint.stripe(k, f);
    if (!paint.corner_colour.empty()) corner.colour = paint.corner_colour[f][k];
    if (!paint.texture.empty()) corner.texture = paint.texture[f][k].cast<float>();
    return corner;
}

/// Adds a triangle of the face f. A broken wall shows no picture.
void SolidBuilder::add_triangle(const std::array<std::uint32_t, 3>& corners, std::size_t f, bool broken) {
    mesh.triangles.push_back(corners);
    if (!paint.picture.empty()) mesh.picture.push_back(broken ? -1 : paint.picture[f]);
}

/// Adds both sides of the sheets. Each face has vertices of its own, since stripe numbers and colours may
/// jump between faces.
void SolidBuilder::add_sides_by_face() {
    for (std::size_t f = 0; f < frame.faces.size(); ++f)
        for (const double side : {1.0, -1.0}) {
            const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
            for (const int k : {0, side > 0 ? 1 : 2, side > 0 ? 2 : 1})
                mesh.vertices.push_back(corner(f, k, side));
            add_triangle({first, first + 1, first + 2}, f);
        }
}

void SolidBuilder::add_sides() {
    const auto count = static_cast<Index>(frame.position.cols());
    for (const double side : {1.0, -1.0})
        for (Index v = 0; v < count; ++v) mesh.vertices.push_back(vertex(v, side));
    for (const auto& [a, b, c] : frame.faces) {
        const auto n = static_cast<std::uint32_t>(count), i = static_cast<std::uint32_t>(a),
                   j = static_cast<std::uint32_t>(b), k = static_cast<std::uint32_t>(c);
        mesh.triangles.push_back({i, j, k});
        mesh.triangles.push_back({n + i, n + k, n + j});
    }
}

/// Returns a unit vector in the surface, at right angles to the edge from a to b, that points away from the
/// face to the left of the edge.
Vector3d SolidBuilder::outward(Index a, Index b) const {
    return (frame.position.col(b) - frame.position.col(a))
        .cross(normals.col(a) + normals.col(b))
        .normalized();
}

void SolidBuilder::add_walls() {
    const auto each = [this](const auto& visit) {
        for (std::size_t f = 0; f < frame.faces.size(); ++f)
            for (int k = 0; k < 3; ++k)
                if (open[f][k]) visit(f, k, frame.faces[f][k], frame.faces[f][(k + 1) % 3], !rim[f][k]);
    };
    // Walls on the rim of the unfractured mesh are shaded smoothly, broken walls are not.
    Positions smooth = Positions::Zero(3, frame.position.cols());
    each([&](std::size_t, int, Index a, Index b, bool broken) {
        if (broken) return;
        for (const Index v : {a, b}) smooth.col(v) += outward(a, b);
    });
    each([&](std::size_t f, int k, Index a, Index b, bool broken) {
        const Vector3d flat = outward(a, b);
        std::array<Vector3d, 2> normal{flat, flat};
        for (const int end : {0, 1}) {
            const Vector3d round = smooth.col(end == 0 ? a : b).normalized();
            if (!broken && round.dot(flat) > 0.85) normal[end] = round;
        }
        add_wall(f, k, normal, broken);
    });
}

void SolidBuilder::add_wall(std::size_t f, int k, const std::array<Vector3d, 2>& outward, bool broken) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const auto& [end, side] :
         {std::pair{0, -1.0}, std::pair{1, -1.0}, std::pair{1, 1.0}, std::pair{0, 1.0}}) {
        mesh.vertices.push_back(corner(f, (k + end) % 3, side));
        mesh.vertices.back().normal = outward[end].cast<float>();
        mesh.vertices.back().broken = broken;
    }
    add_triangle({first, first + 1, first + 2}, f, broken);
    add_triangle({first, first + 2, first + 3}, f, broken);
}

}  // namespace

std::vector<std::array<bool, 3>> open_edges(std::span<const std::array<Index, 3>> faces) {
    struct Side {
        Index low, high;
        std::size_t face;
        int corner;
    };
    std::vector<Side> sides;
    for (std::size_t f = 0; f < faces.size(); ++f)
        for (int k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(faces[f][k], faces[f][(k + 1) % 3]);
            sides.push_back({low, high, f, k});
        }
    std::ranges::sort(sides, {}, [](const Side& s) { return std::tuple(s.low, s.high, s.face); });
    std::vector<std::array<bool, 3>> open(faces.size(), {false, false, false});
    const auto same = [&](std::size_t i, std::size_t j) {
        return sides[i].low == sides[j].low && sides[i].high == sides[j].high;
    };
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const bool shared = (i > 0 && same(i - 1, i)) || (i + 1 < sides.size() && same(i, i + 1));
        if (!shared) open[sides[i].face][sides[i].corner] = true;
    }
    return open;
}

std::vector<std::array<bool, 3>> rim_edges(const RestMesh& rest) {
    const std::vector<std::array<bool, 3>> unbroken = open_edges(rest.unfractured_faces);
    std::vector<std::array<bool, 3>> rim(rest.faces.size(), {false, false, false});
    for (std::size_t f = 0; f < rest.faces.size(); ++f)
        for (int k = 0; k < 3; ++k) {
            const Vector3d a = place_in_parent(rest, f, k), b = place_in_parent(rest, f, (k + 1) % 3);
            for (int side = 0; side < 3; ++side) {
                const int opposite = (side + 2) % 3;
                if (std::abs(a[opposite]) < on_edge && std::abs(b[opposite]) < on_edge)
                    rim[f][k] = unbroken[rest.face_parent[f]][side];
            }
        }
    return rim;
}

RenderMesh sheet_solid(const Snapshot& frame, std::span<const double> thickness, const SheetPaint& paint,
                       const Vector3d& origin) {
    return SolidBuilder(frame, thickness, paint, origin).build();
}

}  // namespace sherd
