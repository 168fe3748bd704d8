// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/texels.h"

#include <cmath>

namespace sherd {
namespace {

/// The two texels beside a texture coordinate, and the weight of the second.
struct Neighbours {
    int low, high;
    double weight;
};

Neighbours neighbours(double coordinate, int count) {
    const double at = (coordinate - std::floor(coordinate)) * count - 0.5, low = std::floor(at);
    const auto wrapped = [count](double index) { return (static_cast<int>(index) + count) % count; };
    return {wrapped(low), wrapped(low + 1), at - low};
}

}  // namespace

std::array<WeightedColour, 4> texels_around(const Image& image, const Eigen::Vector2d& uv) {
    const Neighbours x = neighbours(uv.x(), image.width), y = neighbours(uv.y(), image.height);
    const auto texel = [&](int column, int row) { return image.colour(column, image.height - 1 - row); };
    return {{{texel(x.low, y.low), (1 - x.weight) * (1 - y.weight)},
             {texel(x.high, y.low), x.weight * (1 - y.weight)},
             {texel(x.low, y.high), (1 - x.weight) * y.weight},
             {texel(x.high, y.high), x.weight * y.weight}}};
}

}  // namespace sherd
