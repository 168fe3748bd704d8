// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/fracture/fracture_case.h"

namespace sherd {

std::vector<FractureCase> fracture_cases() {
    std::vector<FractureCase> all = centre_cracks();
    for (FractureCase& one :
         std::array{edge_notch(), bent_plate(), double_cantilever(), offset_hole(), branching()})
        all.push_back(std::move(one));
    for (FractureCase& one : released_strips()) all.push_back(std::move(one));
    return all;
}

}  // namespace sherd
