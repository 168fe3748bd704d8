// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/generate/moving_delaunay.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>

#include "meshops/error.h"
#include "meshops/mesh_measures.h"

namespace sherd {
namespace {

using Point2 = Kernel::Point_2;

/// If more than a tenth of the points have to be inserted again, a new triangulation is faster.
constexpr std::size_t many = 10;

Point2 place_of(const Surface& surface, const Eigen::Vector2d& parameter) {
    const Eigen::Vector2d place = surface.chart(parameter);
    return {place.x(), place.y()};
}

}  // namespace

void throw_generation_error() {
    throw Error("the mesh cannot be generated: edge_length is too large for the shape");
}

struct MovingDelaunay::Triangulation {
    using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
    /// Whether a face lies outside or inside of the borders.
    enum class Where : char { unknown, outside, inside };
    using CreasedFace =
        CGAL::Triangulation_face_base_with_info_2<Where, Kernel,
                                                  CGAL::Constrained_triangulation_face_base_2<Kernel>>;
    using CreasedDelaunay = CGAL::Constrained_Delaunay_triangulation_2<
        Kernel, CGAL::Triangulation_data_structure_2<VertexBase, CreasedFace>>;
    using FaceHandle = CreasedDelaunay::Face_handle;
    using VertexHandle = CreasedDelaunay::Vertex_handle;

    CreasedDelaunay all;
    std::vector<VertexHandle> handle;  ///< vertex of each point

    /// Flips edges until the triangulation is Delaunay. Requires that no triangle is turned over.
    void flip_edges();
    /// Puts moved points back to their earlier places until no triangle is turned over. Returns the numbers
    /// of these points. before: earlier places of the points, except the first `fixed`, which have not moved.
    std::vector<std::size_t> put_back(const std::vector<Point2>& before, std::size_t fixed);
};

void MovingDelaunay::Triangulation::flip_edges() {
    std::vector<FaceHandle> open;
    const auto flip = [&](FaceHandle face, int side) {
        const FaceHandle other = face->neighbor(side);
        all.flip(face, side);
        open.insert(open.end(), {face, other});
    };
    for (const FaceHandle first : all.finite_face_handles()) {
        open.push_back(first);
        while (!open.empty()) {
            const FaceHandle face = open.back();
            open.pop_back();
            for (int side = 0; side < 3; ++side)
                if (all.is_flipable(face, side)) {
                    flip(face, side);
                    break;
                }
        }
    }
}

std::vector<std::size_t> MovingDelaunay::Triangulation::put_back(const std::vector<Point2>& before,
                                                                 std::size_t fixed) {
    std::vector<char> is_back(handle.size(), 0);
    std::vector<std::size_t> back;
    for (bool all_right = false; !all_right;) {
        all_right = true;
        for (const auto face : all.finite_face_handles()) {
            if (CGAL::orientation(face->vertex(0)->point(), face->vertex(1)->point(),
                                  face->vertex(2)->point()) == CGAL::LEFT_TURN)
                continue;
            all_right = false;
            for (int corner = 0; corner < 3; ++corner) {
                const std::size_t i = face->vertex(corner)->info();
                if (i < fixed || is_back[i] != 0) continue;
                is_back[i] = 1;
                back.push_back(i);
                handle[i]->point() = before[i];
            }
        }
    }
    return back;
}

MovingDelaunay::MovingDelaunay(const Surface& surface, const SurfacePoints& points)
    : surface(surface), points(points) {
    make();
}

MovingDelaunay::~MovingDelaunay() = default;

void MovingDelaunay::make() {
    of = std::make_unique<Triangulation>();
    auto& [all, handle] = *of;
    const std::size_t count = points.parameter.size();
    std::vector<std::pair<Point2, std::size_t>> chart;
    for (std::size_t i = 0; i < count; ++i) chart.emplace_back(place_of(surface, points.parameter[i]), i);
    all.insert(chart.begin(), chart.end());
    if (all.number_of_vertices() != count || all.dimension() != 2) throw_generation_error();
    handle.resize(count);
    for (const auto v : all.finite_vertex_handles()) handle[v->info()] = v;
    try {
        for (const auto& pairs : {points.creases, points.borders})
            for (const auto& [a, b] : pairs) all.insert_constraint(handle[a], handle[b]);
    } catch (const Triangulation::CreasedDelaunay::Intersection_of_constraints_exception&) {
        throw_generation_error();
    }
    all.infinite_vertex()->info() = count;
    require_edges();
}

/// Throws Error if a crease or border crosses another one or passes through a vertex.
void MovingDelaunay::require_edges() const {
    for (const auto& pairs : {points.creases, points.borders})
        for (const auto& [a, b] : pairs)
            if (!of->all.is_edge(of->handle[a], of->handle[b])) throw_generation_error();
}

/// Whether all vertices of the convex hull are fixed, so that the hull stays.
bool MovingDelaunay::hull_rests() const {
    auto around = of->all.incident_vertices(of->all.infinite_vertex());
    const auto first = around;
    do {
        if (around->info() >= points.fixed) return false;
    } while (++around != first);
    return true;
}

void MovingDelaunay::follow() {
    if (!hull_rests() || !move()) make();
}

/// Moves the points and flips edges. Returns false if too many points would have to be inserted again.
bool MovingDelaunay::move() {
    auto& [all, handle] = *of;
    const std::size_t count = handle.size();
    std::vector<Point2> before(count);
    for (std::size_t i = points.fixed; i < count; ++i)
        before[i] = std::exchange(handle[i]->point(), place_of(surface, points.parameter[i]));
    std::vector<std::size_t> back = of->put_back(before, points.fixed);
    if (many * back.size() > count) return false;
    of->flip_edges();
    std::ranges::sort(back);
    for (const std::size_t i : back) {
        all.remove(handle[i]);
        const auto near = handle[i > 0 ? i - 1 : 1];
        handle[i] = all.insert(place_of(surface, points.parameter[i]), near->face());
        handle[i]->info() = i;
    }
    if (all.number_of_vertices() != count) throw_generation_error();
    require_edges();
    return true;
}

/// Marks all faces as outside or inside of the borders, starting at infinity.
void MovingDelaunay::mark() {
    std::vector<std::array<std::size_t, 2>> borders = points.borders;
    for (auto& [a, b] : borders)
        if (a > b) std::swap(a, b);
    std::ranges::sort(borders);
    const auto is_border = [&](auto face, int side) {
        const auto [a, b] =
            std::minmax(face->vertex((side + 1) % 3)->info(), face->vertex((side + 2) % 3)->info());
        return std::ranges::binary_search(borders, std::array<std::size_t, 2>{a, b});
    };
    for (const auto face : of->all.all_face_handles()) face->info() = Triangulation::Where::unknown;
    std::vector<Triangulation::FaceHandle> open{of->all.infinite_face()};
    open.back()->info() = Triangulation::Where::outside;
    while (!open.empty()) {
        const auto face = open.back();
        open.pop_back();
        for (int side = 0; side < 3; ++side) {
            const auto next = face->neighbor(side);
            if (next->info() != Triangulation::Where::unknown) continue;
            const bool outside = (face->info() == Triangulation::Where::outside) != is_border(face, side);
            next->info() = outside ? Triangulation::Where::outside : Triangulation::Where::inside;
            open.push_back(next);
        }
    }
}

std::vector<MovingDelaunay::Corners> MovingDelaunay::triangles() {
    if (!points.borders.empty()) mark();
    std::vector<Corners> result;
    for (const auto face : of->all.all_face_handles()) {
        if (!points.is_closed && of->all.is_infinite(face)) continue;
        if (!points.borders.empty() && face->info() == Triangulation::Where::outside) continue;
        Corners corners{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
        std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
        if (std::ranges::max(corners) >= points.hole) result.push_back(corners);
    }
    std::ranges::sort(result);
    return result;
}

}  // namespace sherd
