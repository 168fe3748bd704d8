// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/detection/box_tree.h"

#include <algorithm>
#include <numeric>

namespace sherd {

BoxTree::BoxTree(const std::vector<Box>& boxes) : element(boxes.size()) {
    std::iota(element.begin(), element.end(), 0);
    if (!element.empty()) build(root(), boxes);
    for (const Index i : element) box.push_back(boxes[i]);
}

void BoxTree::build(const Node& node, const std::vector<Box>& boxes) {
    Box all, centres;
    const auto centre = [&](Index i) { return Eigen::Array3d(boxes[i].lower + boxes[i].upper); };
    for (Index k = node.first; k < node.last; ++k) {
        all.include(boxes[element[k]]);
        centres.include({centre(element[k]), centre(element[k])});
    }
    if (around.size() <= node.number) around.resize(node.number + 1);
    around[node.number] = all;
    if (node.leaf()) return;
    int axis;
    (centres.upper - centres.lower).maxCoeff(&axis);
    const auto before = [&](Index i, Index j) {
        const double a = boxes[i].lower[axis] + boxes[i].upper[axis];
        const double b = boxes[j].lower[axis] + boxes[j].upper[axis];
        return a < b || (a == b && i < j);
    };
    const auto begin = element.begin();
    std::nth_element(begin + node.first, begin + node.middle(), begin + node.last, before);
    build(node.left(), boxes);
    build(node.right(), boxes);
}

}  // namespace sherd
