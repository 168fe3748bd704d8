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

std::string first_of(std::initializer_list<std::string> faults) {
    const auto found = std::ranges::find_if(faults, [](const std::string& fault) { return !fault.empty(); });
    return found == faults.end() ? "" : *found;
}

std::size_t rows_of(const auto& values) {
    if constexpr (requires { values.cols(); } && !std::same_as<std::decay_t<decltype(values)>, VectorXd>)
        return static_cast<std::size_t>(values.cols());
    else
        return static_cast<std::size_t>(values.size());
}

/// Returns a message on the first fault of a look, or "" if it has none. faces, vertices: numbers of faces
/// and of vertices at rest.
std::string look_fault(const SurfaceLook& look, std::size_t faces, std::size_t vertices) {
    std::string fault;
    const auto check = [&](const auto& attribute, const char* elements, std::size_t wanted) {
        const std::size_t count = (look.*attribute.list).size();
        if (fault.empty() && count != 0 && count != wanted)
            fault = fmt::format("rest/{} and rest/{} differ in length", elements, attribute.recorded);
    };
    visit_attributes_of<Face>([&](const auto& attribute) { check(attribute, "faces", faces); });
    visit_attributes_of<Vertex>([&](const auto& attribute) { check(attribute, "position", vertices); });
    return fault;
}

/// Numbers of elements of a snapshot, by its first array of each kind of element. Other arrays of the kind
/// must have the same length, and indices of such elements must be smaller.
struct Counts {
    Counts(const Snapshot& s, std::size_t unfractured_vertices)
        : vertices(static_cast<std::size_t>(s.position.cols())),
          rest_vertices(static_cast<std::size_t>(s.rest.position.cols())),
          faces(s.faces.size()),
          edges(s.edges.size()),
          unfractured_vertices(unfractured_vertices),
          unfractured_faces(s.rest.unfractured_faces.size()) {}

    /// Returns the name and the length of the first array of a kind of element.
    std::pair<const char*, std::size_t> first(Elements entries) const {
        switch (entries) {
            case Elements::vertices:
                return {"vertex/position", vertices};
            case Elements::faces:
                return {"face/vertices", faces};
            case Elements::edges:
                return {"edge/vertices", edges};
            case Elements::rest_vertices:
                break;
        }
        return {"rest/position", rest_vertices};
    }
    /// Returns the word for the elements to which indices of a kind refer, and the number of these elements.
    std::pair<const char*, std::size_t> named(Names names) const {
        switch (names) {
            case Names::vertices:
                return {"vertex", vertices};
            case Names::rest_vertices:
                return {"vertex", rest_vertices};
            case Names::unfractured_vertices:
                return {"vertex", unfractured_vertices};
            case Names::unfractured_faces:
                return {"face", unfractured_faces};
            case Names::sheets:
                return {"sheet", faces};
            case Names::fragments:
            case Names::nothing:
                break;
        }
        return {"fragment", faces};
    }

    std::size_t vertices, rest_vertices, faces, edges, unfractured_vertices, unfractured_faces;
};

/// Calls visit(SnapshotArray, array) for the arrays of a snapshot and of its mesh at rest.
template <class Visit>
void visit_all_arrays(const Snapshot& s, const Visit& visit) {
    visit_arrays(s, visit);
    visit_rest_arrays(s.rest, visit);
}

std::string length_fault(const Snapshot& s, const Counts& counts) {
    std::string fault;
    visit_all_arrays(s, [&](const SnapshotArray& array, const auto& values) {
        const auto [name, rows] = counts.first(array.entries);
        const std::size_t found = rows_of(values);
        const bool is_left_out = found == 0 && array.presence != Presence::always;
        if (fault.empty() && found != rows && !is_left_out)
            fault = fmt::format("{} and {} differ in length", name, array.name);
    });
    return fault;
}

/// Returns a message if a field of faces that the frame has does not have a column for each face; otherwise
/// "".
std::string field_fault(const Snapshot& s) {
    std::string fault;
    visit_fields(s.fields, [&](const char* name, const Eigen::Matrix3Xd& values, const FieldMeaning&) {
        if (values.cols() > 0 && static_cast<std::size_t>(values.cols()) != s.faces.size())
            fault = fmt::format("face/vertices and face/{} differ in length", name);
    });
    return fault;
}

std::string number_fault(const Snapshot& s, const Counts& counts) {
    if (s.faces.size() < s.rest.unfractured_faces.size())
        return "face/vertices has fewer faces than /rest/faces";
    std::string fault;
    const auto check = [&](const char* name, Names names, const auto& values) {
        const auto [what, end] = counts.named(names);
        if (fault.empty() && any_outside(values, end))
            fault = fmt::format("{} names a {} that does not exist", name, what);
    };
    visit_all_arrays(s, [&](const SnapshotArray& array, const auto& values) {
        if constexpr (requires { any_outside(values, 0); })
            if (array.names != Names::nothing) check(array.name, array.names, values);
    });
    check("/rest/faces", Names::unfractured_vertices, s.rest.unfractured_faces);
    return fault;
}

constexpr double weight_tolerance = 1e-9;

bool are_shares(const auto& weights) {
    return std::ranges::all_of(weights, [](double weight) { return weight >= -weight_tolerance; }) &&
           std::abs(weights[0] + weights[1] + weights[2] - 1) <= weight_tolerance;
}

/// Returns a message on the first fault of the parents and weights of the mesh at rest, or "" if there is
/// none. Requires that lengths and indices have no faults.
std::string parent_fault(const Snapshot& s) {
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

RestMesh unfractured_mesh(const RecordingHeader& header) {
    RestMesh rest = sherd::unfractured_mesh(header.rest_position, header.rest_faces, header.rest_area,
                                            header.rest_thickness);
    rest.look = header.rest_look;
    return rest;
}

std::string inconsistency(const Snapshot& s, std::size_t unfractured_vertices) {
    const Counts counts(s, unfractured_vertices);
    if (std::string fault = first_of(
            {length_fault(s, counts), field_fault(s), number_fault(s, counts),
             look_fault(s.rest.look, s.faces.size(), static_cast<std::size_t>(s.rest.position.cols()))});
        !fault.empty())
        return fault;
    if (std::ranges::any_of(s.edge_state, [](EdgeState state) { return state > EdgeState::boundary; }))
        return "edge/state has an unknown state";
    if (std::ranges::any_of(s.edge_cohesive_share, [](double share) { return !(share >= 0 && share <= 1); }))
        return "edge/held has a value that is not from 0 to 1";
    return parent_fault(s);
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
