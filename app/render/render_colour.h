// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "fracture/snapshot.h"

namespace sherd {

/// What the colours of a picture tell.
enum class RenderColour { fragment, strain, speed, axis, none };

/// Throws Error (input) when there is no such name.
RenderColour parse_render_colour(const std::string& name);

/// A scalar that is drawn by a colour map, and its unit; empty when the colours tell something else.
struct RenderScalar {
    std::string name, unit;
    std::vector<double> values;  ///< [V]
};

/// strain: mean of |strain| of the unbroken hinges at a vertex (1/m); speed: m/s.
RenderScalar render_scalar(const Snapshot& frame, RenderColour colour);

/// 0xRRGGBB (sRGB) of a fragment: the palette of Okabe and Ito (2008), which colour-blind people can tell
/// apart, and lighter and darker ones from the eighth fragment on.
std::uint32_t fragment_colour(Index fragment);

/// 0xRRGGBB (sRGB) of the perceptually uniform map viridis (N. Smith, S. van der Walt, 2015) at x, 0 to 1,
/// cut off.
std::uint32_t map_colour(double x);

/// The value below which `share` (0 to 1) of the values are; 0 without any.
double quantile(std::vector<double> values, double share);

}  // namespace sherd
