// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "core/vector.h"

namespace sherd {

/// An axis-aligned box, m; empty by default.
struct Box {
    Eigen::Array3d lower = Eigen::Array3d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Array3d upper = Eigen::Array3d::Constant(-std::numeric_limits<double>::infinity());

    void include(const Box& other) {
        lower = lower.min(other.lower);
        upper = upper.max(other.upper);
    }
    /// Whether the boxes have a point in common, their boundaries included.
    bool meets(const Box& other) const {
        return lower[0] <= other.upper[0] && other.lower[0] <= upper[0] && lower[1] <= other.upper[1] &&
               other.lower[1] <= upper[1] && lower[2] <= other.upper[2] && other.lower[2] <= upper[2];
    }
};

/// Returns the bounding boxes of elements, which are given by the numbers of their vertices. of_vertices:
/// boxes of the vertices.
template <std::size_t N>
std::vector<Box> element_boxes(const std::vector<Box>& of_vertices,
                               const std::vector<std::array<Index, N>>& elements) {
    std::vector<Box> boxes(elements.size());
    for (std::size_t i = 0; i < elements.size(); ++i)
        for (const Index vertex : elements[i]) boxes[i].include(of_vertices[vertex]);
    return boxes;
}

/// A balanced binary tree of bounding boxes, which finds the pairs of boxes that overlap: the boxes of this
/// tree with the boxes of another tree, or with each other. Each node is divided at the median of its boxes'
/// centres, along the axis on which the centres extend farthest.
class BoxTree {
  public:
    /// Division of a tree's boxes into nodes, to be reused for a later tree of the same boxes at other
    /// places.
    struct Division {
        std::vector<Index> element;  ///< numbers of the boxes, in the tree's order
        double looseness = 0;        ///< looseness() when the boxes were divided
    };

    explicit BoxTree(const std::vector<Box>& boxes);
    /// Reuses the division `known`. Makes a new division, and stores it in `known`, if the known one has
    /// another number of boxes or has become too loose. Dividing is most of the cost of a tree. The set of
    /// overlapping pairs does not depend on the division.
    BoxTree(const std::vector<Box>& boxes, Division& known);

    /// The bounding box of all boxes.
    Box bounds() const { return around.empty() ? Box{} : around[0]; }
    /// The numbers of the boxes, in an order in which boxes near each other in space are close together.
    const std::vector<Index>& order() const { return element; }

    /// Calls visit(i, j) once for every box i of this tree and every box j of `other` that overlap, in an
    /// order that depends only on the boxes and the divisions.
    template <class Visit>
    void meet(const BoxTree& other, const Visit& visit) const {
        if (!element.empty() && !other.element.empty()) descend(other, root(), other.root(), visit);
    }
    /// Calls visit(i, j) once for every two different boxes of this tree that overlap; i may be the smaller
    /// or the larger number.
    template <class Visit>
    void meet_itself(const Visit& visit) const {
        if (!element.empty()) descend_itself(root(), visit);
    }

  private:
    /// A node of the tree. Node number n has the children 2 n + 1 and 2 n + 2, and contains the boxes `first`
    /// to `last` - 1 of the tree's order.
    struct Node {
        std::size_t number;
        Index first, last;

        bool leaf() const { return last - first <= leaf_size; }
        Index middle() const { return first + (last - first) / 2; }
        Node left() const { return {2 * number + 1, first, middle()}; }
        Node right() const { return {2 * number + 2, middle(), last}; }
    };
    static constexpr Index leaf_size = 4;

    Node root() const { return {0, 0, static_cast<Index>(element.size())}; }
    /// Orders the part of `element` that belongs to a node, so that each child of the node, and of all nodes
    /// below, gets one half of the boxes, separated in space.
    void divide(const Node& node, const std::vector<Box>& boxes);
    /// Finds the bounding boxes of a node and of all nodes below it.
    void surround(const Node& node);
    /// Total size of the nodes' bounding boxes over the total size of the boxes: the larger this ratio, the
    /// more nodes are visited in vain.
    double looseness() const;

    template <class Visit>
    void descend(const BoxTree& other, const Node& a, const Node& b, const Visit& visit) const {
        if (!around[a.number].meets(other.around[b.number])) return;
        if (a.leaf() && b.leaf()) {
            for (Index i = a.first; i < a.last; ++i)
                for (Index j = b.first; j < b.last; ++j)
                    if (box[i].meets(other.box[j])) visit(element[i], other.element[j]);
        } else if (b.leaf() || (!a.leaf() && a.last - a.first >= b.last - b.first)) {
            descend(other, a.left(), b, visit);
            descend(other, a.right(), b, visit);
        } else {
            descend(other, a, b.left(), visit);
            descend(other, a, b.right(), visit);
        }
    }
    template <class Visit>
    void descend_itself(const Node& node, const Visit& visit) const {
        if (!node.leaf()) {
            descend_itself(node.left(), visit);
            descend_itself(node.right(), visit);
            return descend(*this, node.left(), node.right(), visit);
        }
        for (Index i = node.first; i < node.last; ++i)
            for (Index j = node.first; j < i; ++j)
                if (box[i].meets(box[j])) visit(element[i], element[j]);
    }

    std::vector<Box> around;     ///< bounding box of each node
    std::vector<Box> box;        ///< the boxes, in the tree's order
    std::vector<Index> element;  ///< numbers of the boxes, in the tree's order
};

}  // namespace sherd
