// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sherd {

/// Distribution of a parameter of a study.
struct Distribution {
    enum class Kind {
        uniform,      ///< from a to b
        log_uniform,  ///< from a to b, with a uniform logarithm
        normal,       ///< mean a, standard deviation b
        lognormal     ///< median a; b: standard deviation of the natural logarithm
    };
    Kind kind = Kind::uniform;
    double a = 0, b = 1;

    /// Returns the number below which a share of the distribution lies. share: between 0 and 1, both
    /// excluded.
    double quantile(double share) const;
};

}  // namespace sherd
