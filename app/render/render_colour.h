// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "fracture/snapshot.h"

namespace sherd {

/// What the colours of a picture tell.
enum class RenderColour { fragment, strain, speed, stress, curvature, axis, tips, material, none };

/// Whether it shows numbers, by a colour map.
bool is_scalar(RenderColour colour);

/// Names that a command takes, in words: "strain, speed, stress or curvature".
std::string colour_names(std::span<const RenderColour> colours);

/// Throws Error (input), with the names of `colours`, when `name` is none of them.
RenderColour parse_render_colour(const std::string& name, std::span<const RenderColour> colours);

inline constexpr std::array render_colours{
    RenderColour::fragment, RenderColour::strain,    RenderColour::speed,
    RenderColour::stress,   RenderColour::curvature, RenderColour::axis,
    RenderColour::tips,     RenderColour::material,  RenderColour::none};
/// Those that a page can be asked for: its meshes may be thinned, to which no velocities belong.
inline constexpr std::array view_colours{RenderColour::strain, RenderColour::stress, RenderColour::curvature,
                                         RenderColour::material};
inline constexpr std::array scalar_colours{RenderColour::strain, RenderColour::speed, RenderColour::stress,
                                           RenderColour::curvature, RenderColour::tips};

/// A scalar that is drawn by a colour map, and its unit; empty when the colours tell something else.
struct RenderScalar {
    std::string name, unit;
    std::vector<double> values;  ///< [V]
};

/// strain: mean of |strain| of the unbroken hinges at a vertex (1/m); speed: m/s; means of the faces at a
/// vertex: stress, the largest principal stress of both surfaces (Pa), curvature, the largest magnitude of a
/// principal change of curvature (1/m). Throws Error (input) when the frame has no such field.
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
