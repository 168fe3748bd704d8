// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/export_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/recording/fields.h"
#include "meshops/face_groups.h"
#include "meshops/shared_values.h"

namespace sherd {
namespace {

using Sides = std::vector<std::pair<std::array<Index, 2>, double>>;

std::array<Index, 2> ascending(Index a, Index b) {
    return {std::min(a, b), std::max(a, b)};
}

std::vector<double> face_strain(const Snapshot& frame) {
    Sides strain;
    for (std::size_t e = 0; e < frame.edges.size(); ++e)
        strain.emplace_back(ascending(frame.edges[e][0], frame.edges[e][1]), std::abs(frame.edge_strain[e]));
    std::ranges::sort(strain);
    const auto strain_of = [&](Index a, Index b) {
        const auto found = std::ranges::lower_bound(strain, ascending(a, b), {}, &Sides::value_type::first);
        return found == strain.end() || found->first != ascending(a, b) ? 0.0 : found->second;
    };
    std::vector<double> result;
    for (const auto& [a, b, c] : frame.faces)
        result.push_back(std::max({strain_of(a, b), strain_of(b, c), strain_of(c, a)}));
    return result;
}

std::vector<double> face_speed(const Snapshot& frame) {
    std::vector<double> result;
    const auto speed = [&](Index v) { return frame.velocity.col(v).norm(); };
    for (const auto& [a, b, c] : frame.faces) result.push_back((speed(a) + speed(b) + speed(c)) / 3);
    return result;
}

/// The look of the frame's vertices and faces: vertices get the values of the vertices of which they are
/// copies, and each name of a group becomes a single word.
SurfaceLook frame_look(const Snapshot& frame) {
    SurfaceLook look = frame.rest.look;
    visit_attributes_of<Vertex>([&](const auto& attribute) {
        auto& list = look.*attribute.list;
        if (!list.empty()) list = gathered(list, {frame.original.begin(), frame.original.end()});
    });
    SharedValues<std::vector<std::string>> groups = shared_values(look.groups);
    for (std::vector<std::string>& names : groups.rows)
        names = *one_word_names(std::make_shared<const std::vector<std::string>>(names));
    look.groups = listed(groups);
    return look;
}

}  // namespace

std::string fragment_name(std::size_t fragment) {
    return fmt::format("fragment_{:03}", fragment);
}

std::size_t fragment_count(const Snapshot& frame) {
    return frame.face_fragment.empty() ? 0 : *std::ranges::max_element(frame.face_fragment) + 1;
}

TriangleSheet frame_sheet(const Snapshot& frame) {
    TriangleSheet sheet;
    for (Eigen::Index v = 0; v < frame.position.cols(); ++v) sheet.points.push_back(frame.position.col(v));
    sheet.triangles = frame.faces;
    sheet.group = frame.face_fragment;
    sheet.look = frame_look(frame);
    for (std::size_t i = 0; i < fragment_count(frame); ++i) sheet.group_names.push_back(fragment_name(i));
    return sheet;
}

std::vector<std::size_t> group_points(const TriangleSheet& sheet, std::int32_t group) {
    std::vector<bool> used(sheet.points.size(), false);
    for (std::size_t t = 0; t < sheet.triangles.size(); ++t)
        if (sheet.group[t] == group)
            for (const std::int32_t point : sheet.triangles[t]) used[point] = true;
    std::vector<std::size_t> points;
    for (std::size_t i = 0; i < used.size(); ++i)
        if (used[i]) points.push_back(i);
    return points;
}

TriangleSheet group_part(const TriangleSheet& sheet, std::int32_t group) {
    TriangleSheet part;
    part.group_names = sheet.group_names;
    std::vector<std::int32_t> number(sheet.points.size(), -1);
    const std::vector<std::size_t> points = group_points(sheet, group);
    for (const std::size_t i : points) {
        number[i] = static_cast<std::int32_t>(part.points.size());
        part.points.push_back(sheet.points[i]);
    }
    std::vector<std::size_t> triangles;
    for (std::size_t t = 0; t < sheet.triangles.size(); ++t) {
        if (sheet.group[t] != group) continue;
        const auto& [a, b, c] = sheet.triangles[t];
        part.triangles.push_back({number[a], number[b], number[c]});
        triangles.push_back(t);
    }
    part.group.assign(triangles.size(), group);
    const auto keep = [](const auto& values, const std::vector<std::size_t>& chosen, auto& kept) {
        if (!values.empty()) kept = gathered(values, chosen);
    };
    keep(sheet.quality, triangles, part.quality);
    keep(sheet.shading, triangles, part.shading);
    keep(sheet.normal, triangles, part.normal);
    visit_attributes_of<Vertex>(
        [&](const auto& attribute) { keep(sheet.look.*attribute.list, points, part.look.*attribute.list); });
    visit_attributes_of<Face>([&](const auto& attribute) {
        keep(sheet.look.*attribute.list, triangles, part.look.*attribute.list);
    });
    return part;
}

std::vector<double> face_quality(const Snapshot& frame, const std::string& name) {
    if (name == "fragment") return {frame.face_fragment.begin(), frame.face_fragment.end()};
    if (name == "stress") {
        require_field(frame.fields.stress_top, name);
        const VectorXd stress = largest_stress(frame.fields);
        return {stress.begin(), stress.end()};
    }
    if (name == "curvature") {
        require_field(frame.fields.curvature, name);
        const VectorXd curvature = largest_curvature(frame.fields);
        return {curvature.begin(), curvature.end()};
    }
    return name == "speed" ? face_speed(frame) : face_strain(frame);
}

}  // namespace sherd
