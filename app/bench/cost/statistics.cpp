// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/cost/statistics.h"

#include <algorithm>
#include <cmath>

namespace sherd {

double median(std::vector<double> numbers) {
    std::ranges::sort(numbers);
    const std::size_t half = numbers.size() / 2;
    return numbers.size() % 2 == 1 ? numbers[half] : (numbers[half - 1] + numbers[half]) / 2;
}

double fitted_exponent(std::span<const Vector2d> points) {
    Vector2d mean = Vector2d::Zero();
    for (const Vector2d& point : points)
        mean += point.array().log().matrix() / static_cast<double>(points.size());
    double square = 0, product = 0;
    for (const Vector2d& point : points) {
        const Vector2d off = point.array().log().matrix() - mean;
        square += off.x() * off.x();
        product += off.x() * off.y();
    }
    return product / square;
}

}  // namespace sherd
