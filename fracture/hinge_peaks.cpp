// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/hinge_peaks.h"

namespace sherd {
namespace {

constexpr VectorXd HingeMeasures::*all[] = {&HingeMeasures::bending, &HingeMeasures::strain,
                                            &HingeMeasures::stress};

}  // namespace

void HingePeaks::judge(const BreakableShell& shell, const HingeMeasures& measures) {
    // Edges that were appended are sides of cracks, which have no hinge.
    if (peaks.strain.size() == 0)
        for (VectorXd HingeMeasures::*member : all)
            peaks.*member = VectorXd::Zero(static_cast<Index>(shell.mesh().number_of_edges()));
    for (VectorXd HingeMeasures::*member : all) {
        (attempt.*member).setZero((peaks.*member).size());
        for (Index i = 0; i < static_cast<Index>((measures.*member).size()); ++i)
            (attempt.*member)[shell.edge_of_hinge(i)] = (measures.*member)[i];
    }
}

void HingePeaks::finish_step() {
    for (VectorXd HingeMeasures::*member : all) peaks.*member = (peaks.*member).cwiseMax(attempt.*member);
}

}  // namespace sherd
