// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "meshops/mesh.h"
#include "meshops/surface_material.h"

namespace sherd {

/// Red, green, blue and opacity, as files have them.
using Colour = std::array<std::uint8_t, 4>;
inline constexpr Colour white{255, 255, 255, 255};

/// The names of the groups of a face, shared by faces that follow each other in the file; null: in no group.
using GroupNames = std::shared_ptr<const std::vector<std::string>>;

/// A point in a triangle of the file that a mesh was remeshed from.
struct FileWeights {
    std::array<std::uint32_t, 3> vertices;  ///< numbers in the file, from 0
    Eigen::Vector3d weights;                ///< barycentric
};

/// Values that a file gives the vertices and faces of a surface, besides their places: each list has an entry
/// for each vertex or face, or is empty.
struct SurfaceLook {
    std::vector<FaceTexture> texture = {};
    std::vector<FaceMaterial> material = {};
    std::vector<GroupNames> groups = {};
    std::vector<Colour> face_colour = {};
    std::vector<Colour> vertex_colour = {};
    std::vector<Eigen::Vector3d> axis = {};  ///< first material axis of each face, of any length

    bool operator==(const SurfaceLook& other) const;
    bool has_colours() const { return !face_colour.empty() || !vertex_colour.empty(); }
    /// Whether there are materials or colours.
    bool paints() const;
    /// The colour of the vertex, or else of the face; white without colours.
    Colour colour(std::size_t face, std::size_t vertex) const;
};

/// Rule by which new and changed elements of a mesh inherit an attribute. A copy of a vertex always has the
/// value of its parent.
enum class Inherits {
    mean,     ///< the mean of the parents by weight; vectors of faces by area, with the length of the main
              ///< parent; texture coordinates are interpolated in the parent face where the corner lies
    largest,  ///< the value of the face that gives the largest share of its area
    nothing   ///< inserted elements have the value missing()
};

/// Value of an element that an attribute says nothing of, as where two meshes are joined.
template <class Value>
Value missing() {
    if constexpr (std::same_as<Value, FaceTexture>)
        return {Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
    else if constexpr (std::same_as<Value, Colour>)
        return white;
    else if constexpr (std::same_as<Value, Eigen::Vector3d>)
        return Eigen::Vector3d::Zero();
    else if constexpr (std::same_as<Value, FileWeights>)
        return {{}, Eigen::Vector3d::Zero()};
    else if constexpr (std::same_as<Value, std::uint32_t>)
        return std::numeric_limits<std::uint32_t>::max();
    else
        return Value();
}

/// Attribute of the vertices or faces of a mesh: a property map of a Mesh, and a list of a SurfaceLook.
template <class Element, class Value, Inherits rule>
struct Attribute {
    const char* property;                             ///< name of the property map
    std::vector<Value> SurfaceLook::*list = nullptr;  ///< null: only in meshes
    /// Property of PLY files; a vector has three, with the suffixes _x, _y and _z. "": none, or properties
    /// of its own, as for texture coordinates and colours.
    const char* ply = "";
    const char* recorded = "";  ///< dataset of a mesh at rest in recordings; "": it is not recorded
    const char* vtp = "";       ///< array in VTP files
    const char* unit = "1";
    const char* meaning = "";  ///< sentence in recordings

    static Value missing() { return sherd::missing<Value>(); }
};

/// Table of all attributes. An attribute that has its place here, in SurfaceLook and in
/// visit_surface_attributes() is read from PLY files, follows cracks and remeshing, is part of checkpoints
/// and recordings, and is exported.
namespace attribute {

inline constexpr Attribute<Face, FaceTexture, Inherits::mean> texture{
    .property = "f:texture",
    .list = &SurfaceLook::texture,
    .recorded = "texture",
    .vtp = "texture",
    .meaning = "texture coordinates u0 v0 u1 v1 u2 v2 of the corners"};
inline constexpr Attribute<Face, FaceMaterial, Inherits::largest> surface_material{
    .property = "f:surface_material",
    .list = &SurfaceLook::material,
    .recorded = "surface_material",
    .vtp = "material",
    .meaning = "row of surface_material_names; -1: none"};
inline constexpr Attribute<Face, GroupNames, Inherits::largest> groups{
    .property = "f:groups",
    .list = &SurfaceLook::groups,
    .recorded = "group",
    .vtp = "group",
    .meaning = "row of group_names; -1: none"};
inline constexpr Attribute<Face, Colour, Inherits::largest> face_colour{
    .property = "f:colour",
    .list = &SurfaceLook::face_colour,
    .recorded = "face_colour",
    .vtp = "colour",
    .meaning = "red, green, blue, opacity"};
inline constexpr Attribute<Vertex, Colour, Inherits::mean> vertex_colour{
    .property = "v:colour",
    .list = &SurfaceLook::vertex_colour,
    .recorded = "vertex_colour",
    .vtp = "colour",
    .meaning = "red, green, blue, opacity"};
inline constexpr Attribute<Face, Eigen::Vector3d, Inherits::mean> axis{
    .property = "f:axis", .list = &SurfaceLook::axis, .ply = "axis"};
/// Number of the vertex in the file, from 0.
inline constexpr Attribute<Vertex, std::uint32_t, Inherits::nothing> file_vertex{.property = "v:file_vertex"};
/// Place of the vertex in the file, if the mesh was remeshed.
inline constexpr Attribute<Vertex, FileWeights, Inherits::nothing> file_weights{.property = "v:file_weights"};

}  // namespace attribute

/// Calls visit(attribute) for each attribute that has a list of SurfaceLook.
template <class Visit>
constexpr void visit_surface_attributes(const Visit& visit) {
    visit(attribute::texture);
    visit(attribute::surface_material);
    visit(attribute::groups);
    visit(attribute::face_colour);
    visit(attribute::vertex_colour);
    visit(attribute::axis);
}

/// Visits, of these, the attributes of vertices (Vertex) or of faces (Face).
template <class Element, class Visit>
void visit_attributes_of(const Visit& visit) {
    visit_surface_attributes(
        [&]<class E, class Value, Inherits rule>(const Attribute<E, Value, rule>& attribute) {
            if constexpr (std::same_as<E, Element>) visit(attribute);
        });
}

/// Calls visit(attribute) for each attribute of a mesh.
template <class Visit>
void visit_mesh_attributes(const Visit& visit) {
    visit_surface_attributes(visit);
    visit(attribute::file_vertex);
    visit(attribute::file_weights);
}

/// Values that are plain numbers, written to files one by one.
template <class Value>
concept IsNumbers = std::same_as<Value, double> || std::same_as<Value, Eigen::Vector3d>;

inline std::span<double> numbers_of(double& value) {
    return {&value, 1};
}
inline std::span<double> numbers_of(Eigen::Vector3d& value) {
    return {value.data(), 3};
}

/// Names of the properties of PLY files for each of an attribute's numbers.
template <class Element, IsNumbers Value, Inherits rule>
std::vector<std::string> ply_names(const Attribute<Element, Value, rule>& attribute) {
    const std::string name = attribute.ply;
    if constexpr (std::same_as<Value, double>)
        return {name};
    else
        return {name + "_x", name + "_y", name + "_z"};
}

/// Visits the attributes of an element that PLY files have as numbers of these names.
template <class Element, class Visit>
void visit_numbers(const Visit& visit) {
    visit_attributes_of<Element>(
        [&]<class Value, Inherits rule>(const Attribute<Element, Value, rule>& attribute) {
            if constexpr (IsNumbers<Value>)
                if (*attribute.ply != 0) visit(attribute);
        });
}

/// Mean of values by weights that sum to 1.
template <class Value>
class Mean {
  public:
    void add(const Value& value, double weight) { sum += weight * value; }
    Value value() const { return sum; }

  private:
    Value sum = missing<Value>();
};

/// Mean of colours, whose parts are rounded.
template <>
class Mean<Colour> {
  public:
    void add(const Colour& colour, double weight) {
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += weight * colour[i];
    }
    Colour value() const;

  private:
    std::array<double, 4> sum{};
};

/// Whether two values are equal.
template <class Value>
bool is_same(const Value& one, const Value& two) {
    return one == two;
}

/// The property map of an attribute and whether the mesh has it.
template <class Element, class Value, Inherits rule>
std::pair<Mesh::Property_map<Element, Value>, bool> find_property(
    const Mesh& mesh, const Attribute<Element, Value, rule>& attribute) {
    return find_property<Element, Value>(mesh, attribute.property);
}

/// Gives a mesh the property map of an attribute, without values, if it has none yet.
template <class Element, class Value, Inherits rule>
Mesh::Property_map<Element, Value> add_property(Mesh& mesh,
                                                const Attribute<Element, Value, rule>& attribute) {
    return mesh.add_property_map<Element, Value>(attribute.property, missing<Value>()).first;
}

/// The vertices or the faces of a mesh.
template <class Element>
auto elements(const Mesh& mesh) {
    if constexpr (std::same_as<Element, Vertex>)
        return mesh.vertices();
    else
        return mesh.faces();
}

/// The values of a mesh's vertices and faces. rows: [V] row of each vertex in lists of vertices, below
/// `count`.
SurfaceLook surface_look(const Mesh& mesh, std::span<const std::int32_t> rows, std::size_t count);

/// Adds to a mesh, before `other` is joined to it, the properties that `other` has, without values.
void take_properties(Mesh& mesh, const Mesh& other);

}  // namespace sherd
