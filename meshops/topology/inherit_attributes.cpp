// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/topology/inherit_attributes.h"

#include <algorithm>

#include "meshops/attributes.h"
#include "meshops/mesh_measures.h"

namespace sherd {
namespace {

using Parents = std::vector<WithParents<Vertex>::Parent>;
using Shares = std::vector<WithParents<Face>::Parent>;

/// Returns the sum of the weights of each corner of a face among the parents of a vertex; nullopt if a parent
/// is no corner of the face.
std::optional<Eigen::Vector3d> corner_weights(const ReplacedFace& face, const Parents& parents) {
    Eigen::Vector3d weights = Eigen::Vector3d::Zero();
    for (const auto& [vertex, weight] : parents) {
        const std::size_t corner = corner_number(face.corners, vertex);
        if (corner == 3) return std::nullopt;
        weights[static_cast<Eigen::Index>(corner)] += weight;
    }
    return weights;
}

/// Computes the attributes that faces inherit in a change of a mesh.
class FaceInheritance {
  public:
    FaceInheritance(const Mesh& mesh, const std::map<Face, ReplacedFace>& old, const TopologyChange& change)
        : mesh(mesh), old(old) {
        for (const auto* vertices : {&change.vertices, &change.moved})
            for (const WithParents<Vertex>& vertex : *vertices) parents[vertex.element] = vertex.parents;
    }

    /// Returns the texture coordinates at the corners of a face whose parents are `shares`. If a corner lies
    /// in none of the parents, it gets the value that the first parent, which has the largest share, has at
    /// its corner of the same number.
    FaceTexture mean(const Mesh::Property_map<Face, FaceTexture>& texture, Face face,
                     const Shares& shares) const {
        FaceTexture result;
        const std::array<Vertex, 3> corners = face_corners(mesh, face);
        for (int i = 0; i < 3; ++i) {
            const auto known = parents.find(corners[i]);
            const Parents own{{corners[i], 1}};
            result[i] = texture_at(texture, shares, known == parents.end() ? own : known->second,
                                   texture[shares.front().element][i]);
        }
        return result;
    }

    /// Returns the mean of the vectors of the parents by area, scaled to the length of the vector of the
    /// first parent.
    Eigen::Vector3d mean(const Mesh::Property_map<Face, Eigen::Vector3d>& direction, Face,
                         const Shares& shares) const {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (const auto& [parent, share] : shares) sum += share * old.at(parent).area * direction[parent];
        const double length = direction[shares.front().element].norm();
        return sum.norm() > 0 ? Eigen::Vector3d(sum * (length / sum.norm()))
                              : direction[shares.front().element];
    }

  private:
    /// Returns the texture coordinates of a vertex with these parents in the first of `shares` in which the
    /// vertex lies, or `otherwise` if it lies in none.
    Eigen::Vector2d texture_at(const Mesh::Property_map<Face, FaceTexture>& texture, const Shares& shares,
                               const Parents& parents, const Eigen::Vector2d& otherwise) const {
        for (const auto& [face, share] : shares) {
            const FaceTexture& was = texture[face];
            if (const auto weights = corner_weights(old.at(face), parents))
                return (*weights)[0] * was[0] + (*weights)[1] * was[1] + (*weights)[2] * was[2];
        }
        return otherwise;
    }

    const Mesh& mesh;
    const std::map<Face, ReplacedFace>& old;
    std::map<Vertex, Parents> parents;  ///< parents of inserted and moved vertices
};

/// Sets the values `now`, all of which were computed from values before the change.
template <class Element, class Value>
void assign(Mesh::Property_map<Element, Value> values, const std::vector<std::pair<Element, Value>>& now) {
    for (const auto& [element, value] : now) values[element] = value;
}

template <class Value, Inherits rule>
void inherit(Mesh& mesh, const FaceInheritance& faces, const TopologyChange& change,
             const Attribute<Face, Value, rule>& attribute) {
    const auto [values, exists] = find_property(mesh, attribute);
    if (!exists) return;
    std::vector<std::pair<Face, Value>> now;
    for (const auto& [face, shares] : change.reshaped)
        if constexpr (rule == Inherits::mean)
            now.emplace_back(face, faces.mean(values, face, shares));
        else
            now.emplace_back(face, values[shares.front().element]);
    assign(values, now);
}

template <class Value, Inherits rule>
void inherit(Mesh& mesh, const FaceInheritance&, const TopologyChange& change,
             const Attribute<Vertex, Value, rule>& attribute) {
    const auto [values, exists] = find_property(mesh, attribute);
    if (!exists) return;
    std::vector<std::pair<Vertex, Value>> now;
    if constexpr (rule == Inherits::mean) {
        for (const auto* vertices : {&change.vertices, &change.moved})
            for (const WithParents<Vertex>& vertex : *vertices) {
                Mean<Value> mean;
                for (const auto& [parent, weight] : vertex.parents) mean.add(values[parent], weight);
                now.emplace_back(vertex.element, mean.value());
            }
    } else {
        for (const WithParents<Vertex>& vertex : change.vertices)
            now.emplace_back(vertex.element, missing<Value>());
    }
    assign(values, now);
}

}  // namespace

void copy_attributes(Mesh& mesh, Vertex vertex, Vertex copy) {
    visit_mesh_attributes(
        [&]<class Element, class Value, Inherits rule>(const Attribute<Element, Value, rule>& attribute) {
            if constexpr (std::same_as<Element, Vertex>)
                if (auto [values, exists] = find_property(mesh, attribute); exists)
                    values[copy] = values[vertex];
        });
}

void inherit_attributes(Mesh& mesh, const std::map<Face, ReplacedFace>& old, const TopologyChange& change) {
    const FaceInheritance faces(mesh, old, change);
    visit_mesh_attributes([&](const auto& attribute) { inherit(mesh, faces, change, attribute); });
}

}  // namespace sherd
