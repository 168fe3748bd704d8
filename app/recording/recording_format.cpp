// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/recording_format.h"

#include <fmt/format.h>

#include <algorithm>

namespace sherd::recording_format {

namespace {

bool any_outside(const std::vector<Index>& numbers, std::size_t end) {
    return std::ranges::any_of(numbers,
                               [end](Index i) { return i < 0 || static_cast<std::size_t>(i) >= end; });
}

template <std::size_t N>
bool any_outside(const std::vector<std::array<Index, N>>& rows, std::size_t end) {
    return std::ranges::any_of(rows, [end](const auto& row) {
        return std::ranges::any_of(row,
                                   [end](Index i) { return i < 0 || static_cast<std::size_t>(i) >= end; });
    });
}

}  // namespace

std::string frame_group(std::size_t number) {
    return fmt::format("frames/{:06}", number);
}

std::string obstacle_group(std::size_t number) {
    return fmt::format("obstacles/{}", number);
}

std::string inconsistency(const Snapshot& s) {
    const auto vertices = static_cast<std::size_t>(s.position.cols());
    if (s.velocity.cols() != s.position.cols() || s.mass.size() != s.position.cols() ||
        s.original.size() != vertices)
        return "the arrays of its vertices differ in length";
    if (s.face_fragment.size() != s.faces.size() || s.face_sheet.size() != s.faces.size())
        return "the arrays of its faces differ in length";
    if (s.edge_state.size() != s.edges.size() || s.edge_strain.size() != s.edges.size())
        return "the arrays of its edges differ in length";
    if (any_outside(s.faces, vertices)) return "a face names a vertex that does not exist";
    if (any_outside(s.edges, vertices)) return "an edge names a vertex that does not exist";
    if (any_outside(s.original, vertices)) return "a vertex comes from one that does not exist";
    if (any_outside(s.face_fragment, s.faces.size())) return "a face is in a fragment that does not exist";
    if (any_outside(s.face_sheet, s.faces.size())) return "a face is in a sheet that does not exist";
    if (std::ranges::any_of(s.edge_state, [](EdgeState state) { return state > EdgeState::boundary; }))
        return "an edge has an unknown state";
    return "";
}

std::string inconsistency(const RecordingHeader& header) {
    if (header.rest_area.size() != header.rest_faces.size())
        return "/rest/faces and /rest/area differ in length";
    if (!header.rest_thickness.empty() && header.rest_thickness.size() != header.rest_faces.size())
        return "/rest/faces and /rest/thickness differ in length";
    if (any_outside(header.rest_faces, static_cast<std::size_t>(header.rest_position.cols())))
        return "a face of /rest/faces names a vertex that does not exist";
    return "";
}

std::string inconsistency(const RecordedObstacle& obstacle) {
    if (any_outside(obstacle.surface.triangles, obstacle.surface.points.size()))
        return fmt::format("a face of the obstacle '{}' names a point that does not exist", obstacle.name);
    return "";
}

}  // namespace sherd::recording_format
