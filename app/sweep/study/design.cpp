// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/study/design.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "meshops/random.h"

namespace sherd {
namespace {

using Points = std::vector<std::vector<std::string>>;

Points grid_points(const Study& study) {
    std::size_t count = 1;
    for (const StudyParameter& parameter : study.parameters) count *= parameter.values.size();
    Points points(count);
    for (std::size_t i = 0; i < count; ++i) {
        std::size_t rest = i, block = count;
        for (const StudyParameter& parameter : study.parameters) {
            block /= parameter.values.size();
            points[i].push_back(parameter.values[rest / block]);
            rest %= block;
        }
    }
    return points;
}

Points zip_points(const Study& study) {
    Points points(study.parameters.empty() ? 1 : study.parameters[0].values.size());
    for (const StudyParameter& parameter : study.parameters)
        for (std::size_t i = 0; i < points.size(); ++i) points[i].push_back(parameter.values[i]);
    return points;
}

std::vector<std::size_t> shuffled(std::size_t count, Random& random) {
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t i = count; i > 1; --i)
        std::swap(order[i - 1], order[static_cast<std::size_t>(random.uniform() * static_cast<double>(i))]);
    return order;
}

/// Returns the value of a parameter at a share of its distribution, or of its list, whose values have equal
/// shares.
std::string value_at(const StudyParameter& parameter, double share) {
    if (parameter.drawn) return fmt::format("{:.12g}", parameter.drawn->quantile(share));
    const auto count = static_cast<double>(parameter.values.size());
    return parameter.values[static_cast<std::size_t>(share * count)];
}

Points drawn_points(const Study& study) {
    Random random(static_cast<unsigned>(study.seed));
    const auto count = static_cast<std::size_t>(study.samples);
    Points points(count);
    for (const StudyParameter& parameter : study.parameters) {
        std::vector<std::size_t> strata;
        if (study.design == Design::latin) strata = shuffled(count, random);
        for (std::size_t i = 0; i < count; ++i) {
            const double within = random.uniform();
            const double share = strata.empty()
                                     ? within
                                     : (static_cast<double>(strata[i]) + within) / static_cast<double>(count);
            // The shares 0 and 1 are excluded, since the ends of a normal distribution are infinite.
            points[i].push_back(value_at(parameter, std::clamp(share, 0x1p-53, 1 - 0x1p-53)));
        }
    }
    return points;
}

}  // namespace

std::vector<std::vector<std::string>> design_points(const Study& study) {
    if (study.design == Design::grid) return grid_points(study);
    if (study.design == Design::zip) return zip_points(study);
    return drawn_points(study);
}

}  // namespace sherd
