// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "meshops/mesh.h"

namespace sherd {

/// An element of a mesh that a change made, and those of its kind from before whose data it takes over.
template <class Element>
struct Born {
    struct Parent {
        Element element;
        double weight;
    };
    Element element;
    /// Weights sum to 1. A copy has one parent; an edge that was born inside a face has none.
    std::vector<Parent> parents;

    bool is_copy() const { return parents.size() == 1; }
    /// The parent of a copy.
    Element parent() const { return parents.front().element; }
};

/// `created` is a copy of `parent`.
template <class Element>
Born<Element> copy_of(Element parent, Element created) {
    return {created, {{parent, 1}}};
}

/// What a change made of a mesh. Nothing is renumbered: what was born is appended, in this order.
struct TopologyChange {
    /// An edge that lies where another one does, since the faces on its two sides have come apart: `edge`
    /// stays with one of them, `created` is the other's.
    struct OpenedEdge {
        Edge edge, created;
    };
    std::vector<Born<Vertex>> vertices;
    std::vector<Born<Edge>> edges;
    std::vector<Born<Face>> faces;
    std::vector<OpenedEdge> opened;  ///< each `created` is one of `edges`
    std::vector<Face> changed;  ///< from before, with a corner or a side that was born; ascending, each once
};

}  // namespace sherd
