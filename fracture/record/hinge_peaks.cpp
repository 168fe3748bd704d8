// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/record/hinge_peaks.h"

#include <algorithm>

namespace sherd {
namespace {

constexpr VectorXd HingeMeasures::*all[] = {&HingeMeasures::bending, &HingeMeasures::strain,
                                            &HingeMeasures::stress};

}  // namespace

void HingePeaks::record(const BreakableShell& shell, const HingeMeasures& measures) {
    // The list ends with the last edge that has a hinge, since most appended edges are on crack faces, where
    // there are no hinges.
    Eigen::Index edges = peaks.strain.size();
    if (edges == 0) edges = static_cast<Eigen::Index>(shell.mesh().number_of_edges());
    for (const Index edge : shell.mechanics().hinge_edge) edges = std::max<Eigen::Index>(edges, edge + 1);
    for (VectorXd HingeMeasures::*member : all) {
        (peaks.*member).conservativeResizeLike(VectorXd::Zero(edges));
        (attempt.*member).setZero((peaks.*member).size());
        for (Index i = 0; i < static_cast<Index>((measures.*member).size()); ++i)
            (attempt.*member)[shell.edge_of_hinge(i)] = (measures.*member)[i];
    }
}

void HingePeaks::finish_step() {
    for (VectorXd HingeMeasures::*member : all) peaks.*member = (peaks.*member).cwiseMax(attempt.*member);
}

}  // namespace sherd
