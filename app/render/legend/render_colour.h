// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "fracture/record/snapshot.h"

namespace sherd {

/// Quantity that the colours of a picture show.
enum class RenderColour { fragment, strain, speed, stress, curvature, axis, tips, material, none };

/// Whether the colours show a scalar, by a colour map.
bool is_scalar(RenderColour colour);

/// Names of colourings as text: "strain, speed, stress or curvature".
std::string colour_names(std::span<const RenderColour> colours);

/// Returns the colouring of this name. Throws Error (input), with the names of `colours`, if `name` is none
/// of them.
RenderColour parse_render_colour(const std::string& name, std::span<const RenderColour> colours);

inline constexpr std::array render_colours{
    RenderColour::fragment, RenderColour::strain,    RenderColour::speed,
    RenderColour::stress,   RenderColour::curvature, RenderColour::axis,
    RenderColour::tips,     RenderColour::material,  RenderColour::none};
/// Colourings of a page, whose meshes may be thinned and then have no velocities.
inline constexpr std::array view_colours{RenderColour::strain, RenderColour::stress, RenderColour::curvature,
                                         RenderColour::material};
inline constexpr std::array scalar_colours{RenderColour::strain, RenderColour::speed, RenderColour::stress,
                                           RenderColour::curvature, RenderColour::tips};

/// A scalar that is drawn by a colour map, and its unit; empty for other colourings.
struct RenderScalar {
    std::string name, unit;
    std::vector<double> values;  ///< [V]
};

/// strain: mean of |strain| of the interior hinges at a vertex (1/m); speed: m/s; means of the faces at a
/// vertex: stress, the largest principal stress of both surfaces (Pa), curvature, the largest magnitude of a
/// principal change of curvature (1/m). Throws Error (input) when the frame has no such field.
RenderScalar render_scalar(const Snapshot& frame, RenderColour colour);

/// 0xRRGGBB (sRGB) of a fragment: the palette of Okabe and Ito (2008), which colour-blind people can tell
/// apart, and lighter and darker ones from the eighth fragment on.
std::uint32_t fragment_colour(Index fragment);

/// 0xRRGGBB (sRGB) of the perceptually uniform map viridis (N. Smith, S. van der Walt, 2015) at x, clamped to
/// 0 to 1.
std::uint32_t map_colour(double x);

/// Value below which `share` (0 to 1) of the values lie; 0 without any.
double quantile(std::vector<double> values, double share);

}  // namespace sherd
