// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/table/bootstrap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "meshops/random.h"

namespace sherd {
namespace {

constexpr std::size_t resamples = 2000;
constexpr double tail = 0.025;

double mean_of(std::span<const double> values) {
    return std::accumulate(values.begin(), values.end(), 0.) / static_cast<double>(values.size());
}

}  // namespace

MeanEstimate estimated_mean(std::span<const double> all) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> values;
    std::ranges::copy_if(all, std::back_inserter(values), [](double value) { return std::isfinite(value); });
    if (values.empty()) return {0, none, none, none};
    const double mean = mean_of(values);
    if (values.size() == 1) return {1, mean, none, none};
    Random random(1);
    std::vector<double> means, sample(values.size());
    for (std::size_t i = 0; i < resamples; ++i) {
        for (double& value : sample)
            value = values[static_cast<std::size_t>(random.uniform() * static_cast<double>(values.size()))];
        means.push_back(mean_of(sample));
    }
    std::ranges::sort(means);
    const auto at = [&](double share) {
        return means[static_cast<std::size_t>(std::lround(share * static_cast<double>(resamples - 1)))];
    };
    return {values.size(), mean, at(tail), at(1 - tail)};
}

}  // namespace sherd
