// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/recording_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

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

struct Length {
    const char* name;
    std::size_t rows;
};

/// Returns a message if an array is not as long as the first one, or "".
std::string difference(std::initializer_list<Length> arrays) {
    for (const Length& array : arrays)
        if (array.rows != arrays.begin()->rows)
            return fmt::format("{} and {} differ in length", arrays.begin()->name, array.name);
    return "";
}

std::string first_of(std::initializer_list<std::string> faults) {
    const auto found = std::ranges::find_if(faults, [](const std::string& fault) { return !fault.empty(); });
    return found == faults.end() ? "" : *found;
}

/// Returns a message if an index of the array is not below `end`, or "".
template <class Numbers>
std::string outside(const char* name, const Numbers& numbers, std::size_t end, const char* what) {
    return any_outside(numbers, end) ? fmt::format("{} names a {} that does not exist", name, what) : "";
}

/// Returns the first fault of a look, or "". faces, vertices: their numbers at rest.
std::string look_fault(const SurfaceLook& look, std::size_t faces, std::size_t vertices) {
    std::string fault;
    visit_recorded_attributes(
        [&]<class Element, class Value, Inherits rule>(const Attribute<Element, Value, rule>& attribute) {
            const bool is_of_vertices = std::same_as<Element, Vertex>;
            const std::size_t count = (look.*attribute.list).size();
            if (fault.empty() && count != 0 && count != (is_of_vertices ? vertices : faces))
                fault = fmt::format("rest/{} and rest/{} differ in length",
                                    is_of_vertices ? "position" : "faces", attribute.recorded);
        });
    return fault;
}

std::string length_fault(const Snapshot& s) {
    const RestMesh& rest = s.rest;
    return first_of(
        {difference({{"vertex/position", static_cast<std::size_t>(s.position.cols())},
                     {"vertex/velocity", static_cast<std::size_t>(s.velocity.cols())},
                     {"vertex/mass", static_cast<std::size_t>(s.mass.size())},
                     {"vertex/original", s.original.size()}}),
         difference({{"face/vertices", s.faces.size()},
                     {"face/fragment", s.face_fragment.size()},
                     {"face/sheet", s.face_sheet.size()},
                     {"rest/faces", rest.faces.size()},
                     {"rest/area", rest.area.size()},
                     {"rest/thickness", rest.thickness.empty() ? s.faces.size() : rest.thickness.size()},
                     {"rest/face_parent", rest.face_parent.size()},
                     {"rest/face_mixed", rest.face_mixed.empty() ? s.faces.size() : rest.face_mixed.size()}}),
         difference({{"edge/vertices", s.edges.size()},
                     {"edge/state", s.edge_state.size()},
                     {"edge/strain", s.edge_strain.size()},
                     {held_edges, s.edge_held.empty() ? s.edges.size() : s.edge_held.size()}}),
         difference({{"rest/position", static_cast<std::size_t>(rest.position.cols())},
                     {"rest/vertex_parents", rest.vertex_parents.size()},
                     {"rest/vertex_weights", rest.vertex_weights.size()}})});
}

/// Returns a message if a field of faces, where a frame has it, is not as long as the faces, or "".
std::string field_fault(const Snapshot& s) {
    std::string fault;
    visit_fields(s.fields, [&](const char* name, const Eigen::Matrix3Xd& values, const FieldMeaning&) {
        if (values.cols() > 0 && static_cast<std::size_t>(values.cols()) != s.faces.size())
            fault = fmt::format("face/vertices and face/{} differ in length", name);
    });
    return fault;
}

std::string number_fault(const Snapshot& s, std::size_t unbroken_vertices) {
    const auto vertices = static_cast<std::size_t>(s.position.cols()),
               rest_vertices = static_cast<std::size_t>(s.rest.position.cols());
    if (s.faces.size() < s.rest.unbroken_faces.size())
        return "face/vertices has fewer faces than /rest/faces";
    return first_of({outside("face/vertices", s.faces, vertices, "vertex"),
                     outside("edge/vertices", s.edges, vertices, "vertex"),
                     outside("vertex/original", s.original, rest_vertices, "vertex"),
                     outside("face/fragment", s.face_fragment, s.faces.size(), "fragment"),
                     outside("face/sheet", s.face_sheet, s.faces.size(), "sheet"),
                     outside("rest/faces", s.rest.faces, rest_vertices, "vertex"),
                     outside("rest/vertex_parents", s.rest.vertex_parents, unbroken_vertices, "vertex"),
                     outside("rest/face_parent", s.rest.face_parent, s.rest.unbroken_faces.size(), "face"),
                     outside("/rest/faces", s.rest.unbroken_faces, unbroken_vertices, "vertex")});
}

constexpr double weight_tolerance = 1e-9;

bool are_shares(const auto& weights) {
    return std::ranges::all_of(weights, [](double weight) { return weight >= -weight_tolerance; }) &&
           std::abs(weights[0] + weights[1] + weights[2] - 1) <= weight_tolerance;
}

/// Returns the first fault of the parents and weights, or "". Requires arrays without faults of length and
/// index.
std::string ancestry_fault(const Snapshot& s) {
    const RestMesh& rest = s.rest;
    for (std::size_t v = 0; v < rest.vertex_weights.size(); ++v)
        if (!are_shares(rest.vertex_weights[v]))
            return fmt::format("rest/vertex_weights of vertex {} are no shares that sum to 1", v);
    for (std::size_t f = 0; f < s.faces.size(); ++f)
        for (int k = 0; k < 3; ++k) {
            if (s.original[s.faces[f][k]] != rest.faces[f][k])
                return fmt::format("face {} has other corners in rest/faces than in face/vertices", f);
            const bool is_mixed = !rest.face_mixed.empty() && rest.face_mixed[f] != 0;
            if (!is_mixed && !are_shares(place_in_parent(rest, f, k)))
                return fmt::format(
                    "rest/vertex_parents: vertex {}, a corner of face {}, is not in its rest/face_parent",
                    rest.faces[f][k], f);
        }
    return "";
}

}  // namespace

std::vector<std::string> numbered_groups(hid_t file, const std::string& group) {
    if (!hdf5::contains(file, group)) return {};
    std::vector<std::pair<std::int64_t, std::string>> found;
    for (const std::string& name : hdf5::member_names(file, group)) {
        const std::string path = group + "/" + name;
        found.emplace_back(hdf5::read_integer_attribute(hdf5::open_group(file, path), "number"), path);
    }
    std::ranges::sort(found);
    std::vector<std::string> paths;
    for (const auto& [number, path] : found) paths.push_back(path);
    return paths;
}

std::string member_name(std::string name) {
    std::ranges::replace(name, '/', '_');
    return name;
}

std::string frame_group(std::size_t number) {
    return fmt::format("frames/{:06}", number);
}

std::string obstacle_group(std::size_t number) {
    return fmt::format("obstacles/{}", number);
}

std::string obstacle_points(std::size_t number) {
    return obstacle_group(number) + "/position";
}

std::string obstacle_points(std::size_t frame, std::size_t number) {
    return fmt::format("{}/obstacle/{}/position", frame_group(frame), number);
}

std::string obstacle_faces(std::size_t number) {
    return obstacle_group(number) + "/face";
}

bool is_recorded(const RecordedGauge& gauge, std::string_view column) {
    if (column == "displacement") return gauge.displacement;
    if (column == "curvature") return gauge.fields.curvature;
    if (column == "membrane_strain") return gauge.fields.membrane_strain;
    return gauge.fields.stress;
}

RestMesh unbroken_mesh(const RecordingHeader& header) {
    RestMesh rest = sherd::unbroken_mesh(header.rest_position, header.rest_faces, header.rest_area,
                                         header.rest_thickness);
    rest.look = header.rest_look;
    return rest;
}

std::string inconsistency(const Snapshot& s, std::size_t unbroken_vertices) {
    if (std::string fault = first_of(
            {length_fault(s), field_fault(s), number_fault(s, unbroken_vertices),
             look_fault(s.rest.look, s.faces.size(), static_cast<std::size_t>(s.rest.position.cols()))});
        !fault.empty())
        return fault;
    if (std::ranges::any_of(s.edge_state, [](EdgeState state) { return state > EdgeState::boundary; }))
        return "edge/state has an unknown state";
    if (std::ranges::any_of(s.edge_held, [](double share) { return !(share >= 0 && share <= 1); }))
        return fmt::format("{} has what is no share", held_edges);
    return ancestry_fault(s);
}

std::string inconsistency(const RecordingHeader& header) {
    if (header.rest_area.size() != header.rest_faces.size())
        return "/rest/faces and /rest/area differ in length";
    if (!header.rest_thickness.empty() && header.rest_thickness.size() != header.rest_faces.size())
        return "/rest/faces and /rest/thickness differ in length";
    if (!header.rest_axis.empty() && header.rest_axis.size() != header.rest_faces.size())
        return "/rest/faces and /rest/axis differ in length";
    if (any_outside(header.rest_faces, static_cast<std::size_t>(header.rest_position.cols())))
        return "a face of /rest/faces names a vertex that does not exist";
    return look_fault(header.rest_look, header.rest_faces.size(),
                      static_cast<std::size_t>(header.rest_position.cols()));
}

std::string inconsistency(const RecordedObstacle& obstacle) {
    if (any_outside(obstacle.surface.triangles, obstacle.surface.points.size()))
        return fmt::format("a face of the obstacle '{}' names a point that does not exist", obstacle.name);
    return "";
}

}  // namespace sherd::recording_format
