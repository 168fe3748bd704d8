// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace sherd {

/// Red, green, blue and opacity, as files have them.
using Colour = std::array<std::uint8_t, 4>;
inline constexpr Colour white{255, 255, 255, 255};

namespace property {
inline constexpr const char* vertex_colour = "v:colour";  ///< Colour of each vertex (PLY)
inline constexpr const char* face_colour = "f:colour";    ///< Colour of each face (PLY)
}  // namespace property

/// A mean of colours.
class ColourMean {
  public:
    void add(const Colour& colour, double weight) {
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += weight * colour[i];
    }
    /// Mean of the colours, rounded; the weights must sum to 1.
    Colour colour() const;

  private:
    std::array<double, 4> sum{};
};

}  // namespace sherd
