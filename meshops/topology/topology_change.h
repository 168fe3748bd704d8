// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshops/mesh.h"

namespace sherd {

/// An inserted element of a mesh, and its parents: the elements before the change whose data it inherits.
template <class Element>
struct WithParents {
    struct Parent {
        Element element;
        double weight;
    };
    Element element;
    /// Parents, whose weights sum to 1. A copy has one parent; an edge that is created inside a face has
    /// none.
    std::vector<Parent> parents;

    bool is_copy() const { return parents.size() == 1; }
    /// The parent of a copy.
    Element parent() const { return parents.front().element; }
};

/// Returns `created` as a copy of `parent`.
template <class Element>
WithParents<Element> copy_of(Element parent, Element created) {
    return {created, {{parent, 1}}};
}

/// A change of a mesh. Nothing is renumbered; new elements are appended in the order given here. Parents are
/// elements before the change, with the data that they had then.
struct TopologyChange {
    /// Two edges at the same place that replace an old edge whose two faces have been separated: `edge` is
    /// the old edge, which one of the faces keeps, and `created` the new edge of the other face.
    struct OpenedEdge {
        Edge edge, created;
    };
    /// A face, old or inserted, that now covers another part of the sheet, and its parents.
    struct Reshaped {
        Face face;
        /// Parents: old faces, each with the fraction of its area that has passed on to `face`, the largest
        /// fraction first. The fractions of an old face in all reshaped faces sum to 1.
        std::vector<WithParents<Face>::Parent> shares;
    };
    std::vector<WithParents<Vertex>> vertices;
    std::vector<WithParents<Edge>> edges;
    std::vector<WithParents<Face>> faces;
    std::vector<OpenedEdge> opened;  ///< each `created` is one of `edges`
    std::vector<Face> changed;       ///< old faces with a new corner, side or shape; ascending, each once
    /// Old vertices that have been moved on the sheet; ascending, each once.
    std::vector<WithParents<Vertex>> moved;
    std::vector<Edge> flipped;       ///< old edges that now join other vertices; ascending, each once
    std::vector<Reshaped> reshaped;  ///< ascending, each once
};

}  // namespace sherd
