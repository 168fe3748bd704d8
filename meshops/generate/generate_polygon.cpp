// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "meshops/error.h"
#include "meshops/generate/generate.h"
#include "meshops/generate/spacing.h"
#include "meshops/generate/surface.h"
#include "meshops/random.h"
#include "meshops/topology/split_vertex.h"

namespace sherd {
namespace {

using Eigen::Vector2d;
using Pair = std::array<std::size_t, 2>;

constexpr double nearest_to_side = 0.2;  // edge lengths: smallest distance of a free vertex from a line
constexpr double fewest_around = 5;      // smallest number of edges of a loop with few corners

/// The sides of all lines, sorted into rows for a fast search. The height of a row is the edge length.
class OutlineSides {
  public:
    OutlineSides(const std::vector<Vector2d>& points, const std::vector<Pair>& borders,
                 const std::vector<Pair>& slits, double edge_length)
        : height(edge_length) {
        for (const Vector2d& p : points) box.extend(p);
        rows.resize(row_of(box.max().y()) + 1);
        for (const auto& [a, b] : borders) add({points[a], points[b], true});
        for (const auto& [a, b] : slits) add({points[a], points[b], false});
    }
    const Eigen::AlignedBox2d& bounds() const { return box; }

    /// Whether a point is inside the borders.
    bool enclose(const Vector2d& p) const {
        bool inside = false;
        for (const auto& [a, b, is_border] : rows[row_of(p.y())])
            if (is_border && (a.y() > p.y()) != (b.y() > p.y()))
                inside ^= p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
        return inside;
    }
    /// Whether a point is nearer than `reach` (m) to a line.
    bool is_near(const Vector2d& p, double reach) const {
        return any_in_rows(p.y() - reach, p.y() + reach,
                           [&](const Side& side) { return distance_from_side(p, side.a, side.b) < reach; });
    }
    bool is_crossed(const Vector2d& from, const Vector2d& to) const {
        const auto [lower, upper] = std::minmax(from.y(), to.y());
        return any_in_rows(lower, upper, [&](const Side& side) {
            return left_of(from, to, side.a) != left_of(from, to, side.b) &&
                   left_of(side.a, side.b, from) != left_of(side.a, side.b, to);
        });
    }

  private:
    struct Side {
        Vector2d a, b;
        bool is_border;
    };
    static bool left_of(const Vector2d& a, const Vector2d& b, const Vector2d& p) {
        const Vector2d u = b - a, v = p - a;
        return u.x() * v.y() > u.y() * v.x();
    }
    std::size_t row_of(double y) const {
        const double row = std::floor((std::clamp(y, box.min().y(), box.max().y()) - box.min().y()) / height);
        return static_cast<std::size_t>(row);
    }
    void add(const Side& side) {
        const auto [lower, upper] = std::minmax(side.a.y(), side.b.y());
        for (std::size_t row = row_of(lower); row <= row_of(upper); ++row) rows[row].push_back(side);
    }
    template <class Holds>
    bool any_in_rows(double lower, double upper, Holds holds) const {
        for (std::size_t row = row_of(lower); row <= row_of(upper); ++row)
            if (std::ranges::any_of(rows[row], holds)) return true;
        return false;
    }

    double height;
    Eigen::AlignedBox2d box;
    std::vector<std::vector<Side>> rows;
};

/// The plane, as a surface in which no point moves across a line.
class Region final : public Surface {
  public:
    Region(const OutlineSides& sides, double edge_length) : sides(sides), edge_length(edge_length) {}
    Eigen::Vector3d position(const Vector2d& parameter) const override {
        return {parameter.x(), parameter.y(), 0};
    }
    Vector2d chart(const Vector2d& parameter) const override { return parameter; }
    Vector2d project(const Eigen::Vector3d& point, const Vector2d& near) const override {
        const Vector2d to = point.head<2>();
        const bool is_free = !sides.is_near(to, nearest_to_side * edge_length) && !sides.is_crossed(near, to);
        return is_free ? to : near;
    }

  private:
    const OutlineSides& sides;
    double edge_length;
};

double turn_degrees(const Vector2d& before, const Vector2d& here, const Vector2d& after) {
    const Vector2d u = here - before, v = after - here;
    return std::abs(std::atan2(u.x() * v.y() - u.y() * v.x(), u.dot(v))) * 180 / std::numbers::pi;
}

/// Divides the lines of a polygon into edges, with vertices at all corners and evenly spaced vertices between
/// them.
class Outlines {
  public:
    Outlines(const Polygon& polygon, double edge_length) : edge_length(edge_length) {
        count(polygon.outline);
        for (const auto* lines : {&polygon.holes, &polygon.slits})
            for (const Polyline& line : *lines) count(line);
        add_loop(polygon.outline, "the outline");
        for (std::size_t i = 0; i < polygon.holes.size(); ++i)
            add_loop(polygon.holes[i], "hole " + std::to_string(i + 1));
        for (std::size_t i = 0; i < polygon.slits.size(); ++i)
            add_slit(polygon.slits[i], "slit " + std::to_string(i + 1));
    }

    std::vector<Vector2d> points;
    std::vector<Pair> borders, slits;

  private:
    struct Order {
        bool operator()(const Vector2d& a, const Vector2d& b) const {
            return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
        }
    };

    void count(const Polyline& line) {
        for (const Vector2d& p : line) ++lines_at[p];
    }
    bool is_junction(const Vector2d& p) const { return lines_at.at(p) > 1; }
    std::size_t number_of(const Vector2d& p) {
        const auto [at, is_new] = numbers.try_emplace(p, points.size());
        if (is_new) points.push_back(p);
        return at->second;
    }
    void add_loop(Polyline loop, const std::string& what) {
        const std::size_t size = loop.size();
        std::vector<std::size_t> corners;
        for (std::size_t i = 0; i < size; ++i)
            if (is_junction(loop[i]) || turn_degrees(loop[(i + size - 1) % size], loop[i],
                                                     loop[(i + 1) % size]) > spacing::corner_degrees)
                corners.push_back(i);
        if (corners.size() < 3) {
            Polyline closed = loop;
            closed.push_back(loop.front());
            spacing::require_edge_length(edge_length, length(closed) / fewest_around, what);
        }
        const std::size_t first = corners.empty() ? 0 : corners.front();
        std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(first), loop.end());
        loop.push_back(loop.front());
        std::vector<std::size_t> ends;
        for (const std::size_t corner : corners) ends.push_back(corner - first);
        if (ends.empty()) ends.push_back(0);
        ends.push_back(size);
        const std::size_t least = ends.size() > 3 ? 1 : ends.size() == 3 ? 2 : 3;
        add_sections(loop, ends, least, borders);
    }

    void add_slit(const Polyline& slit, const std::string& what) {
        std::vector<std::size_t> ends;
        const std::size_t last = slit.size() - 1;
        for (std::size_t i = 0; i <= last; ++i)
            if (i == 0 || i == last || is_junction(slit[i]) ||
                turn_degrees(slit[i - 1], slit[i], slit[i + 1]) > spacing::corner_degrees)
                ends.push_back(i);
        // A slit of one edge with both ends inside would not open.
        const bool is_free = !is_junction(slit.front()) && !is_junction(slit.back());
        if (is_free) spacing::require_edge_length(edge_length, length(slit), what);
        add_sections(slit, ends, is_free && ends.size() == 2 ? 2 : 1, slits);
    }

    /// Divides each section of a line between two successive `ends` into `least` edges or more, and adds
    /// these to `edges`.
    void add_sections(const Polyline& line, const std::vector<std::size_t>& ends, std::size_t least,
                      std::vector<Pair>& edges) {
        for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
            const Polyline section(line.begin() + static_cast<std::ptrdiff_t>(ends[i]),
                                   line.begin() + static_cast<std::ptrdiff_t>(ends[i + 1]) + 1);
            const double total = length(section);
            const std::size_t parts = std::max(least, spacing::pieces(total, edge_length));
            std::size_t before = number_of(section.front()), side = 0;
            double passed = 0;  // m, length up to the beginning of the side
            for (std::size_t k = 1; k <= parts; ++k) {
                const double wanted = total * double(k) / double(parts);
                double own = (section[side + 1] - section[side]).norm();
                while (side + 2 < section.size() && passed + own < wanted) {
                    passed += own;
                    ++side;
                    own = (section[side + 1] - section[side]).norm();
                }
                const Vector2d along = section[side + 1] - section[side];
                const std::size_t next =
                    number_of(k == parts ? section.back() : section[side] + (wanted - passed) / own * along);
                edges.push_back({before, next});
                before = next;
            }
        }
    }

    double edge_length;
    std::map<Vector2d, int, Order> lines_at;
    std::map<Vector2d, std::size_t, Order> numbers;
};

/// Adds free points between the lines at random, at most one in each cell of a grid.
void fill(const OutlineSides& sides, const GenerateOptions& options, std::vector<Vector2d>& points) {
    const double cell = spacing::row_height / std::sqrt(spacing::crowding) * options.edge_length;
    const Vector2d lower = sides.bounds().min(), size = sides.bounds().sizes();
    Random random(options.seed);
    for (double y = 0; y < size.y(); y += cell)
        for (double x = 0; x < size.x(); x += cell) {
            const double right = random.uniform(), up = random.uniform();
            const Vector2d p = lower + Vector2d(x + cell * right, y + cell * up);
            if (sides.bounds().contains(p) && sides.enclose(p) &&
                !sides.is_near(p, spacing::half_row * options.edge_length))
                points.push_back(p);
        }
}

void open(Mesh& mesh, const std::vector<Pair>& slits) {
    std::vector<char> cut(mesh.number_of_edges(), 0);
    std::vector<Vertex> vertices;
    for (const Pair& slit : slits) {
        const Vertex a(static_cast<Mesh::size_type>(slit[0])), b(static_cast<Mesh::size_type>(slit[1]));
        cut[mesh.edge(mesh.halfedge(a, b))] = 1;
        vertices.insert(vertices.end(), {a, b});
    }
    std::ranges::sort(vertices);
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    split_vertices(mesh, vertices, [&](Edge edge) { return edge.idx() < cut.size() && cut[edge]; });
}

}  // namespace

Mesh generate_polygon(const Polygon& polygon, const GenerateOptions& options) {
    if (const auto fault = fault_of(polygon))
        throw Error("cannot generate the mesh: " + fault->part + ": " + fault->what);
    const Outlines outlines(with_junctions(polygon), options.edge_length);
    const OutlineSides sides(outlines.points, outlines.borders, outlines.slits, options.edge_length);
    SurfacePoints points;
    points.parameter = outlines.points;
    points.fixed = outlines.points.size();
    points.borders = outlines.borders;
    points.creases = outlines.slits;
    fill(sides, options, points.parameter);
    Mesh mesh = relax(Region(sides, options.edge_length), std::move(points), spacing::iterations);
    open(mesh, outlines.slits);
    return mesh;
}

}  // namespace sherd
