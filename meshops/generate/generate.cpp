// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/generate/generate.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "meshops/error.h"
#include "meshops/generate/revolution.h"
#include "meshops/generate/spacing.h"
#include "meshops/mesh_measures.h"
#include "meshops/random.h"

namespace sherd {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
constexpr double pi = std::numbers::pi;
using spacing::pieces, spacing::text;
constexpr double narrowest_band = 0.7;  // edge lengths, smallest distance between fixed circles

void require(double value, bool holds, const char* what, const char* condition) {
    if (!holds || !std::isfinite(value)) {
        throw Error(std::string("cannot generate the mesh: ") + what + " must be " + condition + ", not " +
                    text(value));
    }
}

void require_positive(double value, const char* what) {
    require(value, value > 0, what, "positive");
}

void require_edge_length(const GenerateOptions& options, double largest) {
    require_positive(options.edge_length, "edge_length");
    spacing::require_edge_length(options.edge_length, largest, "the shape");
}

void require_delaunay(const GenerateOptions& options, const char* shape) {
    if (options.layout == Layout::delaunay) return;
    throw Error(std::string("cannot generate the mesh: there is no structured layout of a ") + shape +
                ", only of a rectangle, a cylinder and a sector of a revolution");
}

/// Returns the number of vertices to add to `boundary` vertices so that triangles with edges of `edge_length`
/// (m) cover `area` (m^2), by Euler's formula. characteristic: Euler characteristic of the surface, 0 for a
/// ring, 1 for a disc, 2 for a sphere.
std::size_t free_vertices(double area, double edge_length, std::size_t boundary, int characteristic) {
    const double faces = spacing::crowding * area / (std::sqrt(3.0) / 4 * edge_length * edge_length);
    const double inner = (faces - static_cast<double>(boundary)) / 2 + characteristic;
    return static_cast<std::size_t>(std::max(0L, std::lround(inner)));
}

class Rectangle final : public Surface {
  public:
    Vector3d position(const Vector2d& parameter) const override { return {parameter.x(), parameter.y(), 0}; }
    Vector2d chart(const Vector2d& parameter) const override { return parameter; }
    Vector2d project(const Vector3d& point, const Vector2d&) const override { return point.head<2>(); }
};

/// Returns evenly spaced points around the rectangle, counterclockwise from the origin.
std::vector<Vector2d> outline(const Vector2d& size, double edge_length) {
    const std::size_t nx = pieces(size.x(), edge_length), ny = pieces(size.y(), edge_length);
    const auto part = [](std::size_t i, std::size_t n) { return double(i) / double(n); };
    std::vector<Vector2d> result;
    for (std::size_t i = 0; i < nx; ++i) result.emplace_back(size.x() * part(i, nx), 0);
    for (std::size_t i = 0; i < ny; ++i) result.emplace_back(size.x(), size.y() * part(i, ny));
    for (std::size_t i = nx; i > 0; --i) result.emplace_back(size.x() * part(i, nx), size.y());
    for (std::size_t i = ny; i > 0; --i) result.emplace_back(0, size.y() * part(i, ny));
    return result;
}

SurfacePoints spread(const Vector2d& size, const GenerateOptions& options) {
    SurfacePoints points;
    points.parameter = outline(size, options.edge_length);
    points.fixed = points.parameter.size();
    const auto count = free_vertices(size.prod(), options.edge_length, points.fixed, 1);
    const Vector2d margin = (spacing::half_row * options.edge_length * Vector2d::Ones()).cwiseMin(size / 4);
    const Vector2d inner = size - 2 * margin;
    const std::size_t rows = std::min(count, pieces(inner.y(), spacing::row_height * options.edge_length));
    Random random(options.seed);
    for (std::size_t row = 0; row < rows; ++row) {
        const std::size_t columns = count * (row + 1) / rows - count * row / rows;
        for (std::size_t column = 0; column < columns; ++column) {
            const double x = (double(column) + random.uniform()) / double(columns);
            const double y = (double(row) + random.uniform()) / double(rows);
            points.parameter.push_back(margin + Vector2d(x, y).cwiseProduct(inner));
        }
    }
    return points;
}

/// Returns a grid of nx by ny cells with parallel diagonals; in a closed grid the last column is joined to
/// the first.
template <typename Position>
Mesh grid(std::size_t nx, std::size_t ny, bool is_closed, Position position) {
    Mesh mesh;
    const std::size_t columns = is_closed ? nx : nx + 1;
    for (std::size_t j = 0; j <= ny; ++j) {
        for (std::size_t i = 0; i < columns; ++i) {
            const Vector3d p = position(double(i) / double(nx), double(j) / double(ny));
            mesh.add_vertex(point_at(p));
        }
    }
    const auto vertex = [&](std::size_t i, std::size_t j) {
        return Vertex(Mesh::size_type(j * columns + i % columns));
    };
    for (std::size_t j = 0; j < ny; ++j) {
        for (std::size_t i = 0; i < nx; ++i) {
            mesh.add_face(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
            mesh.add_face(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
        }
    }
    return mesh;
}

void check_profile(std::span<const Vector2d> profile) {
    const auto fail = [](const std::string& what) {
        throw Error("cannot generate the surface of revolution: " + what);
    };
    if (profile.size() < 2) fail("its profile needs at least two points");
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const std::string point = "profile point " + std::to_string(i);
        if (!profile[i].allFinite()) fail(point + " has a coordinate that is NaN or infinite");
        if (profile[i].x() < 0) fail(point + " has a negative radius, " + text(profile[i].x()));
        if (profile[i].x() == 0 && i > 0 && i + 1 < profile.size()) {
            fail(point + " lies on the axis; only the first and the last may");
        }
        if (i > 0 && profile[i] == profile[i - 1]) fail(point + " repeats the one before");
    }
    if (profile.size() == 2 && profile[0].x() == 0 && profile[1].x() == 0)
        fail("its profile lies on the axis");
}

/// Returns the largest possible edge length, m: five edges fit around every neck and rim, and one along the
/// profile.
double largest_edge_length(std::span<const Vector2d> profile, double length) {
    double largest = length;
    for (std::size_t i = 0; i < profile.size(); ++i) {
        const bool is_above_before = i == 0 || profile[i - 1].x() >= profile[i].x();
        const bool is_above_after = i + 1 == profile.size() || profile[i + 1].x() >= profile[i].x();
        const bool is_rim = i == 0 || i + 1 == profile.size();
        if (profile[i].x() > 0 && ((is_above_before && is_above_after) || is_rim)) {
            largest = std::min(largest, 2 * pi * profile[i].x() / 5);
        }
    }
    return largest;
}

/// Returns the arc lengths (m) of the circles with fixed vertices: both ends of the profile, and corners that
/// are wide enough and not too close to another circle.
std::vector<double> fixed_circles(const Revolution& surface, double edge_length) {
    std::vector<double> circles{0};
    for (const double corner : surface.corners(spacing::corner_degrees)) {
        const bool is_wide = 2 * pi * surface.radius(corner) >= 5 * edge_length;
        const double nearest = std::min(corner - circles.back(), surface.length() - corner);
        if (is_wide && nearest >= narrowest_band * edge_length) circles.push_back(corner);
    }
    circles.push_back(surface.length());
    return circles;
}

/// Distributes points over a surface of revolution, or a sector of one: circles of fixed vertices, the sides
/// of a sector, and rows between them.
class RevolutionSpread {
  public:
    /// angle: rad, angle of the sector; 2 pi for a whole surface.
    RevolutionSpread(const Revolution& surface, double angle, const GenerateOptions& options)
        : surface(surface),
          angle(angle),
          is_whole(angle == 2 * pi),
          edge_length(options.edge_length),
          random(options.seed) {}

    SurfacePoints spread() {
        const auto circles = fixed_circles(surface, edge_length);
        for (std::size_t i = 0; i < circles.size(); ++i) {
            const bool is_rim = i == 0 || i + 1 == circles.size();
            counts.push_back(add_circle(circles[i], is_rim));
            if (i == 0 && counts[0] > 1 && is_whole) points.hole = counts[0];
        }
        for (std::size_t i = 0; i + 1 < circles.size() && !is_whole; ++i)
            counts[i] += add_sides(circles[i], circles[i + 1]);
        points.fixed = points.parameter.size();
        for (std::size_t i = 0; i + 1 < circles.size(); ++i) fill_band(i, circles[i], circles[i + 1]);
        return std::move(points);
    }

  private:
    /// Adds the circle at an arc length (m). Returns the number of its vertices, which is 1 on the axis.
    std::size_t add_circle(double along, bool is_rim) {
        const double radius = surface.radius(along);
        if (radius == 0 && along > 0) {
            points.is_closed = true;
            points.closing_point = surface.position({along, 0});
            return 1;
        }
        const std::size_t first = points.parameter.size();
        const std::size_t edges = radius == 0 ? 1 : pieces(angle * radius, edge_length);
        const double phase = is_whole ? random.uniform() : 0;
        const std::size_t count = is_whole ? edges : edges + 1;
        for (std::size_t i = 0; i < count; ++i) {
            const double around = i == edges ? angle : angle * (double(i) + phase) / double(edges);
            points.parameter.emplace_back(along, around);
            if (!is_rim && i < edges) points.creases.push_back({first + i, first + (i + 1) % count});
        }
        return count;
    }

    /// Adds vertices on the two sides of a sector between two circles, but not on these. Returns their
    /// number.
    std::size_t add_sides(double from, double to) {
        const std::size_t edges = pieces(to - from, edge_length);
        for (std::size_t i = 1; i < edges; ++i)
            for (const double side : {0.0, angle})
                points.parameter.emplace_back(from + (to - from) * double(i) / double(edges), side);
        return 2 * (edges - 1);
    }

    void fill_band(std::size_t band, double from, double to) {
        const std::size_t below = counts[band], above = counts[band + 1];
        const int poles = int(below == 1) + int(above == 1);
        const std::size_t boundary = (below > 1 ? below : 0) + (above > 1 ? above : 0);
        const double area = (is_whole ? 1 : angle / (2 * pi)) * surface.area(from, to);
        const std::size_t wanted = free_vertices(area, edge_length, boundary, is_whole ? poles : 1);
        const std::size_t count = wanted - std::min(wanted, std::size_t(poles));
        const double margin = std::min(spacing::half_row * edge_length, (to - from) / 4);
        fill(from + margin, to - margin, count);
    }

    void fill(double from, double to, std::size_t count) {
        const std::size_t rows = std::min(count, pieces(to - from, spacing::row_height * edge_length));
        const double height = (to - from) / double(rows), total = surface.area(from, to);
        std::size_t done = 0;
        for (std::size_t row = 0; row < rows; ++row) {
            const double share = surface.area(from, from + double(row + 1) * height) / total;
            const auto until = row + 1 == rows ? count : std::size_t(std::lround(share * double(count)));
            const std::size_t columns = until - done;
            for (std::size_t column = 0; done < until; ++done, ++column) {
                const double turn = is_whole ? double(done) : double(column);
                const double around = angle * (turn + random.uniform()) / double(columns);
                const double along = from + (double(row) + random.uniform()) * height;
                points.parameter.emplace_back(along, between_sides(around, along));
            }
        }
    }

    /// Maps an angle of the sector to a narrower range, which leaves space for the vertices on the sides of
    /// the sector.
    double between_sides(double around, double along) const {
        if (is_whole) return around;
        const double margin = std::min(spacing::half_row * edge_length / surface.radius(along), angle / 4);
        return margin + around * (1 - 2 * margin / angle);
    }

    const Revolution& surface;
    double angle;
    bool is_whole;
    double edge_length;
    Random random;
    SurfacePoints points;
    std::vector<std::size_t> counts;  ///< number of vertices on each circle and the sides up to the next
};

constexpr double whole_turn = 360;  // degrees

Mesh revolve(std::span<const Vector2d> profile, double degrees, const GenerateOptions& options) {
    const double angle = degrees / whole_turn * (2 * pi);
    // In one iteration, a vertex never moves by more than the length of its edges.
    const Revolution surface(profile, 2 * options.edge_length);
    const bool is_whole = degrees == whole_turn;
    require_edge_length(options,
                        is_whole ? largest_edge_length(profile, surface.length()) : surface.length());
    constexpr double largest_range = 300;
    if (surface.chart_range() > largest_range) {
        throw Error("cannot generate the surface of revolution: it is too slender, more than " +
                    text(largest_range) + " radii long");
    }
    if (options.layout == Layout::structured) {
        const auto place = [&](double along, double around) {
            return surface.position({along * surface.length(), around * angle});
        };
        const double middle = surface.area(0, surface.length()) / (2 * pi * surface.length());
        return grid(pieces(surface.length(), options.edge_length),
                    pieces(angle * middle, options.edge_length), false, place);
    }
    const SurfacePoints points = RevolutionSpread(surface, angle, options).spread();
    if (is_whole) return relax(surface, points, spacing::iterations);
    return relax(RevolutionSector(surface), points, spacing::iterations);
}

}  // namespace

Mesh generate_rectangle(double width, double height, const GenerateOptions& options) {
    require_positive(width, "width");
    require_positive(height, "height");
    require_edge_length(options, std::min(width, height));
    if (options.layout == Layout::delaunay) {
        return relax(Rectangle(), spread({width, height}, options), spacing::iterations);
    }
    return grid(pieces(width, options.edge_length), pieces(height, options.edge_length), false,
                [&](double x, double y) { return Vector3d(width * x, height * y, 0); });
}

Mesh generate_disc(double radius, const GenerateOptions& options) {
    require_positive(radius, "radius");
    require_delaunay(options, "disc");
    require_edge_length(options, radius);
    return revolve(std::array{Vector2d(0, 0), Vector2d(radius, 0)}, whole_turn, options);
}

Mesh generate_cylinder(double radius, double height, const GenerateOptions& options) {
    require_positive(radius, "radius");
    require_positive(height, "height");
    require_edge_length(options, std::min(radius, height));
    if (options.layout == Layout::delaunay) {
        return revolve(std::array{Vector2d(radius, height), Vector2d(radius, 0)}, whole_turn, options);
    }
    return grid(pieces(2 * pi * radius, options.edge_length), pieces(height, options.edge_length), true,
                [&](double x, double z) {
                    return Vector3d(radius * std::cos(2 * pi * x), radius * std::sin(2 * pi * x), height * z);
                });
}

Mesh generate_sphere(double radius, const GenerateOptions& options) {
    require_positive(radius, "radius");
    require_delaunay(options, "sphere");
    require_edge_length(options, radius);
    // The profile is so fine a polygon that moving the vertices onto the sphere at the end has no visible
    // effect.
    const auto count = std::size_t(std::ceil(pi / std::sqrt(1e-3 * options.edge_length / radius)));
    std::vector<Vector2d> profile{{0, radius}};
    for (std::size_t i = 1; i < count; ++i) {
        const double angle = pi * double(i) / double(count);
        profile.emplace_back(radius * std::sin(angle), radius * std::cos(angle));
    }
    profile.emplace_back(0, -radius);
    Mesh mesh = revolve(profile, whole_turn, options);
    for (const Vertex v : mesh.vertices()) {
        const auto arm = mesh.point(v) - CGAL::ORIGIN;
        mesh.point(v) = CGAL::ORIGIN + arm * (radius / std::sqrt(arm.squared_length()));
    }
    return mesh;
}

Mesh generate_revolution(std::span<const Vector2d> profile, const GenerateOptions& options, double degrees) {
    check_profile(profile);
    require_positive(options.edge_length, "edge_length");
    require(degrees, degrees > 0 && degrees <= whole_turn, "angle", "above 0 and at most 360 degrees");
    if (degrees == whole_turn) {
        require_delaunay(options, "whole surface of revolution");
    } else if (profile.front().x() == 0 || profile.back().x() == 0) {
        throw Error("cannot generate the surface of revolution: a sector's profile must not touch the axis");
    }
    return revolve(profile, degrees, options);
}

}  // namespace sherd
