// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bending/fold_tree.h"

#include <algorithm>

namespace sherd {
namespace {

/// A triangle of the shell, and the vertices of the tree at its corners.
struct PlacedTriangle {
    Index triangle;
    std::array<int, 3> vertices;
};

/// Hangs the triangle across a side of triangle `inner` of the tree.
PlacedTriangle hang(const PlacedTriangle& at, int inner, int side,
                    const std::array<TriangleEdge, 2>& sides_of_fold, Index fold, FoldTree& tree) {
    const auto& [first, second] = sides_of_fold;
    const bool is_first = first.triangle == at.triangle && first.corner == side;
    const TriangleEdge& far = is_first ? second : first;
    const int from = at.vertices[(side + 1) % 3], to = at.vertices[(side + 2) % 3];
    const int apex = static_cast<int>(tree.corners.size());
    tree.corners.push_back({far.triangle, far.corner});
    tree.joints.push_back({fold, inner, {from, to, at.vertices[side], apex}});
    // The common edge runs the other way in the other triangle.
    PlacedTriangle outer{far.triangle, {}};
    outer.vertices[far.corner] = apex;
    outer.vertices[(far.corner + 1) % 3] = to;
    outer.vertices[(far.corner + 2) % 3] = from;
    return outer;
}

}  // namespace

FoldTree fold_tree(const Patches& patches, const Folds& all, Index face, std::span<const Index> folds) {
    FoldTree tree{{{face, 0}, {face, 1}, {face, 2}}, {}};
    std::vector<PlacedTriangle> placed{{face, {0, 1, 2}}};
    for (std::size_t inner = 0; inner < placed.size(); ++inner)
        for (int side = 0; side < 3; ++side) {
            const PlacedTriangle at = placed[inner];
            const Index fold = patches.fold_at(at.triangle, side);
            if (std::ranges::find(folds, fold) == folds.end() ||
                std::ranges::find(tree.joints, fold, &FoldTree::Joint::fold) != tree.joints.end())
                continue;
            const auto sides = *patches.sides_of(fold - all.folds_of_edges());
            placed.push_back(hang(at, static_cast<int>(inner), side, sides, fold, tree));
        }
    return tree;
}

}  // namespace sherd
