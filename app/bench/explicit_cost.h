// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

namespace sherd {

/// What explicit steps cost, in processor time of one thread.
struct ExplicitCost {
    std::size_t faces = 0;
    double substeps = 0;  ///< in a step
    double step = 0;      ///< s, of computing, with all that is asked at its end; the least of some
    double gradient = 0;  ///< s, of the elastic energies, once; the least of some

    double face_steps() const {  ///< a second
        return static_cast<double>(faces) * substeps / step;
    }
};

/// Measures it on a disc of about 6,000 faces that falls on a steel nose, in steps of 2e-6 s; sheets do not
/// touch each other, and nothing breaks. model: see shell_variant().
ExplicitCost explicit_cost(const std::string& model);

}  // namespace sherd
