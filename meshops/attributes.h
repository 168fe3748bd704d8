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

/// Red, green, blue and opacity, each from 0 to 255.
using Colour = std::array<std::uint8_t, 4>;
inline constexpr Colour white{255, 255, 255, 255};

/// Names of the groups that a face is in; null: none. Faces with no `g` or `o` line between them in an OBJ
/// file point to the same list.
using GroupNames = std::shared_ptr<const std::vector<std::string>>;

/// Place of a vertex of a remeshed mesh: a point in a triangle of the mesh file.
struct FileWeights {
    std::array<std::uint32_t, 3> vertices;  ///< numbers of the corners in the file, from 0
    Eigen::Vector3d weights;                ///< barycentric weights of the corners
};

/// Values that a mesh file gives the vertices and faces of a surface, besides positions and corners. Each
/// list has an entry for each vertex (`vertex_colour`) or for each face (all other lists), or is empty.
struct SurfaceLook {
    std::vector<FaceTexture> texture = {};
    std::vector<FaceMaterial> material = {};
    std::vector<GroupNames> groups = {};
    std::vector<Colour> face_colour = {};
    std::vector<Colour> vertex_colour = {};
    std::vector<Eigen::Vector3d> axis = {};  ///< first material axis of each face, not normalised

    bool operator==(const SurfaceLook& other) const;
    bool has_colours() const { return !face_colour.empty() || !vertex_colour.empty(); }
    /// Whether any face has a material, or there are colours.
    bool paints() const;
    /// Returns the colour of the vertex if vertices have colours, else that of the face if faces have
    /// colours, else white.
    Colour colour(std::size_t face, std::size_t vertex) const;
};

/// Rule by which elements (vertices or faces) that a change of a mesh inserts or alters inherit an attribute
/// from their parents, the elements in their place before the change (see TopologyChange). A copy of a vertex
/// always has the value of that vertex.
enum class Inherits {
    mean,  ///< the weighted mean of the parents' values; for vectors of faces the mean by area, scaled to the
           ///< length of the vector of the first parent, which has the largest share; for texture coordinates
           ///< the interpolation in the parent face in which the corner lies
    largest,  ///< for faces: the value of the first parent, of whose area the face has the largest share
    nothing   ///< inserted vertices get the value missing()
};

/// Value of an attribute for elements without one, as when a mesh with the attribute is joined with a mesh
/// without it.
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

/// Attribute of the vertices or faces of a mesh: it is a property map in a Mesh and a list in a SurfaceLook.
template <class Element, class Value, Inherits rule>
struct Attribute {
    const char* property;                             ///< name of the property map
    std::vector<Value> SurfaceLook::*list = nullptr;  ///< null: it is in meshes only
    /// Name of the property in PLY files; the three properties of a vector have this name with _x, _y and _z
    /// appended. "": PLY files have none, or separate code reads and writes it, as for texture coordinates
    /// and colours.
    const char* ply = "";
    const char* recorded = "";  ///< dataset of the mesh at rest in recordings; "": it is not recorded
    const char* vtp = "";       ///< array in VTP files; "": it is not exported
    const char* unit = "1";
    const char* meaning = "";  ///< sentence that explains the dataset

    static Value missing() { return sherd::missing<Value>(); }
};

/// Table of all attributes. An attribute that is declared here and in SurfaceLook, and that
/// visit_surface_attributes() visits, follows cracks and remeshing and is part of checkpoints. If it has
/// names for PLY files, recordings and VTP files, it is also read from PLY files, recorded and exported.
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
/// Place of the vertex in a triangle of the file, if the mesh was remeshed.
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

/// Calls visit(attribute) for each attribute with a list of SurfaceLook whose elements are vertices (Vertex)
/// or faces (Face), as `Element` says.
template <class Element, class Visit>
void visit_attributes_of(const Visit& visit) {
    visit_surface_attributes(
        [&]<class E, class Value, Inherits rule>(const Attribute<E, Value, rule>& attribute) {
            if constexpr (std::same_as<E, Element>) visit(attribute);
        });
}

/// Calls visit(attribute) for each attribute that a mesh may have, with or without a list of SurfaceLook.
template <class Visit>
void visit_mesh_attributes(const Visit& visit) {
    visit_surface_attributes(visit);
    visit(attribute::file_vertex);
    visit(attribute::file_weights);
}

/// A type of values that consist of real numbers; in PLY files each number is a property.
template <class Value>
concept IsNumbers = std::same_as<Value, double> || std::same_as<Value, Eigen::Vector3d>;

inline std::span<double> numbers_of(double& value) {
    return {&value, 1};
}
inline std::span<double> numbers_of(Eigen::Vector3d& value) {
    return {value.data(), 3};
}

/// Returns the names of the properties of PLY files that hold the numbers of an attribute, in their order.
template <class Element, IsNumbers Value, Inherits rule>
std::vector<std::string> ply_names(const Attribute<Element, Value, rule>& attribute) {
    const std::string name = attribute.ply;
    if constexpr (std::same_as<Value, double>)
        return {name};
    else
        return {name + "_x", name + "_y", name + "_z"};
}

/// Calls visit(attribute) for each attribute of vertices or faces, as `Element` says, that PLY files hold as
/// numbers with the names of ply_names().
template <class Element, class Visit>
void visit_numbers(const Visit& visit) {
    visit_attributes_of<Element>(
        [&]<class Value, Inherits rule>(const Attribute<Element, Value, rule>& attribute) {
            if constexpr (IsNumbers<Value>)
                if (*attribute.ply != 0) visit(attribute);
        });
}

/// Weighted mean of values. The weights must sum to 1.
template <class Value>
class Mean {
  public:
    void add(const Value& value, double weight) { sum += weight * value; }
    Value value() const { return sum; }

  private:
    Value sum = missing<Value>();
};

/// Weighted mean of colours, whose components are rounded.
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

/// Returns the property map of an attribute and whether the mesh has it; if not, the map is not valid.
template <class Element, class Value, Inherits rule>
std::pair<Mesh::Property_map<Element, Value>, bool> find_property(
    const Mesh& mesh, const Attribute<Element, Value, rule>& attribute) {
    return find_property<Element, Value>(mesh, attribute.property);
}

/// Gives a mesh the property map of an attribute, filled with missing(), if it has none yet. Returns the map.
template <class Element, class Value, Inherits rule>
Mesh::Property_map<Element, Value> add_property(Mesh& mesh,
                                                const Attribute<Element, Value, rule>& attribute) {
    return mesh.add_property_map<Element, Value>(attribute.property, missing<Value>()).first;
}

/// Returns the vertices or the faces of a mesh.
template <class Element>
auto elements(const Mesh& mesh) {
    if constexpr (std::same_as<Element, Vertex>)
        return mesh.vertices();
    else
        return mesh.faces();
}

/// Returns the attributes of a mesh as lists. Lists of vertices have `count` entries. rows: [V] number of the
/// entry of each vertex in these lists.
SurfaceLook surface_look(const Mesh& mesh, std::span<const std::int32_t> rows, std::size_t count);

/// Gives `mesh` the property maps of attributes that `other` has, filled with missing(), so that `other` can
/// then be joined to it.
void take_properties(Mesh& mesh, const Mesh& other);

}  // namespace sherd
