// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/study/distribution.h"

#include <boost/math/distributions/normal.hpp>
#include <cmath>

namespace sherd {

double Distribution::quantile(double share) const {
    const auto normal_quantile = [&] {
        return boost::math::quantile(boost::math::normal_distribution(), share);
    };
    switch (kind) {
        case Kind::uniform:
            return a + share * (b - a);
        case Kind::log_uniform:
            return a * std::pow(b / a, share);
        case Kind::normal:
            return a + b * normal_quantile();
        case Kind::lognormal:
            return a * std::exp(b * normal_quantile());
    }
    return a;
}

}  // namespace sherd
