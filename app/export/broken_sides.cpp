// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/broken_sides.h"

#include <map>

#include "app/render/render_solid.h"

namespace sherd {
namespace {

/// A side of a face that a crack has opened.
struct BrokenSide {
    Index from, to;
    double length, thickness;  ///< m
    std::size_t triangle;      ///< index of the first of its two triangles in the body
    double start = -1;         ///< m, u at `from`; below 0: unknown
};

std::vector<BrokenSide> broken_sides(const Snapshot& frame, std::span<const double> thickness) {
    const auto open = open_edges(frame.faces), rim = rim_edges(frame.rest);
    std::vector<BrokenSide> sides;
    std::size_t triangle = 2 * frame.faces.size();
    for (std::size_t f = 0; f < frame.faces.size(); ++f)
        for (int k = 0; k < 3; ++k) {
            if (!open[f][k]) continue;
            triangle += 2;
            if (rim[f][k]) continue;
            const Index from = frame.faces[f][k], to = frame.faces[f][(k + 1) % 3];
            const Vector3d side =
                frame.rest.position.col(frame.original[to]) - frame.rest.position.col(frame.original[from]);
            sides.push_back({from, to, side.norm(), thickness[f], triangle - 2});
        }
    return sides;
}

/// Sets u at all sides. It begins at an end of a crack, or anywhere on a closed one.
void set_starts(std::vector<BrokenSide>& sides) {
    std::map<Index, std::size_t> at;
    std::map<Index, int> ends;
    for (std::size_t i = 0; i < sides.size(); ++i) {
        at[sides[i].from] = i;
        ++ends[sides[i].to];
    }
    const auto follow = [&](std::size_t i) {
        double u = 0;
        for (auto next = at.find(sides[i].from); next != at.end() && sides[next->second].start < 0;) {
            BrokenSide& side = sides[next->second];
            side.start = u;
            u += side.length;
            next = at.find(side.to);
        }
    };
    for (std::size_t i = 0; i < sides.size(); ++i)
        if (!ends.contains(sides[i].from)) follow(i);
    for (std::size_t i = 0; i < sides.size(); ++i)
        if (sides[i].start < 0) follow(i);
}

void give_material(std::vector<BrokenSide>& sides, std::size_t points, TriangleSheet& body) {
    const FaceMaterial inside =
        std::make_shared<const SurfaceMaterial>(SurfaceMaterial{"inside", "Kd 0.8 0.8 0.8\n"});
    const Eigen::Vector2d zero = Eigen::Vector2d::Zero();
    body.look.material.resize(body.triangles.size());
    if (body.look.texture.empty()) body.look.texture.assign(body.triangles.size(), {zero, zero, zero});
    set_starts(sides);
    const auto count = static_cast<std::int32_t>(points);
    for (const BrokenSide& side : sides)
        for (const std::size_t t : {side.triangle, side.triangle + 1}) {
            body.look.material[t] = inside;
            for (int k = 0; k < 3; ++k) {
                const std::int32_t point = body.triangles[t][k];
                const bool is_end = point % count == side.to;
                body.look.texture[t][k] = {side.start + (is_end ? side.length : 0),
                                           point < count ? side.thickness : 0};
            }
        }
}

}  // namespace

void finish_broken_sides(const Snapshot& frame, std::span<const double> thickness, bool with_materials,
                         TriangleSheet& body) {
    std::vector<BrokenSide> sides = broken_sides(frame, thickness);
    for (const BrokenSide& side : sides)
        for (const std::size_t t : {side.triangle, side.triangle + 1}) body.shading[t] = Shading::broken;
    if (with_materials) give_material(sides, static_cast<std::size_t>(frame.position.cols()), body);
}

}  // namespace sherd
