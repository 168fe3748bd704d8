// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/assemble/sheet/material_axes.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "app/messages/place_text.h"
#include "app/scene/assemble/sheet/axis_texture.h"
#include "app/scene/assemble/sheet/map_values.h"
#include "meshops/attributes.h"
#include "meshops/error.h"
#include "meshops/mesh_measures.h"
#include "meshops/read_write/read_mesh.h"

namespace sherd {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

struct FaceShape {
    Eigen::Matrix<double, 3, 2> edges;  ///< m, from the first corner to the other two
    Vector3d normal;
};

FaceShape shape_of(const Mesh& mesh, Face face) {
    std::array<Vector3d, 3> corners;
    int i = 0;
    for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(face))) corners[i++] = position(mesh, v);
    FaceShape shape;
    shape.edges << corners[1] - corners[0], corners[2] - corners[0];
    shape.normal = shape.edges.col(0).cross(shape.edges.col(1)).normalized();
    return shape;
}

Vector3d turned(const Vector3d& tangent, const Vector3d& normal, double angle) {
    return std::cos(angle) * tangent + std::sin(angle) * normal.cross(tangent);
}

/// Returns the unit vector along the projection of a direction to a face; none if the direction is
/// perpendicular to the face. normal: of the face, a unit vector.
std::optional<Vector3d> projected(const Vector3d& direction, const Vector3d& normal) {
    const Vector3d tangent = direction - direction.dot(normal) * normal;
    constexpr double perpendicular = 1e-6;  // rad
    if (tangent.norm() < perpendicular * direction.norm()) return std::nullopt;
    return tangent.normalized();
}

/// Projects a direction in the mesh's own frame to faces of the placed mesh.
class Projection {
  public:
    Projection(const Vector3d& direction, const Eigen::Isometry3d& place) : turn(place.linear()) {
        for (const Vector3d& own : {direction, Vector3d(Vector3d::UnitY()), Vector3d(Vector3d::UnitZ()),
                                    Vector3d(Vector3d::UnitX())})
            candidates.push_back(turn * own);
    }

    Vector3d on(Face face, const Vector3d& normal) {
        for (const Vector3d& candidate : candidates)
            if (const std::optional<Vector3d> tangent = projected(candidate, normal)) {
                if (&candidate != &candidates.front()) replaced.push_back(face);
                return *tangent;
            }
        throw Error(fmt::format("face {} has no normal", face.idx()), Fault::run);
    }
    std::vector<Face> replaced;  ///< faces perpendicular to the direction, for which another one was used

  private:
    Eigen::Matrix3d turn;
    std::vector<Vector3d> candidates;
};

std::vector<Vector3d> axes_of(const AxisDirection& axis, const Mesh& mesh, const Eigen::Isometry3d& place,
                              std::vector<std::string>& warnings) {
    Projection projection(axis.direction, place);
    std::vector<Vector3d> axes;
    for (const Face face : mesh.faces()) {
        const Vector3d normal = shape_of(mesh, face).normal;
        axes.push_back(turned(projection.on(face, normal), normal, axis.degrees * std::numbers::pi / 180));
    }
    if (!projection.replaced.empty())
        warnings.push_back(
            fmt::format("the axis is perpendicular to {} faces (the first: {}): there the mesh's y axis, or "
                        "z, is used instead; give a direction along the surface, or a texture",
                        projection.replaced.size(), face_text(mesh, projection.replaced.front())));
    return axes;
}

/// Returns the axis in a face at `angle` (rad) from the direction along which u grows and v is constant,
/// counted towards the direction along which v grows. corners: texture coordinates of the face's corners.
Vector3d axis_over_texture(const FaceTexture& corners, double angle, const Mesh& mesh, Face face) {
    const FaceShape shape = shape_of(mesh, face);
    Eigen::Matrix2d texture;
    texture << corners[1] - corners[0], corners[2] - corners[0];
    const double area = texture.determinant();
    if (!(std::abs(area) > 1e-12 * texture.col(0).norm() * texture.col(1).norm()))
        throw Error(fmt::format("the texture coordinates of {} have no area: unwrap the mesh again",
                                face_text(mesh, face)));
    const Vector3d along_u = shape.edges * Vector2d(texture(1, 1), -texture(1, 0)) / area;
    return turned(along_u.normalized(), shape.normal, area > 0 ? angle : -angle);
}

std::vector<Vector3d> axes_of(const AxisTexture& axis, const Mesh& mesh, const Eigen::Isometry3d&,
                              std::vector<std::string>&) {
    const Image image = read_png(axis.path);
    const auto texture = texture_coordinates(mesh);
    std::vector<Vector3d> axes;
    for (const Face face : mesh.faces()) {
        const FaceTexture& corners = texture[face];
        const Vector2d doubled =
            doubled_direction(image, axis.encoding, (corners[0] + corners[1] + corners[2]) / 3);
        if (doubled.norm() < 0.02)
            throw Error(fmt::format("{} has no direction on {}: grey, or opposite directions side by side",
                                    axis.path.string(), face_text(mesh, face)));
        const double angle = std::atan2(doubled.y(), doubled.x()) / 2;
        axes.push_back(axis_over_texture(corners, angle, mesh, face));
    }
    return axes;
}

std::vector<Vector3d> axes_of(const AxisField&, const Mesh& mesh, const Eigen::Isometry3d& place,
                              std::vector<std::string>&) {
    const auto [field, exists] = find_property(mesh, attribute::axis);
    if (!exists)
        throw Error(
            "the mesh has no axes: give a PLY file with face properties axis_x, axis_y and axis_z of type "
            "float or double");
    std::vector<Vector3d> axes;
    for (const Face face : mesh.faces()) {
        const Vector3d given = field[face];
        const std::optional<Vector3d> tangent =
            given.allFinite() && !given.isZero(0)
                ? projected(place.linear() * given.stableNormalized(), shape_of(mesh, face).normal)
                : std::nullopt;
        if (!tangent)
            throw Error(fmt::format("the axis of {}, [{}, {}, {}], has no direction in the face's plane",
                                    face_text(mesh, face), given.x(), given.y(), given.z()));
        axes.push_back(*tangent);
    }
    return axes;
}

}  // namespace

std::vector<Vector3d> material_axes(const MaterialAxis& axis, const Mesh& placed,
                                    const Eigen::Isometry3d& place, std::vector<std::string>& warnings) {
    std::vector<std::string> found;
    std::vector<Vector3d> axes = with_context(axis.where, [&] {
        return std::visit([&](const auto& kind) { return axes_of(kind, placed, place, found); }, axis.kind);
    });
    for (const std::string& warning : found) warnings.push_back(fmt::format("{}: {}", axis.where, warning));
    return axes;
}

}  // namespace sherd
