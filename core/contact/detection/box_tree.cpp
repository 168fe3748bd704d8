// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/detection/box_tree.h"

#include <algorithm>
#include <numeric>

namespace sherd {
namespace {

/// Factor by which the looseness of a known division may grow before the boxes are divided again.
constexpr double loosest = 1.3;

/// Sum of the three edge lengths of all boxes, m, without empty boxes.
double total_size(const std::vector<Box>& boxes) {
    double sum = 0;
    for (const Box& box : boxes)
        if (box.lower[0] <= box.upper[0]) sum += (box.upper - box.lower).sum();
    return sum;
}

}  // namespace

BoxTree::BoxTree(const std::vector<Box>& boxes) : element(boxes.size()) {
    std::iota(element.begin(), element.end(), 0);
    if (element.empty()) return;
    divide(root(), boxes);
    for (const Index i : element) box.push_back(boxes[i]);
    surround(root());
}

BoxTree::BoxTree(const std::vector<Box>& boxes, Division& known) {
    if (known.element.size() == boxes.size() && !boxes.empty()) {
        element = known.element;
        for (const Index i : element) box.push_back(boxes[i]);
        surround(root());
        if (looseness() <= loosest * known.looseness) return;
    }
    *this = BoxTree(boxes);
    known = {element, looseness()};
}

double BoxTree::looseness() const {
    return total_size(around) / total_size(box);
}

void BoxTree::surround(const Node& node) {
    if (around.size() <= node.number) around.resize(node.number + 1);
    Box all;
    if (node.leaf()) {
        for (Index k = node.first; k < node.last; ++k) all.include(box[k]);
    } else {
        for (const Node& half : {node.left(), node.right()}) {
            surround(half);
            all.include(around[half.number]);
        }
    }
    around[node.number] = all;
}

void BoxTree::divide(const Node& node, const std::vector<Box>& boxes) {
    if (node.leaf()) return;
    Box centres;
    for (Index k = node.first; k < node.last; ++k) {
        const Box& one = boxes[element[k]];
        centres.include({one.lower + one.upper, one.lower + one.upper});
    }
    int axis;
    (centres.upper - centres.lower).maxCoeff(&axis);
    const auto before = [&](Index i, Index j) {
        const double a = boxes[i].lower[axis] + boxes[i].upper[axis];
        const double b = boxes[j].lower[axis] + boxes[j].upper[axis];
        return a < b || (a == b && i < j);
    };
    const auto begin = element.begin();
    std::nth_element(begin + node.first, begin + node.middle(), begin + node.last, before);
    divide(node.left(), boxes);
    divide(node.right(), boxes);
}

}  // namespace sherd
