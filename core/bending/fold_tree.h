// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/bending/patches.h"

namespace sherd {

/// A face and the triangles around it that some folds join, as a tree: each triangle hangs by one fold at one
/// nearer to the face, so that each fold can turn alone. Where the sheet closes around a vertex, a triangle
/// and its vertices are there more than once.
struct FoldTree {
    /// A vertex of the tree is that of a triangle of the shell.
    struct Corner {
        Index triangle;
        int corner;
    };
    /// Triangle 0 of the tree is the face, triangle i + 1 hangs by joint i.
    struct Joint {
        Index fold;
        int inner;  ///< triangle of the tree at which it hangs
        /// Vertices of the tree, in the order of a hinge whose T0 is the inner triangle.
        std::array<int, 4> vertices;
    };
    std::vector<Corner> corners;  ///< of each vertex; those of the face are first
    std::vector<Joint> joints;    ///< by distance from the face
};

/// The tree of a face with each of `folds`, which are edges with hinges, once. Folds that others of them do
/// not join to the face are missing.
FoldTree fold_tree(const Patches& patches, const Folds& all, Index face, std::span<const Index> folds);

}  // namespace sherd
