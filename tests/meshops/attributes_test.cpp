// SPDX-License-Identifier: GPL-3.0-or-later
// Every attribute of the table must follow changes of a mesh and be stored: a user who paints a mesh would
// lose an attribute that is not.
#include "meshops/attributes.h"

#include <gtest/gtest.h>

#include <set>

#include "meshops/generate/generate.h"
#include "meshops/read_write/write_mesh.h"
#include "meshops/topology/split_vertex.h"

namespace sherd {
namespace {

template <class Value>
Value some_value(std::size_t i) {
    [[maybe_unused]] const auto x = static_cast<double>(i);
    if constexpr (std::same_as<Value, FaceTexture>)
        return {Eigen::Vector2d(x, 0), Eigen::Vector2d(x, 1), Eigen::Vector2d(x, 2)};
    else if constexpr (std::same_as<Value, FaceMaterial>)
        return std::make_shared<const SurfaceMaterial>(SurfaceMaterial{std::to_string(i % 2)});
    else if constexpr (std::same_as<Value, GroupNames>)
        return std::make_shared<const std::vector<std::string>>(1, std::to_string(i % 2));
    else if constexpr (std::same_as<Value, Colour>)
        return {static_cast<std::uint8_t>(i), 1, 2, 255};
    else if constexpr (std::same_as<Value, Eigen::Vector3d>)
        return Eigen::Vector3d(1, x, 0);
    else if constexpr (std::same_as<Value, FileWeights>)
        return {{static_cast<std::uint32_t>(i), 0, 0}, Eigen::Vector3d::UnitX()};
    else
        return static_cast<Value>(i);
}

/// A square with values of every attribute.
Mesh square() {
    Mesh mesh = generate_rectangle(1, 1, {.edge_length = 0.25});
    visit_mesh_attributes(
        [&]<class Element, class Value, Inherits rule>(const Attribute<Element, Value, rule>& attribute) {
            auto values = add_property(mesh, attribute);
            for (const Element element : elements<Element>(mesh))
                values[element] = some_value<Value>(element.idx());
        });
    return mesh;
}

// Two attributes of one name would overwrite each other in meshes or files.
TEST(Attributes, HaveNamesOfTheirOwn) {
    std::set<std::string> properties, recorded;
    std::size_t count = 0, count_recorded = 0;
    visit_mesh_attributes([&](const auto& attribute) {
        properties.insert(attribute.property);
        ++count;
        if (*attribute.recorded == 0) return;
        recorded.insert(attribute.recorded);
        EXPECT_NE(std::string(attribute.meaning), "") << attribute.recorded;
        ++count_recorded;
    });
    EXPECT_EQ(properties.size(), count);
    EXPECT_EQ(recorded.size(), count_recorded);
}

TEST(Attributes, OfACopyOfAVertexAreThoseOfTheVertex) {
    Mesh mesh = square();
    std::vector<Vertex> all(mesh.vertices().begin(), mesh.vertices().end());
    const TopologyChange change = split_vertices(mesh, all, [](Edge) { return true; });
    ASSERT_GT(change.vertices.size(), 0u);
    visit_mesh_attributes(
        [&]<class Element, class Value, Inherits rule>(const Attribute<Element, Value, rule>& attribute) {
            const auto [values, exists] = find_property(mesh, attribute);
            ASSERT_TRUE(exists) << attribute.property;
            if constexpr (std::same_as<Element, Vertex> && std::equality_comparable<Value>) {
                for (const WithParents<Vertex>& copy : change.vertices) {
                    EXPECT_EQ(values[copy.element], values[copy.parent()]) << attribute.property;
                }
            }
        });
}

TEST(Attributes, OfAMeshAreInItsListsAndJoin) {
    const Mesh mesh = square();
    const TriangleSheet sheet = triangle_sheet(mesh);
    TriangleSheet both = sheet;
    both.group.assign(sheet.triangles.size(), 0);
    both.group_names = {"first"};
    add_group(both, sheet, "second");
    visit_surface_attributes(
        [&]<class Element, class Value, Inherits rule>(const Attribute<Element, Value, rule>& attribute) {
            const std::vector<Value>& list = sheet.look.*attribute.list;
            const bool is_of_vertices = std::same_as<Element, Vertex>;
            ASSERT_EQ(list.size(), is_of_vertices ? sheet.points.size() : sheet.triangles.size())
                << attribute.property;
            EXPECT_TRUE(is_same(list[3], some_value<Value>(3))) << attribute.property;
            EXPECT_EQ((both.look.*attribute.list).size(), 2 * list.size()) << attribute.property;
        });
    Mesh bare = generate_rectangle(1, 1, {.edge_length = 0.5});
    take_properties(bare, mesh);
    visit_surface_attributes([&](const auto& attribute) {
        EXPECT_TRUE(find_property(bare, attribute).second) << attribute.property;
    });
}

}  // namespace
}  // namespace sherd
