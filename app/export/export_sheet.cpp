// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/export_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/recording/fields.h"

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

void add_look(const Snapshot& frame, TriangleSheet& sheet) {
    const SurfaceLook& look = frame.rest.look;
    for (const auto& uv : look.texture.colwise())
        sheet.texture.push_back({uv.segment<2>(0), uv.segment<2>(2), uv.segment<2>(4)});
    std::vector<FaceMaterial> materials;
    for (const SurfaceMaterial& material : look.materials)
        materials.push_back(std::make_shared<const SurfaceMaterial>(material));
    for (const Index material : look.material)
        sheet.material.push_back(material < 0 ? nullptr : materials[material]);
    std::vector<GroupNames> groups;
    for (const std::vector<std::string>& names : look.groups)
        groups.push_back(one_word_names(std::make_shared<const std::vector<std::string>>(names)));
    for (const Index group : look.group) sheet.named_groups.push_back(group < 0 ? nullptr : groups[group]);
    sheet.colour = look.face_colour;
    if (look.vertex_colour.empty()) return;
    for (const Index vertex : frame.original) sheet.point_colour.push_back(look.vertex_colour[vertex]);
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
    add_look(frame, sheet);
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
    for (const std::size_t i : group_points(sheet, group)) {
        number[i] = static_cast<std::int32_t>(part.points.size());
        part.points.push_back(sheet.points[i]);
        if (!sheet.point_colour.empty()) part.point_colour.push_back(sheet.point_colour[i]);
    }
    for (std::size_t t = 0; t < sheet.triangles.size(); ++t) {
        if (sheet.group[t] != group) continue;
        const auto& [a, b, c] = sheet.triangles[t];
        part.triangles.push_back({number[a], number[b], number[c]});
        part.group.push_back(group);
        const auto keep = [t](const auto& values, auto& kept) {
            if (!values.empty()) kept.push_back(values[t]);
        };
        keep(sheet.quality, part.quality);
        keep(sheet.texture, part.texture);
        keep(sheet.material, part.material);
        keep(sheet.shading, part.shading);
        keep(sheet.normal, part.normal);
        keep(sheet.colour, part.colour);
        keep(sheet.named_groups, part.named_groups);
    }
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
